// SPDX-License-Identifier: MIT
// predicates.hpp - exact signs: on which side of a plane a point lies.
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

/// The stage that decided a sign: A doubles; B the rounded differences, exactly; C these and a
/// correction; D all terms exactly; Rationals if a coordinate is outside [2^-306, 2^338].
enum class Orient3dStage { A, B, C, D, Rationals };
struct StagedSign {
  Sign sign;
  Orient3dStage stage;
};

/// orient3d() with the stage that was reached, for tests and measurements.
[[nodiscard]] StagedSign orient3d_staged(const Point& a, const Point& b, const Point& c,
                                         const Point& d);

/// What the stages A to C compute before they decide, and how far it may be from the truth T, for
/// tests of the bounds: |value_a - T| <= bound_a, |B - T| <= bound_b for the determinant B of the
/// rounded differences, |value_c - T| <= bound_c.
struct Orient3dBounds {
  double value_a, bound_a, bound_b, value_c, bound_c;
};

/// Precondition: coordinates are in the range that orient3d() has without rationals.
[[nodiscard]] Orient3dBounds orient3d_bounds(const Point& a, const Point& b, const Point& c,
                                             const Point& d);

/// The sign of n.x + d: Negative strictly inside, Zero on the plane. x is finite.
/// @par Cost  Three products of integers; no fractions, which take several times as long.
[[nodiscard]] Sign side_of(const Halfspace& halfspace, const Point& x);

}  // namespace convexact
