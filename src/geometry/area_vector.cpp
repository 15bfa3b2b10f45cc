// SPDX-License-Identifier: MIT
#include "geometry/area_vector.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "number/arithmetic.hpp"

namespace convexact {
namespace {

constexpr int kAboveAll = 4096;  // above every exponent of a double

// x 2^-exponent, an integer. Precondition: exponent <= unit_exponent(x).
Integer integer_at(double x, int exponent) {
  if (x == 0) return 0;
  const int own = unit_exponent(x);
  Integer value(static_cast<long long>(std::ldexp(x, -own)));
  return value << static_cast<unsigned>(own - exponent);
}

}  // namespace

IntegerVector3 scaled_to_integer(const Point& p, int exponent) {
  return {integer_at(p[0], exponent), integer_at(p[1], exponent), integer_at(p[2], exponent)};
}

namespace {

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

ScaledNormal scaled_normal(const Point& a, const Point& b, const Point& c) {
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
  const bool is_short = highest - exponent <= kShortSpread;
  return {is_short ? short_normal_through(a, b, c, exponent) : normal_through(a, b, c, exponent),
          exponent};
}

RationalVector3 area_vector(const PointSet& points, PointId a, PointId b, PointId c) {
  if (!points.is_binary()) {
    const RationalPoint origin = points[a];
    return RationalVector3(points[b] - origin).cross(RationalVector3(points[c] - origin));
  }
  const auto corners = points.doubles();
  const ScaledNormal normal =
      scaled_normal(corners[a.index()], corners[b.index()], corners[c.index()]);
  RationalVector3 vector = RationalVector3::Zero();
  for (int k = 0; k < 3; ++k) {
    if (normal.n[k] == 0) continue;
    vector[k] = scale_by_power_of_two(Rational(normal.n[k]), 2L * normal.exponent);
  }
  return vector;
}

RationalVector3 area_vector(const PointSet& points, std::span<const std::uint32_t> corners) {
  RationalVector3 sum = RationalVector3::Zero();
  for (std::size_t k = 2; k < corners.size(); ++k) {
    sum += area_vector(points, PointId(corners[0]), PointId(corners[k - 1]), PointId(corners[k]));
  }
  return sum;
}

}  // namespace convexact
