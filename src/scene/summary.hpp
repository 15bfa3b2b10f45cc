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

/// A table of the stages with their times, then the stages that were not needed and why.
[[nodiscard]] std::string stage_table(const std::vector<Stage>& stages);

}  // namespace convexact
