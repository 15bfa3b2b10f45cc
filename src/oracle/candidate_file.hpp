// SPDX-License-Identifier: MIT
// candidate_file.hpp - reads the output of a program as a candidate for the oracle, with any
// content.
#pragma once
#include <string>
#include <string_view>

#include "convexact/number.hpp"
#include "convexact/verify.hpp"

namespace convexact {

/// A mesh or halfspaces: by the extension of `path` if it is a known one, otherwise by content. An
/// error in the bytes becomes the candidate's error.
[[nodiscard]] Candidate read_candidate_bytes(std::string_view bytes, const std::string& path,
                                             Decimal decimal = Decimal::Nearest);

/// The candidate in a file; "-" is standard input.
/// @throws Error Unreadable if there is no such file, as read_bytes.
[[nodiscard]] Candidate read_candidate(const std::string& path, Decimal decimal = Decimal::Nearest);

}  // namespace convexact
