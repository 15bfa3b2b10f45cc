// SPDX-License-Identifier: MIT
// hull_volume.hpp - exact volume of a hull straight from its input points.
#pragma once
#include "convexact/hull/hull.hpp"

namespace convexact {

/// Exact volume of a hull, in cubed length units. Points that are doubles are integers times a
/// common power of two, so the sum over the facets needs no fraction until the end.
/// @par Cost  O(corners) products of integers as long as the spread of the coordinates.
[[nodiscard]] Rational volume(const Hull& hull, const PointSet& points);

}  // namespace convexact
