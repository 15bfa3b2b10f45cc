// SPDX-License-Identifier: MIT
#include "convexact/geometry/orient3d.hpp"

namespace convexact {

Sign orient3d(const Point& a, const Point& b, const Point& c, const Point& d) {
  const RationalPoint q = to_rational(d);
  const RationalVector3 u = to_rational(a) - q, v = to_rational(b) - q, w = to_rational(c) - q;
  const RationalVector3 cross = v.cross(w);
  return sign_of(Rational(u.dot(cross)));
}

}  // namespace convexact
