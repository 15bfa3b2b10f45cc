// SPDX-License-Identifier: MIT
// support.hpp - support function of a finite point set.
#pragma once
#include "convexact/point_set.hpp"

namespace convexact {

/// Where a linear functional is largest on a point set.
struct Support {
  PointId point;   ///< The lowest id on a tie.
  Rational value;  ///< Exact maximum of dot(direction, p).
};

/// Support function h(u) = max over p of dot(u, p).
/// @param points     n >= 1 points in the caller's length unit L; repeats allowed.
/// @param direction  Nonzero; not normalised, so `value` is in |direction| * L.
/// @throws Error     InvalidArgument if n == 0 or the direction is zero.
/// @par Cost         n exact dot products, no division.
/// @par Source       [Schneider2014, sec. 1.7]
[[nodiscard]] Support support(const PointSet& points, const RationalVector3& direction);

}  // namespace convexact
