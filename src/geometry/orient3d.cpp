// SPDX-License-Identifier: MIT
// Four stages of growing cost, after [Shewchuk1997, sec. 4.3], and rationals outside the range
// where these are proven.
#include <bit>
#include <cmath>
#include <cstdint>

#include "convexact/geometry.hpp"
#include "geometry/orient3d_stages.hpp"

namespace convexact {
namespace {

using namespace orient3d_stages;

// Range. Let every coordinate be 0 or lie in [2^-306, 2^338] in magnitude. Then all are multiples
// of 2^-358, and so are their differences and the roundoffs of these; every product of two or three
// of these is a multiple of 2^-1074, so no rounding below is an underflow and each roundoff is a
// double. Differences are at most 2^339, and so every sum of products of three is below 2^1021;
// split() multiplies at most products of two, by 2^27. So no operation overflows. Outside of this
// range, rationals decide.
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

// Stages B to D, for signs that a double does not decide.
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

Sign orient3d(const Point& a, const Point& b, const Point& c, const Point& d) {
  return orient3d_staged(a, b, c, d).sign;
}

}  // namespace convexact
