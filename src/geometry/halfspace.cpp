// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>

#include "convexact/error.hpp"
#include "convexact/geometry.hpp"
#include "geometry/area_vector.hpp"
#include "number/arithmetic.hpp"

namespace convexact {

Halfspace::Halfspace(IntegerVector3 normal, Integer offset)
    : normal_(std::move(normal)), offset_(std::move(offset)) {
  normal_gcd_ = gcd(gcd(normal_[0], normal_[1]), normal_[2]);
  if (normal_gcd_ == 0) throw Error(ErrorCode::InvalidArgument, "a halfspace has a zero normal");
  const Integer common = gcd(normal_gcd_, offset_);
  if (common == 1) return;
  for (int k = 0; k < 3; ++k) normal_[k] /= common;
  offset_ /= common;
  normal_gcd_ /= common;
}

namespace {

// n/g in doubles, for numbers that they can hold: truncating both moves it by less than 2^-52 of
// itself each, the quotient by 2^-53; far below 1 it is less exact. Infinite or NaN beyond them.
double near_quotient(const Integer& n, const Integer& g) {
  const double divisor = mpz_get_d(raw(g));
  return std::isfinite(divisor) ? mpz_get_d(raw(n)) / divisor
                                : std::numeric_limits<double>::quiet_NaN();
}

// Whether two such quotients differ by more than they may be off together; never for NaN.
bool surely_differ(double x, double y) {
  constexpr double kTwoErrors = 0x1p-49, kFarBelowOne = 0x1p-900;
  return std::abs(x - y) > kTwoErrors * std::max(std::abs(x), std::abs(y)) + kFarBelowOne;
}

}  // namespace

Halfspace::Halfspace(const RationalVector3& normal, const Rational& offset) {
  HomogeneousPoint cleared = clear_denominators(normal, offset);
  *this = Halfspace(std::move(cleared.n), std::move(cleared.w));
}

Halfspace Halfspace::through(const RationalPoint& a, const RationalPoint& b,
                             const RationalPoint& c) {
  const RationalVector3 u = b - a, v = c - a;
  const RationalVector3 normal = u.cross(v);
  return {normal, Rational(-normal.dot(a))};
}

Halfspace Halfspace::through(const Point& a, const Point& b, const Point& c) {
  // With P = p * 2^-e integer: N.P + D = 0 means (N 2^-e).p + D = 0, so one shift undoes the scale.
  auto [normal, exponent] = scaled_normal(a, b, c);
  const IntegerVector3 first = scaled_to_integer(a, exponent);
  Integer offset = -dot(normal, first);
  if (exponent >= 0) {
    offset <<= static_cast<unsigned>(exponent);
  } else {
    for (int k = 0; k < 3; ++k) normal[k] <<= static_cast<unsigned>(-exponent);
  }
  return {std::move(normal), std::move(offset)};
}

Rational Halfspace::operator()(const RationalPoint& x) const {
  return Rational(normal_[0]) * x[0] + Rational(normal_[1]) * x[1] + Rational(normal_[2]) * x[2] +
         Rational(offset_);
}

Integer plane_value(const Halfspace& h, const HomogeneousPoint& p) {
  Integer value = dot(h.normal(), p.n);
  add_product(value, h.offset(), p.w);
  return value;
}

std::strong_ordering operator<=>(const Halfspace& a, const Halfspace& b) {
  // n_a/g_a against n_b/g_b without dividing; both g are positive.
  const bool is_same_gcd = a.normal_gcd_ == b.normal_gcd_;
  const auto compare = [&](const Integer& x, const Integer& y) {
    if (is_same_gcd) return x.compare(y) <=> 0;
    const double near_x = near_quotient(x, a.normal_gcd_), near_y = near_quotient(y, b.normal_gcd_);
    if (surely_differ(near_x, near_y)) return near_x < near_y ? -1 <=> 0 : 1 <=> 0;
    return Integer(x * b.normal_gcd_).compare(Integer(y * a.normal_gcd_)) <=> 0;
  };
  for (int k = 0; k < 3; ++k) {
    if (const auto order = compare(a.normal_[k], b.normal_[k]); order != 0) return order;
  }
  return compare(a.offset_, b.offset_);
}

bool same_direction(const Halfspace& a, const Halfspace& b) {
  const IntegerVector3 cross = a.normal().cross(b.normal());
  return cross == IntegerVector3::Zero() && dot(a.normal(), b.normal()) > 0;
}

RationalPoint meet(const Halfspace& a, const Halfspace& b, const Halfspace& c) {
  // Cramer: x = -(d_a n_b x n_c + d_b n_c x n_a + d_c n_a x n_b) / det(n_a, n_b, n_c).
  const IntegerVector3 bc = b.normal().cross(c.normal());
  const Integer determinant = dot(a.normal(), bc);
  if (determinant == 0) {
    throw Error(ErrorCode::InvalidArgument, "three planes do not meet in one point");
  }
  const IntegerVector3 ca = c.normal().cross(a.normal()), ab = a.normal().cross(b.normal());
  RationalPoint x;
  for (int k = 0; k < 3; ++k) {
    const Integer top = a.offset() * bc[k] + b.offset() * ca[k] + c.offset() * ab[k];
    x[k] = Rational(Integer(-top), determinant);
  }
  return x;
}

void HalfspaceList::add(const RationalVector3& normal, const Rational& offset) {
  const std::size_t row = row_count_++;
  if (normal != RationalVector3::Zero()) {
    const Halfspace& halfspace = halfspaces.emplace_back(normal, offset);
    rows.push_back(row);
    const int k = normal[0] != 0 ? 0 : normal[1] != 0 ? 1 : 2;
    scales.push_back(Rational(halfspace.normal()[k]) / normal[k]);
  } else if (offset <= 0) {
    trivial_rows.push_back(row);
  } else if (!impossible_row) {
    impossible_row = row;
  }
}

}  // namespace convexact
