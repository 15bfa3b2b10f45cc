// SPDX-License-Identifier: MIT
#include "hull/homogeneous_points.hpp"

#include <algorithm>

#include "convexact/error.hpp"
#include "convexact/number.hpp"

namespace convexact {
namespace {

// The sign of det[a; b; c; d], rows (n, w): by w > 0 that of det[a-d; b-d; c-d] of the points.
Sign determinant_sign(const HomogeneousPoint& a, const HomogeneousPoint& b,
                      const HomogeneousPoint& c, const HomogeneousPoint& d) {
  const IntegerVector3 ab = a.n.cross(b.n), cd = c.n.cross(d.n);
  const IntegerVector3 p = a.n * b.w - b.n * a.w, q = c.n * d.w - d.n * c.w;
  // Laplace expansion by the first two rows: the six 2x2 minors of (a, b) are ab and p.
  return sign_of(Integer(ab.dot(q) + cd.dot(p)));
}

// An e with |q| <= 2^e; 0 for 0.
long exponent_of(const Rational& q) {
  if (q == 0) return 0;
  return static_cast<long>(bit_length(numerator(q))) -
         static_cast<long>(bit_length(denominator(q))) + 1;
}

}  // namespace

HomogeneousPoint to_homogeneous(const RationalPoint& p) {
  Integer w = denominator(p[0]);
  for (int k = 1; k < 3; ++k) w = lcm(w, denominator(p[k]));
  IntegerVector3 n;
  for (int k = 0; k < 3; ++k) n[k] = numerator(p[k]) * (w / denominator(p[k]));
  return {std::move(n), std::move(w)};
}

HomogeneousPoints::HomogeneousPoints(std::span<const HomogeneousPoint> points)
    : points_(points), near_(points.size()) {
  if (points.empty()) return;
  for (const HomogeneousPoint& p : points) {
    if (p.w <= 0) throw Error(ErrorCode::InvalidArgument, "a homogeneous point needs w > 0");
  }
  low_ = high_ = rational(PointId(0));
  for (std::size_t i = 1; i < size(); ++i) {
    const RationalPoint p = rational(PointId(i));
    for (int k = 0; k < 3; ++k) {
      if (p[k] < low_[k]) low_[k] = p[k];
      if (p[k] > high_[k]) high_[k] = p[k];
    }
  }
  compute_near((low_ + high_) / Rational(2));
}

void HomogeneousPoints::center_at(const std::array<PointId, 4>& simplex) {
  RationalPoint sum = rational(simplex[0]);
  for (int k = 1; k < 4; ++k) sum += rational(simplex[k]);
  const RationalPoint center = sum / Rational(4);
  center_ = to_homogeneous(center);
  compute_near(center);
}

void HomogeneousPoints::compute_near(const RationalPoint& center) {
  std::array<long, 3> exponent;
  for (int k = 0; k < 3; ++k) exponent[k] = exponent_of(high_[k] - low_[k]);
  for (std::size_t i = 0; i < size(); ++i) {
    const RationalVector3 shifted = rational(PointId(i)) - center;
    const auto near = [&](int k) {
      return to_double(scale_by_power_of_two(shifted[k], -exponent[k]), Rounding::Nearest);
    };
    near_[i] = {near(0), near(1), near(2)};
  }
}

Sign HomogeneousPoints::side(PointId a, PointId b, PointId c, PointId p) const {
  return -determinant_sign(at(a), at(b), at(c), at(p));
}

Sign HomogeneousPoints::center_side(PointId a, PointId b, PointId p) const {
  return determinant_sign(at(a), at(b), at(p), center_);
}

bool HomogeneousPoints::equal(PointId p, PointId q) const {
  return at(p).n * at(q).w == at(q).n * at(p).w;
}

bool HomogeneousPoints::collinear(PointId a, PointId b, PointId c) const {
  const RationalVector3 u = rational(b) - rational(a), v = rational(c) - rational(a);
  const RationalVector3 cross = u.cross(v);
  return cross == RationalVector3::Zero();
}

RationalPoint HomogeneousPoints::rational(PointId p) const {
  const HomogeneousPoint& h = at(p);
  return {Rational(h.n[0], h.w), Rational(h.n[1], h.w), Rational(h.n[2], h.w)};
}

}  // namespace convexact
