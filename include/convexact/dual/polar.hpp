// SPDX-License-Identifier: MIT
// polar.hpp - polar duality about a center: halfspaces to points and planes to vertices, and back.
#pragma once
#include "convexact/geometry/halfspace.hpp"
#include "convexact/hull/homogeneous_point.hpp"
#include "convexact/number/rational.hpp"

namespace convexact {

/// The point n / w of dual space, in primitive integers; w > 0.
using DualPoint = HomogeneousPoint;

/// The plane {p : dot(x, p) = d} of dual space in primitive integers, x nonzero. With d > 0 it is
/// the polar of the primal vertex center + x / d and the origin lies below it; with d <= 0 it
/// corresponds to no vertex: the three halfspaces through it leave a gap to infinity.
struct DualPlane {
  IntegerVector3 x;
  Integer d;
};

/// Halfspace {x : n.x + d <= 0} to its dual point (n : w), w = -(n.center + d).
/// @throws Error InvalidArgument unless the center is strictly inside.
[[nodiscard]] DualPoint polar(const Halfspace& halfspace, const RationalPoint& center);
/// The way back: the polar of the polar is the halfspace itself.
[[nodiscard]] Halfspace polar(const DualPoint& point, const RationalPoint& center);

/// Dual plane to the vertex center + x / d. Precondition: d > 0.
[[nodiscard]] RationalPoint polar(const DualPlane& plane, const RationalPoint& center);
/// The way back. @throws Error InvalidArgument if the vertex is the center.
[[nodiscard]] DualPlane polar(const RationalPoint& vertex, const RationalPoint& center);

/// The plane through three dual points, counter-clockwise from outside: d has the sign of
/// det(n_a, n_b, n_c). For the dual points (1,0,0), (0,1,0), (0,0,1), w = 1, it is x = (1,1,1),
/// d = 1, the polar of the cube corner (1,1,1). Precondition: the points are not collinear.
[[nodiscard]] DualPlane plane_through(const DualPoint& a, const DualPoint& b, const DualPoint& c);

/// dot(x, n) - d w: positive iff the dual point lies strictly beyond the plane, that is, iff the
/// halfspace cuts the vertex off. Up to a positive factor the determinant H of the four rows (n, d)
/// of the planes concerned, hence independent of the center.
/// For the plane above, (1,1,1 : 2) gives 3 - 2 = 1: x + y + z <= 2 cuts (1,1,1) off.
[[nodiscard]] Integer height(const DualPlane& plane, const DualPoint& point);
[[nodiscard]] inline bool is_beyond(const DualPoint& point, const DualPlane& plane) {
  return height(plane, point) > 0;
}

}  // namespace convexact
