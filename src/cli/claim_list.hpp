// SPDX-License-Identifier: MIT
// claim_list.hpp - the value of --claims.
#pragma once
#include <string>
#include <vector>

#include "convexact/oracle/claim.hpp"

namespace convexact::cli {

/// Names of claims, separated by commas; none for an empty text, which means all.
/// @throws Error InvalidArgument, listing the names, for any other word.
[[nodiscard]] std::vector<ClaimCode> parse_claims(const std::string& text);

}  // namespace convexact::cli
