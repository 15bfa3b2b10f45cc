// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "convexact/error.hpp"
#include "convexact/geometry.hpp"
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

// x 2^-exponent, an integer. Precondition: exponent <= unit_exponent(x).
Integer scaled_to_integer(double x, int exponent) {
  if (x == 0) return 0;
  const int own = unit_exponent(x);
  Integer value(static_cast<long long>(std::ldexp(x, -own)));
  return value << static_cast<unsigned>(own - exponent);
}

IntegerVector3 scaled_to_integer(const Point& p, int exponent) {
  return {scaled_to_integer(p[0], exponent), scaled_to_integer(p[1], exponent),
          scaled_to_integer(p[2], exponent)};
}

constexpr int kAboveAll = 4096;  // above every exponent of a double

IntegerVector3 normal_through(const Point& a, const Point& b, const Point& c, int exponent) {
  const IntegerVector3 first = scaled_to_integer(a, exponent);
  const IntegerVector3 u = scaled_to_integer(b, exponent) - first;
  const IntegerVector3 v = scaled_to_integer(c, exponent) - first;
  return u.cross(v);
}

#ifdef __SIZEOF_INT128__
__extension__ using Wide = __int128;
__extension__ using UnsignedWide = unsigned __int128;

Integer to_integer(Wide x) {
  const auto magnitude = x < 0 ? -static_cast<UnsignedWide>(x) : static_cast<UnsignedWide>(x);
  const std::uint64_t words[] = {static_cast<std::uint64_t>(magnitude),
                                 static_cast<std::uint64_t>(magnitude >> 64)};
  Integer value;
  mpz_import(value.backend().data(), 2, -1, sizeof words[0], 0, 0, words);
  return x < 0 ? Integer(-value) : value;
}

// (b - a) x (c - a) for points whose coordinates times 2^-exponent are integers below 2^61:
// differences are below 2^62, products below 2^124, and their differences below 2^125.
IntegerVector3 short_normal_through(const Point& a, const Point& b, const Point& c, int exponent) {
  const auto scaled = [&](double x) { return static_cast<Wide>(std::ldexp(x, -exponent)); };
  Wide u[3], v[3];
  for (int k = 0; k < 3; ++k) {
    const Wide origin = scaled(a[k]);
    u[k] = scaled(b[k]) - origin;
    v[k] = scaled(c[k]) - origin;
  }
  return {to_integer(u[1] * v[2] - u[2] * v[1]), to_integer(u[2] * v[0] - u[0] * v[2]),
          to_integer(u[0] * v[1] - u[1] * v[0])};
}
#else  // compilers for 32-bit machines have no integers of 128 bits
IntegerVector3 short_normal_through(const Point& a, const Point& b, const Point& c, int exponent) {
  return normal_through(a, b, c, exponent);
}
#endif

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
  int exponent = kAboveAll, highest = -kAboveAll;
  for (const Point* p : {&a, &b, &c}) {
    for (int k = 0; k < 3; ++k) {
      if ((*p)[k] == 0) continue;
      exponent = std::min(exponent, unit_exponent((*p)[k]));
      highest = std::max(highest, unit_exponent((*p)[k]));
    }
  }
  // A mantissa is below 2^53, so up to 2^8 times that is below 2^61.
  constexpr int kShortSpread = 8;
  IntegerVector3 normal = highest - exponent <= kShortSpread
                              ? short_normal_through(a, b, c, exponent)
                              : normal_through(a, b, c, exponent);
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
  const auto compare = [&](const Integer& x, const Integer& y) {
    const int c = a.normal_gcd_ == b.normal_gcd_
                      ? x.compare(y)
                      : Integer(x * b.normal_gcd_).compare(Integer(y * a.normal_gcd_));
    return c <=> 0;
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
