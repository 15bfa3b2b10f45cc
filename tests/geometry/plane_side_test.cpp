// SPDX-License-Identifier: MIT
// Sides of planes in integers against the definition, n.x + d as a rational.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "convexact/geometry.hpp"
#include "property.hpp"

using namespace convexact;

namespace {

Sign by_definition(const Halfspace& halfspace, const Point& x) {
  return sign_of(halfspace(to_rational(x)));
}

}  // namespace

TEST_CASE("side_of: inside, on and beyond a plane") {
  const Halfspace below_one(IntegerVector3(0, 0, 3), -3);
  CHECK(side_of(below_one, Point(7, -9, 0)) == Sign::Negative);
  CHECK(side_of(below_one, Point(0, 0, 1)) == Sign::Zero);
  CHECK(side_of(below_one, Point(0, 0, std::nextafter(1, 2))) == Sign::Positive);
  CHECK(side_of(below_one, Point(0, -0.0, 0)) == Sign::Negative);
}

TEST_CASE("side_of: from the smallest to the largest doubles") {
  using Limits = std::numeric_limits<double>;
  const Halfspace diagonal(IntegerVector3(1, -1, 1), 0);
  for (const double x :
       {Limits::denorm_min(), 3 * Limits::denorm_min(), Limits::min(), 0.1, 1e300, Limits::max()}) {
    CAPTURE(x);
    CHECK(side_of(diagonal, Point(x, x, 0)) == Sign::Zero);
    CHECK(side_of(diagonal, Point(x, x, Limits::denorm_min())) == Sign::Positive);
    CHECK(side_of(diagonal, Point(x, x, -Limits::max())) == Sign::Negative);
  }
}

TEST_CASE("side_of: agrees with rationals where the value nearly vanishes") {
  check_property(
      "random planes", [](std::int16_t a, std::int16_t b, std::int16_t d, std::int8_t exponent) {
        const double z = std::ldexp(1 + std::abs(b) / 7.0, exponent);
        const Point x(a / 3.0, b / 5.0, z);
        // A plane through x, moved by nothing or by a unit of its long offset.
        const Halfspace through(RationalVector3(a, 7, d == 0 ? 1 : d),
                                Rational(-(a * to_rational(x[0]) + 7 * to_rational(x[1]) +
                                           (d == 0 ? 1 : d) * to_rational(x[2]))));
        RC_ASSERT(side_of(through, x) == Sign::Zero);
        for (const int shift : {-1, 1}) {
          const Halfspace moved(through.normal(), Integer(through.offset() + shift));
          RC_ASSERT(side_of(moved, x) == Sign(shift));
          RC_ASSERT(side_of(moved, x) == by_definition(moved, x));
        }
      });
}
