// SPDX-License-Identifier: MIT
// predicates.hpp - exact signs for points in doubles: on which side of a plane a point lies. For
// rational points the sign is that of halfspace(point).
#pragma once

#include "convexact/halfspace.hpp"
#include "convexact/number.hpp"
#include "convexact/point_set.hpp"

namespace convexact {

/// The sign of det[a-d; b-d; c-d], exactly, for all finite doubles. With a, b, c counter-clockwise
/// seen from +z and d far up +z it is Negative: orient3d((0,0,0), (1,0,0), (0,1,0), (0,0,1)) is the
/// sign of det[(0,0,-1); (1,0,-1); (0,1,-1)] = -1. Most callers want is_beyond().
/// @par Cost    About 30 flops when the points are far from coplanar, else up to some microseconds.
/// @par Source  [Shewchuk1997]
[[nodiscard]] Sign orient3d(const Point& a, const Point& b, const Point& c, const Point& d);

/// Whether p lies strictly beyond the plane through a, b, c, which look counter-clockwise from
/// beyond: orient3d(a, b, c, p) < 0.
[[nodiscard]] inline bool is_beyond(const Point& a, const Point& b, const Point& c,
                                    const Point& p) {
  return orient3d(a, b, c, p) == Sign::Negative;
}

/// The sign of n.x + d: Negative strictly inside, Zero on the plane. x is finite.
/// @par Cost  Three products of integers; no fractions, which take several times as long.
[[nodiscard]] Sign side_of(const Halfspace& halfspace, const Point& x);

}  // namespace convexact
