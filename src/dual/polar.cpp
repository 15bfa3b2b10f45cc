// SPDX-License-Identifier: MIT
#include "convexact/dual.hpp"
#include "convexact/error.hpp"
#include "number/arithmetic.hpp"

namespace convexact {
namespace {

// The primitive integer vector that points where (v, w) does.
template <class Result>
Result primitive(const RationalVector3& v, const Rational& w) {
  auto [x, d] = clear_denominators(v, w);
  make_primitive(x, d);
  return {std::move(x), std::move(d)};
}

RationalVector3 rationals(const IntegerVector3& v) {
  return {Rational(v[0]), Rational(v[1]), Rational(v[2])};
}

}  // namespace

DualPoint polar(const Halfspace& halfspace, const RationalPoint& center) {
  const Rational w = -halfspace(center);
  if (w <= 0) {
    throw Error(ErrorCode::InvalidArgument, "the center is not strictly inside every halfspace");
  }
  return primitive<DualPoint>(rationals(halfspace.normal()), w);
}

Halfspace polar(const DualPoint& point, const RationalPoint& center) {
  const RationalVector3 n = rationals(point.n);
  return {n, Rational(-(Rational(point.w) + n.dot(center)))};
}

RationalPoint polar(const DualPlane& plane, const RationalPoint& center) {
  RationalPoint vertex;
  for (int k = 0; k < 3; ++k) vertex[k] = center[k] + Rational(plane.x[k], plane.d);
  return vertex;
}

DualPlane polar(const RationalPoint& vertex, const RationalPoint& center) {
  const RationalVector3 x = vertex - center;
  if (x == RationalVector3::Zero()) {
    throw Error(ErrorCode::InvalidArgument, "the center has no polar plane");
  }
  return primitive<DualPlane>(x, Rational(1));
}

DualPlane plane_through(const DualPoint& a, const DualPoint& b, const DualPoint& c) {
  // Cramer's rule for n_a.y = w_a, n_b.y = w_b, n_c.y = w_c with y = x / d.
  const IntegerVector3 bc = b.n.cross(c.n), ca = c.n.cross(a.n), ab = a.n.cross(b.n);
  DualPlane plane;
  for (int k = 0; k < 3; ++k) {
    mpz_mul(raw(plane.x[k]), raw(a.w), raw(bc[k]));
    add_product(plane.x[k], b.w, ca[k]);
    add_product(plane.x[k], c.w, ab[k]);
  }
  plane.d = dot(a.n, bc);
  // Dividing once here halves the length of all that follows.
  make_primitive(plane.x, plane.d);
  return plane;
}

Integer height(const DualPlane& plane, const DualPoint& point) {
  Integer sum = dot(plane.x, point.n);
  subtract_product(sum, plane.d, point.w);
  return sum;
}

}  // namespace convexact
