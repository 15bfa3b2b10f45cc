// SPDX-License-Identifier: MIT
// Short interior points; expected values by hand and by the definition of "coarsest".
#include "lp/interior_point.hpp"

#include <doctest/doctest.h>

#include "convexact/linear_program.hpp"
#include "halfspaces.hpp"
#include "property.hpp"

using namespace convexact;

TEST_CASE("round_to_grid: nearest multiple, halves upwards") {
  const RationalPoint x(Rational(7, 10), Rational(-7, 10), Rational(1, 2));
  CHECK(round_to_grid(x, 0) == RationalPoint(1, -1, 1));
  CHECK(round_to_grid(x, -2) == RationalPoint(Rational(3, 4), Rational(-3, 4), Rational(1, 2)));
  CHECK(round_to_grid(x, 1) == RationalPoint(0, 0, 0));
  CHECK(round_to_grid(RationalPoint(Rational(-1, 2), 5, 13), 3) == RationalPoint(0, 8, 16));
}

TEST_CASE("short_dyadic_interior_point: the origin if it serves") {
  const auto box = data::centered_box(3, 3, 3);
  CHECK(short_dyadic_interior_point(box, RationalPoint(Rational(8, 3), Rational(-1, 7), 0))
            ->isZero(0));
  CHECK(short_dyadic_interior_point(box, RationalPoint(0, 0, 0))->isZero(0));
  CHECK(short_dyadic_interior_point({}, RationalPoint(5, 5, 5))->isZero(0));
}

TEST_CASE("short_dyadic_interior_point: a guess that is not inside is refused") {
  const auto box = data::centered_box(3, 3, 3);
  CHECK_FALSE(short_dyadic_interior_point(box, RationalPoint(3, 0, 0)));
  CHECK_FALSE(short_dyadic_interior_point(box, RationalPoint(0, 0, 4)));
}

TEST_CASE("short_dyadic_interior_point: between 5 and 6 it takes halves") {
  const auto slab = data::halfspaces({{-1, 0, 0, 5}, {1, 0, 0, -6}});
  const auto x = short_dyadic_interior_point(slab, RationalPoint(Rational(501, 100), 0, -1));
  // Multiples of 1/2 give 5, of 1/4 also, ..., of 1/64 (501/100 = 320.64/64) 321/64.
  REQUIRE(x);
  CHECK(*x == RationalPoint(Rational(321, 64), 0, -1));
}

TEST_CASE("short_dyadic_interior_point: inside, and no coarser grid serves") {
  check_property("coarsest", [](std::uint64_t seed) {
    Random random(seed);
    auto list = data::random_halfspaces(random, 1 + uniform_below(random, 9), 20);
    const auto coordinate = [&] {
      return Rational(static_cast<int>(uniform_below(random, 2001)) - 1000,
                      1 + uniform_below(random, 99));
    };
    const RationalPoint guess(coordinate(), coordinate(), coordinate());
    std::erase_if(list, [&](const Halfspace& h) { return h(guess) >= 0; });
    const auto x = short_dyadic_interior_point(list, guess);
    RC_ASSERT(x.has_value());
    for (const Halfspace& h : list) RC_ASSERT(h(*x) < 0);
    for (long exponent = 20; round_to_grid(guess, exponent) != *x; --exponent) {
      RC_ASSERT(!is_strictly_inside(list, round_to_grid(guess, exponent)));
    }
  });
}
