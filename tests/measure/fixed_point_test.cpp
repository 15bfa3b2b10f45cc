// SPDX-License-Identifier: MIT
// Roots and angles in fixed point. Expected values: squares around the root, angles known in parts
// of pi, and arctangents of MPFR.
#include "measure/fixed_point.hpp"

#include <doctest/doctest.h>

#include "number/arithmetic.hpp"
#include "property.hpp"

using namespace convexact;

namespace {

constexpr long kAngleBits = 150;

// Whether `angle` of FixedAngles is as near to the true one as it says.
bool is_angle(const Integer& angle, long error, const Enclosure& exact) {
  const Rational unit = scale_by_power_of_two(Rational(1), -kAngleBits);
  return Rational(angle - error) * unit <= exact.high() &&
         exact.low() <= Rational(angle + error) * unit;
}

Enclosure exact_angle(const Integer& squared_cross, const Integer& dot) {
  constexpr long kMore = kAngleBits + 60;
  return atan2(sqrt(Enclosure(squared_cross, kMore)), Enclosure(dot, kMore));
}

}  // namespace

TEST_CASE("fixed_root: the largest integer below the root, exact for squares") {
  for (const int x : {0, 1, 2, 3, 4, 1000000}) {
    for (const long shift : {0L, 1L, 100L}) {
      CAPTURE(x);
      CAPTURE(shift);
      const FixedRoot root = fixed_root(x, shift);
      const Integer scaled = Integer(x) << static_cast<unsigned>(2 * shift);
      CHECK(root.floor * root.floor <= scaled);
      CHECK((root.floor + 1) * (root.floor + 1) > scaled);
      CHECK(root.is_exact == (root.floor * root.floor == scaled));
    }
  }
}

TEST_CASE("shift_for_root: the least shift that leaves so many bits") {
  for (const Integer& x : {Integer(1), Integer(2), Integer(3), Integer(4), Integer(1) << 90}) {
    for (const long bits : {1L, 7L, 40L, 64L}) {
      CAPTURE(bits);
      const long shift = shift_for_root(x, bits);
      CHECK(fixed_root(x, shift).floor >= Integer(1) << static_cast<unsigned>(bits));
      if (shift == 0) continue;
      CHECK(fixed_root(x, shift - 1).floor < Integer(1) << static_cast<unsigned>(bits));
    }
  }
}

TEST_CASE("FixedAngles: parts of pi") {
  FixedAngles angles(kAngleBits);
  struct Known {
    int squared_cross, dot;
    Rational share;  // of pi
  };
  for (const Known& known :
       {Known{0, 5, 0}, Known{0, -5, 1}, Known{7, 0, {1, 2}}, Known{9, 3, {1, 4}},
        Known{9, -3, {3, 4}}, Known{3, 1, {1, 3}}, Known{3, -1, {2, 3}}, Known{1, 0, {1, 2}}}) {
    CAPTURE(known.squared_cross);
    CAPTURE(known.dot);
    const Enclosure exact =
        Enclosure(known.share, kAngleBits + 60) * Enclosure::pi(kAngleBits + 60);
    CHECK(is_angle(angles.angle(known.squared_cross, known.dot), angles.error(), exact));
  }
}

TEST_CASE("FixedAngles: as by MPFR, for angles and numbers of any size") {
  FixedAngles angles(kAngleBits);
  // Around the tangents at which the table of steps changes, and the axes.
  for (int k = 0; k <= 64; ++k) {
    for (const int off : {-1, 0, 1}) {
      const Integer y = Integer(k) * 1000000 + off, x = 32 * 1000000;
      if (y < 0) continue;
      CHECK(is_angle(angles.angle(y * y, x), angles.error(), exact_angle(y * y, x)));
      CHECK(is_angle(angles.angle(y * y, -x), angles.error(), exact_angle(y * y, -x)));
    }
  }
  check_property(
      "arctangents agree", [&](std::int64_t y, std::int64_t x, std::uint8_t up, std::uint8_t down) {
        const Integer squared = (Integer(y) * y) << up, dot = Integer(x) << down;
        RC_PRE(squared != 0 || dot != 0);
        RC_ASSERT(is_angle(angles.angle(squared, dot), angles.error(), exact_angle(squared, dot)));
      });
}
