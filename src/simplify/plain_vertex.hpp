// SPDX-License-Identifier: MIT
// plain_vertex.hpp - the arithmetic that only the verifier uses: determinants of the planes as
// given.
#pragma once
#include "convexact/geometry.hpp"

namespace convexact {

/// Where three planes meet, x / d with d = det(n_a, n_b, n_c); no point if d = 0.
struct PlainVertex {
  IntegerVector3 x;
  Integer d;
};

[[nodiscard]] PlainVertex plain_vertex(const Halfspace& a, const Halfspace& b, const Halfspace& c);
/// The same for a point given as rationals; d > 0.
[[nodiscard]] PlainVertex plain_vertex(const RationalPoint& point);
/// d times the value n.x + d_h of the halfspace at the vertex. For the vertex of planes a, b, c it
/// is H(a, b, c, h), the determinant of the four rows (n, d).
[[nodiscard]] Integer value_at(const PlainVertex& vertex, const Halfspace& halfspace);

}  // namespace convexact
