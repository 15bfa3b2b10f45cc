// SPDX-License-Identifier: MIT
#include "convexact/dual.hpp"
#include "convexact/error.hpp"

namespace convexact {
namespace {

// The primitive integer vector that points where (v, w) does.
template <class Result>
Result primitive(const RationalVector3& v, const Rational& w) {
  Integer common = denominator(w);
  for (int k = 0; k < 3; ++k) common = lcm(common, denominator(v[k]));
  const auto cleared = [&](const Rational& q) {
    return Integer(numerator(q) * (common / denominator(q)));
  };
  Result result{{cleared(v[0]), cleared(v[1]), cleared(v[2])}, cleared(w)};
  auto& [x, d] = result;
  make_primitive(x, d);
  return result;
}

RationalVector3 to_rational(const IntegerVector3& v) {
  return {Rational(v[0]), Rational(v[1]), Rational(v[2])};
}

}  // namespace

DualPoint polar(const Halfspace& halfspace, const RationalPoint& center) {
  const Rational w = -halfspace(center);
  if (w <= 0) {
    throw Error(ErrorCode::InvalidArgument, "the center is not strictly inside every halfspace");
  }
  return primitive<DualPoint>(to_rational(halfspace.normal()), w);
}

Halfspace polar(const DualPoint& point, const RationalPoint& center) {
  const RationalVector3 n = to_rational(point.n);
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
  const auto sum_of_products = [](Integer& sum, const Integer& p, const Integer& q,
                                  const Integer& r, const Integer& s, const Integer& t,
                                  const Integer& u) {
    mpz_t& z = sum.backend().data();
    mpz_mul(z, p.backend().data(), q.backend().data());
    mpz_addmul(z, r.backend().data(), s.backend().data());
    mpz_addmul(z, t.backend().data(), u.backend().data());
  };
  for (int k = 0; k < 3; ++k) sum_of_products(plane.x[k], a.w, bc[k], b.w, ca[k], c.w, ab[k]);
  sum_of_products(plane.d, a.n[0], bc[0], a.n[1], bc[1], a.n[2], bc[2]);
  // Dividing once here halves the length of all that follows.
  make_primitive(plane.x, plane.d);
  return plane;
}

Integer height(const DualPlane& plane, const DualPoint& point) {
  Integer sum;
  mpz_t& z = sum.backend().data();
  mpz_mul(z, plane.x[0].backend().data(), point.n[0].backend().data());
  mpz_addmul(z, plane.x[1].backend().data(), point.n[1].backend().data());
  mpz_addmul(z, plane.x[2].backend().data(), point.n[2].backend().data());
  mpz_submul(z, plane.d.backend().data(), point.w.backend().data());
  return sum;
}

}  // namespace convexact
