// SPDX-License-Identifier: MIT
// verdict_table.hpp - verdicts of the oracle as a table for people.
#pragma once
#include <string>

#include "convexact/verify.hpp"

namespace convexact {

/// A line for each claim that was asked, then how tight the candidate is, then the verdict.
[[nodiscard]] std::string verdict_table(const Verdict& verdict);

}  // namespace convexact
