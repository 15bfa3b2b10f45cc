// SPDX-License-Identifier: MIT
// combination.hpp - a vector as a combination of independent vectors, in rationals.
#pragma once
#include <vector>

#include "convexact/number.hpp"

namespace convexact::detail {

/// The factors y with target = sum of y_i basis[i]; m independent vectors of length k >= m, and a
/// target that they span. O(k m^2) operations.
std::vector<Rational> combination(const std::vector<RationalVector>& basis,
                                  const RationalVector& target);

}  // namespace convexact::detail
