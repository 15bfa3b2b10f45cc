// SPDX-License-Identifier: MIT
// Four stages of growing cost, after [Shewchuk1997, sec. 4.3], and rationals outside the range
// where these are proven. The error bounds are our own, a little wider and shorter to derive.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "convexact/predicates.hpp"
#include "geometry/roundoff.hpp"
#include "number/expansion.hpp"

namespace convexact {
namespace {

using roundoff::u;

// Range. Let every coordinate be 0 or lie in [2^-306, 2^338] in magnitude. Then all are multiples
// of 2^-358, and so are their differences and the roundoffs of these; every product of two or three
// of these is a multiple of 2^-1074, so no rounding below is an underflow and each roundoff is a
// double. Differences are at most 2^339, and so every sum of products of three is below 2^1021;
// split() multiplies at most products of two, by 2^27. So nothing overflows. Elsewhere: rationals.
constexpr double kSmallest = 0x1p-306, kLargest = 0x1p338;

bool is_in_range(const Point& p) {
  // Without the sign bit, doubles are ordered as their bits are.
  constexpr auto low = std::bit_cast<std::uint64_t>(kSmallest);
  constexpr auto high = std::bit_cast<std::uint64_t>(kLargest);
  bool good = true;
  for (int k = 0; k < 3; ++k) {
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(p[k]) << 1 >> 1;
    good &= (bits - low <= high - low) | (bits == 0);
  }
  return good;
}

// The determinant of rows x, y, z is the sum of six monomials. Written as `determinant` below, a
// monomial takes part in 5 roundings: its product, the difference of two, the product with a z,
// and two sums.
double determinant(const Point& x, const Point& y, const Point& z) {
  return x.z() * (y.x() * z.y() - z.x() * y.y()) + y.z() * (z.x() * x.y() - x.x() * z.y()) +
         z.z() * (x.x() * y.y() - y.x() * x.y());
}

// The sum of the monomials' magnitudes, with the same roundings.
double permanent(const Point& x, const Point& y, const Point& z) {
  const Point a = x.cwiseAbs(), b = y.cwiseAbs(), c = z.cwiseAbs();
  return a.z() * (b.x() * c.y() + c.x() * b.y()) + b.z() * (c.x() * a.y() + a.x() * c.y()) +
         c.z() * (a.x() * b.y() + b.x() * a.y());
}

// Let T be the true determinant, P its true permanent, Q the computed permanent. With the rounding
// of the three differences each monomial has 8 factors (1 + e), |e| <= u, so Q >= (1-u)^8 P.
//
// Stage A: |det - T| <= ((1+u)^8 - 1) P <= (8u + 28u^2 + ...) / (1-u)^8 Q < (8 + 100u) u Q; the
// rest up to 128u pays for the rounding of the bound itself.
constexpr double kBoundA = (8 + 128 * u) * u;
static_assert(kBoundA / u - 8 == 128 * u);

// Stage B: the determinant B of the rounded differences, exactly, has three of these factors:
// |B - T| <= (3u + 4u^2) P < (3 + 40u) u Q. Its estimate e is off by 16u|B|, so that
// |e| > (3 + 128u) u Q implies |B| > |e|(1 - 17u) > (3 + 70u) u Q > |B - T|.
constexpr double kBoundB = (3 + 128 * u) * u;
static_assert(kBoundB / u - 3 == 128 * u);

// Stage C: T = B + L + R, L linear in the roundoffs of the differences, R the rest. A roundoff is
// at most u times its difference (and 1 + u times that for the rounded one), so L has at most
// 3u(1+u)^3 P and R at most 3u^2(1+u)^4 P. L is computed by three calls of determinant(), each with
// one column of roundoffs: 5 factors, and 2 for their sum; that costs 3u * 7u P (1 + small). The
// sum e + L rounds once. So |det - T| < (3 + 21) u^2 P (1 + 20u) + 16u|B| + u|det|, where
// |B| <= |e|(1 + 17u) and |e| <= |det|(1 + 2u) + |L|, |L| < 4u P: 16u|B| < 17u|det| + 65u^2 P.
// Together less than 90u^2 P + 18u|det|; the rest up to 96 and 20 pays for P against Q and for the
// rounding of the bound.
constexpr double kBoundC = 96 * u * u;
constexpr double kRelativeC = 20 * u;
static_assert(kBoundC >= (24 + 65 + 1) * u * u && kRelativeC >= 18 * u);
double bound_c(double magnitude, double corrected) {
  return kBoundC * magnitude + kRelativeC * std::abs(corrected);
}

// Differences and their roundoffs: p - d = rounded + rest, exactly.
struct Difference {
  Point rounded, rest;
};
Difference subtract(const Point& p, const Point& d) {
  Difference result;
  for (int k = 0; k < 3; ++k) {
    const TwoTerms t = two_sum(p[k], -d[k]);
    result.rounded[k] = t.high;
    result.rest[k] = t.low;
  }
  return result;
}

// x1 y2 - x2 y1, exactly.
Expansion<4> minor(double x1, double y2, double x2, double y1) {
  return sum(to_expansion(two_product(x1, y2)), to_expansion(two_product(-x2, y1)));
}

Expansion<24> exact_determinant(const Point& x, const Point& y, const Point& z) {
  const auto yz = scale(minor(y.x(), z.y(), z.x(), y.y()), x.z());
  const auto zx = scale(minor(z.x(), x.y(), x.x(), z.y()), y.z());
  const auto xy = scale(minor(x.x(), y.y(), y.x(), x.y()), z.z());
  return sum(sum(yz, zx), xy);
}

// L of stage C: one column at a time is replaced by its roundoffs.
double linear_correction(const Difference& x, const Difference& y, const Difference& z) {
  double total = 0;
  for (int k = 0; k < 3; ++k) {
    Point a = x.rounded, b = y.rounded, c = z.rounded;
    a[k] = x.rest[k];
    b[k] = y.rest[k];
    c[k] = z.rest[k];
    total += determinant(a, b, c);
  }
  return total;
}

Expansion<2> entry(const Difference& x, int k) { return to_expansion({x.rounded[k], x.rest[k]}); }

// The determinant of the true differences: entries of two terms.
Sign exact_sign(const Difference& x, const Difference& y, const Difference& z) {
  const auto two_by_two = [](const Difference& p, const Difference& q) {
    return sum(product(entry(p, 0), entry(q, 1)), -product(entry(q, 0), entry(p, 1)));
  };
  const auto yz = product(two_by_two(y, z), entry(x, 2));
  const auto zx = product(two_by_two(z, x), entry(y, 2));
  const auto xy = product(two_by_two(x, y), entry(z, 2));
  return sum(sum(yz, zx), xy).sign();
}

StagedSign by_rationals(const Point& a, const Point& b, const Point& c, const Point& d) {
  const RationalPoint q = to_rational(d);
  const RationalVector3 x = to_rational(a) - q, y = to_rational(b) - q, z = to_rational(c) - q;
  const RationalVector3 cross = y.cross(z);
  return {sign_of(Rational(x.dot(cross))), Orient3dStage::Rationals};
}

// Stages B to D, when a double does not decide.
StagedSign adapt(const Point& a, const Point& b, const Point& c, const Point& d, double magnitude) {
  const Difference x = subtract(a, d), y = subtract(b, d), z = subtract(c, d);
  const Expansion<24> rounded = exact_determinant(x.rounded, y.rounded, z.rounded);
  const double estimate = rounded.estimate();
  if (std::abs(estimate) > kBoundB * magnitude) return {sign_of(estimate), Orient3dStage::B};
  if (x.rest.isZero(0) && y.rest.isZero(0) && z.rest.isZero(0)) {
    return {rounded.sign(), Orient3dStage::B};
  }
  const double corrected = estimate + linear_correction(x, y, z);
  if (std::abs(corrected) > bound_c(magnitude, corrected)) {
    return {sign_of(corrected), Orient3dStage::C};
  }
  return {exact_sign(x, y, z), Orient3dStage::D};
}

}  // namespace

StagedSign orient3d_staged(const Point& a, const Point& b, const Point& c, const Point& d) {
  bool in_range = is_in_range(a);  // no branch before all four are known
  in_range &= is_in_range(b);
  in_range &= is_in_range(c);
  in_range &= is_in_range(d);
  if (!in_range) return by_rationals(a, b, c, d);
  const Point x = a - d, y = b - d, z = c - d;
  const double value = determinant(x, y, z);
  const double magnitude = permanent(x, y, z);
  if (std::abs(value) > kBoundA * magnitude) return {sign_of(value), Orient3dStage::A};
  return adapt(a, b, c, d, magnitude);
}

Orient3dBounds orient3d_bounds(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Difference x = subtract(a, d), y = subtract(b, d), z = subtract(c, d);
  const double value = determinant(x.rounded, y.rounded, z.rounded);
  const double magnitude = permanent(x.rounded, y.rounded, z.rounded);
  const double corrected =
      exact_determinant(x.rounded, y.rounded, z.rounded).estimate() + linear_correction(x, y, z);
  return {value, kBoundA * magnitude, kBoundB * magnitude, corrected,
          bound_c(magnitude, corrected)};
}

Sign orient3d(const Point& a, const Point& b, const Point& c, const Point& d) {
  return orient3d_staged(a, b, c, d).sign;
}

}  // namespace convexact
