// SPDX-License-Identifier: MIT
// summary.hpp - what a run found, for people.
#pragma once
#include <string>

#include "convexact/simplify.hpp"

namespace convexact {

/// A few lines: what was found, how tight it is, what was verified, how far it was pushed.
[[nodiscard]] std::string summary(const SimplifyResult& result);
/// Counts, box, and each measure with `digits` certain digits.
[[nodiscard]] std::string summary(const HullResult& result, int digits);

/// One line: the time of all stages, the longest of them, and how many were not needed. Or a table
/// of all stages, those that were not needed with their reasons.
[[nodiscard]] std::string stage_text(const std::vector<Stage>& stages, bool list_all);

}  // namespace convexact
