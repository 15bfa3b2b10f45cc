// SPDX-License-Identifier: MIT
// claim_list.hpp - the value of --claims.
#pragma once
#include <string>
#include <vector>

#include "convexact/verify.hpp"

namespace convexact::cli {

/// Names of claims, separated by commas.
/// @throws Error InvalidArgument, listing the names, for any other word, also an empty one.
[[nodiscard]] std::vector<ClaimCode> parse_claims(const std::string& text);

}  // namespace convexact::cli
