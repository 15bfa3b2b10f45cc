// SPDX-License-Identifier: MIT
// balanced_sum.hpp - exact sums of many rationals.
#pragma once
#include <vector>

#include "convexact/number.hpp"

namespace convexact {

/// The exact sum of n terms; 0 for none. Terms are added in pairs, the sums in pairs again, and so
/// on: the bits of the denominators pile up only towards the end. From left to right they would
/// make every addition as long as the last one.
/// @par Cost  O(log n) times that of the last addition when denominators have little in common.
[[nodiscard]] Rational balanced_sum(std::vector<Rational> terms);

}  // namespace convexact
