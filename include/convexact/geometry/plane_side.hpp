// SPDX-License-Identifier: MIT
// plane_side.hpp - on which side of an exact plane a point in doubles lies.
#pragma once
#include "convexact/geometry/halfspace.hpp"

namespace convexact {

/// The sign of n.x + d: Negative strictly inside, Zero on the plane. x is finite.
/// @par Cost  Three products of integers; no fractions, which take several times as long.
[[nodiscard]] Sign side_of(const Halfspace& halfspace, const Point& x);

}  // namespace convexact
