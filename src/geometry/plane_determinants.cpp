// SPDX-License-Identifier: MIT
#include "geometry/plane_determinants.hpp"

#include "number/arithmetic.hpp"

namespace convexact {

Integer normal_determinant(const Halfspace& a, const Halfspace& b, const Halfspace& c) {
  const IntegerVector3 bc = b.normal().cross(c.normal());
  return dot(a.normal(), bc);
}

Integer plane_determinant(const Halfspace& a, const Halfspace& b, const Halfspace& c,
                          const Halfspace& p) {
  // Laplace expansion along the first two rows: 2x2 minors of (a, b) with those of (c, p).
  const IntegerVector3 ab = a.normal().cross(b.normal()), cp = c.normal().cross(p.normal());
  IntegerVector3 ab_d, cp_d;
  for (int k = 0; k < 3; ++k) {
    ab_d[k] = a.normal()[k] * b.offset() - b.normal()[k] * a.offset();
    cp_d[k] = c.normal()[k] * p.offset() - p.normal()[k] * c.offset();
  }
  return dot(ab, cp_d) + dot(ab_d, cp);
}

}  // namespace convexact
