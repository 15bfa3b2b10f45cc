// SPDX-License-Identifier: MIT
// Enclosures. Expected values come from exact rationals, from closed forms, and from the
// definition: an interval result holds the result of every choice from the intervals it was given.
#include <doctest/doctest.h>

#include <algorithm>

#include "convexact/error.hpp"
#include "convexact/number.hpp"
#include "number/precision.hpp"
#include "property.hpp"
#include "refine_decimal.hpp"
using namespace convexact;

namespace {

Rational ratio(std::int32_t p, std::uint16_t q) { return Rational(Integer(p), Integer(q) + 1); }

Enclosure point(const Rational& x) { return Enclosure(x, 200); }

// [low, high] for small integers: the hull of low and high as low + [0, 1] * (high - low), with
// [0, 1] = sqrt([0, 1]) ... made from an enclosure of 1/3 that is too coarse to be a point.
Enclosure interval(int low, int high) {
  // At one bit, 1/3 lies in [1/4, 1/2]: 4 x - 1 is [0, 1].
  const Enclosure unit = point(4) * Enclosure(Rational(1, 3), 1) - point(1);
  return point(low) + unit * point(high - low);
}

bool inside(const Enclosure& inner, const Enclosure& outer) {
  return outer.low() <= inner.low() && inner.high() <= outer.high();
}

}  // namespace

TEST_CASE("enclosure: a rational lies between two neighbours of the precision") {
  check_property("neighbours", [](std::int32_t p, std::uint16_t q, std::uint8_t bits) {
    const Rational x = ratio(p, q);
    const long precision = 1 + bits;
    const Enclosure e(x, precision);
    RC_ASSERT(e.contains(x));
    RC_ASSERT(e.width() <= scale_by_power_of_two(abs(x), 1 - precision));
  });
  CHECK(Enclosure(Rational(5, 8), 3).width() == 0);
  CHECK(Enclosure(Rational(5, 8), 2).low() == Rational(1, 2));
  CHECK(Enclosure(Rational(5, 8), 2).high() == Rational(3, 4));
  CHECK(Enclosure(Integer(-5), 2).low() == -6);
  CHECK(Enclosure(Integer(-5), 2).high() == -4);
  CHECK_THROWS_AS(Enclosure(Integer(1), 0), Error);
}

TEST_CASE("enclosure: an interval of rationals widens outward to the precision") {
  const Enclosure x(Rational(1, 3), Rational(2, 3), 10);
  CHECK(x.low() <= Rational(1, 3));
  CHECK(x.high() >= Rational(2, 3));
  CHECK(x.width() < Rational(1, 3) + Rational(2, 1024));
  CHECK(Enclosure(Rational(-1), Rational(3), 10).low() == -1);
}

TEST_CASE("enclosure: arithmetic holds the exact result, closely") {
  check_property("+ - * /", [](std::int32_t p, std::uint16_t q, std::int32_t r, std::uint16_t s) {
    const Rational x = ratio(p, q), y = ratio(r, s);
    const Enclosure a(x, 40), b(y, 50);
    const Rational slack = scale_by_power_of_two(abs(x) + abs(y), -37);
    RC_ASSERT((a + b).precision() == 50);
    RC_ASSERT((a + b).contains(x + y));
    RC_ASSERT((a + b).width() <= slack);
    RC_ASSERT((a - b).contains(x - y));
    RC_ASSERT((a - b).width() <= slack);
    RC_ASSERT((a * b).contains(x * y));
    RC_ASSERT((a * b).width() <= scale_by_power_of_two(abs(Rational(x * y)), -37));
    if (y == 0) return;
    RC_ASSERT((a / b).contains(x / y));
    RC_ASSERT((a / b).width() <= scale_by_power_of_two(abs(Rational(x / y)), -37));
  });
}

TEST_CASE("enclosure: intervals of either sign give the exact range") {
  // The range of a product or quotient over a box of integers is that of its four corners; here it
  // is taken over all integers in the box, so by definition.
  for (int a = -2; a <= 2; ++a) {
    for (int b = a; b <= 2; ++b) {
      for (int c = -2; c <= 2; ++c) {
        for (int d = c; d <= 2; ++d) {
          std::vector<Rational> products, quotients;
          for (int x = a; x <= b; ++x) {
            for (int y = c; y <= d; ++y) {
              products.emplace_back(x * y);
              if (y != 0) quotients.push_back(Rational(x) / y);
            }
          }
          const Enclosure left = interval(a, b), right = interval(c, d);
          const Enclosure product = left * right;
          CHECK(product.low() == *std::min_element(products.begin(), products.end()));
          CHECK(product.high() == *std::max_element(products.begin(), products.end()));
          if (c <= 0 && d >= 0) {
            CHECK_THROWS_AS(left / right, Error);
            continue;
          }
          const Enclosure quotient = left / right;
          CHECK(quotient.low() == *std::min_element(quotients.begin(), quotients.end()));
          CHECK(quotient.high() == *std::max_element(quotients.begin(), quotients.end()));
        }
      }
    }
  }
}

TEST_CASE("enclosure: the sign is told only when certain") {
  CHECK(interval(1, 2).sign() == Sign::Positive);
  CHECK(interval(-2, -1).sign() == Sign::Negative);
  CHECK(Enclosure(10).sign() == Sign::Zero);
  CHECK(!interval(0, 1).sign());
  CHECK(!interval(-1, 0).sign());
  CHECK(!interval(-1, 1).sign());
  CHECK((-interval(1, 2)).low() == -2);
}

TEST_CASE("enclosure: square roots") {
  CHECK(sqrt(Enclosure(10)).sign() == Sign::Zero);
  CHECK(sqrt(point(Rational(9, 4))).low() == Rational(3, 2));
  CHECK(sqrt(point(Rational(9, 4))).width() == 0);
  const Enclosure root = sqrt(point(2));
  CHECK(Rational(root.low() * root.low()) < 2);
  CHECK(Rational(root.high() * root.high()) > 2);
  CHECK(root.width() <= scale_by_power_of_two(Rational(1), -199));
  CHECK(sqrt(interval(-1, 4)).low() == 0);  // cut off
  CHECK(sqrt(interval(-1, 4)).high() == 2);
  CHECK_THROWS_AS(sqrt(point(-1)), Error);
}

TEST_CASE("enclosure: pi and angles") {
  // The first 50 digits of pi, OEIS A000796.
  CHECK(refine_decimal(Enclosure::pi, 50) == "3.1415926535897932384626433832795028841971693993751");
  const auto angle = [](int y, int x) { return atan2(point(y), point(x)); };
  const auto is_pi_times = [](const Enclosure& e, const Rational& factor) {
    const Enclosure expected = Enclosure::pi(300) * Enclosure(factor, 300);
    return inside(expected, e) && e.width() < scale_by_power_of_two(Rational(1), -195);
  };
  CHECK(angle(0, 1).sign() == Sign::Zero);
  CHECK(is_pi_times(angle(1, 1), Rational(1, 4)));
  CHECK(is_pi_times(angle(1, 0), Rational(1, 2)));
  CHECK(is_pi_times(angle(1, -1), Rational(3, 4)));
  CHECK(is_pi_times(angle(0, -1), Rational(1)));
  CHECK(is_pi_times(atan2(sqrt(point(3)), point(1)), Rational(1, 3)));
  // 1 - 1 rounded down is -0, whose angle must not turn negative.
  CHECK(is_pi_times(atan2(point(1) - point(1), point(-1)), Rational(1)));
  CHECK_THROWS_AS(angle(0, 0), Error);
  CHECK_THROWS_AS(atan2(interval(0, 1), interval(-1, 1)), Error);
  CHECK_THROWS_AS(angle(-1, 1), Error);
}

TEST_CASE("enclosure: the angle of a box holds the angle of each of its points") {
  for (int a = -3; a <= 3; ++a) {
    for (int b = a; b <= 3; ++b) {
      for (const auto& [c, d] : {std::pair{1, 1}, {1, 3}, {2, 3}}) {
        const Enclosure box = atan2(interval(c, d), interval(a, b));
        for (int x = a; x <= b; ++x) {
          for (int y = c; y <= d; ++y) CHECK(inside(atan2(point(y), point(x)), box));
        }
      }
    }
  }
}

// Of narrow boxes one end is computed and the other bounded by how far apart they can be.
TEST_CASE("enclosure: the angle of a narrow box holds those of its corners, and little more") {
  for (const int exponent : {-17, -20, -60, -150}) {
    const Rational wider = 1 + scale_by_power_of_two(Rational(1), exponent);
    for (int x = -3; x <= 3; ++x) {
      for (const int y : {1, 2, 1000}) {
        if (x == 0) continue;
        const auto around = [&](int v) {
          return Enclosure(std::min(Rational(v), Rational(v * wider)),
                           std::max(Rational(v), Rational(v * wider)), 200);
        };
        const Enclosure box = atan2(around(y), around(x));
        for (const Rational& u : {Rational(x), Rational(x * wider)}) {
          for (const Rational& v : {Rational(y), Rational(y * wider)}) {
            CHECK(inside(atan2(Enclosure(v, 300), Enclosure(u, 300)), box));
          }
        }
        CHECK(box.width() <= scale_by_power_of_two(box.high(), exponent + 3));
      }
    }
  }
}

TEST_CASE("enclosure: outward doubles agree with the rounding of rationals") {
  const Rational tiny = scale_by_power_of_two(Rational(1, 3), -1074);
  const Rational huge = scale_by_power_of_two(Rational(1), 1024);
  for (const Rational& x : {Rational(1, 3), tiny, Rational(tiny * 7), huge, Rational(0)}) {
    for (const Rational& y : {x, Rational(-x)}) {
      const Enclosure e(y, 300);
      CHECK(e.low_double() == to_double(e.low(), Rounding::Down));
      CHECK(e.high_double() == to_double(e.high(), Rounding::Up));
    }
  }
}

TEST_CASE("enclosure: beyond the exponents of MPFR is an error, below them is zero or wider") {
  Enclosure large = point(2), small = point(Rational(1, 2));
  for (int i = 0; i < 29; ++i) {
    large *= large;
    small *= small;
  }
  CHECK_THROWS_AS(large * large, Error);
  CHECK(!(small * small * small).sign());
  CHECK((small * small * small).low() == 0);
}

TEST_CASE("enclose_sum: no terms, cancelling terms, many terms") {
  CHECK(enclose_sum({}, 64).sign() == Sign::Zero);
  std::vector<Rational> terms;
  Rational exact = 0;
  for (int i = 1; i <= 1000; ++i) {
    terms.emplace_back(Rational(i % 2 == 0 ? 1 : -1, i));
    exact += terms.back();
  }
  const Enclosure sum = enclose_sum(terms, 100);
  CHECK(sum.contains(exact));
  // Each of 2000 roundings of numbers below 1 is wrong by less than 2^-100.
  CHECK(sum.width() < scale_by_power_of_two(Rational(1), -88));
}

TEST_CASE("refine: doubles until decided, gives up at the limit") {
  std::vector<long> tried;
  const auto nearly_equal = [&](long precision) {  // 2^-100
    tried.push_back(precision);
    const Rational one(1), close = one + scale_by_power_of_two(one, -100);
    return Enclosure(Rational(close / 3), precision) - Enclosure(Rational(one / 3), precision);
  };
  const auto sign = [](const Enclosure& x) { return x.sign(); };
  CHECK(refine(nearly_equal, sign, {.first = 16}) == Sign::Positive);
  CHECK(tried == std::vector<long>{16, 32, 64, 128});
  const auto zero = [](long precision) {
    const Enclosure root = sqrt(Enclosure(Integer(2), precision));
    return root * root - Enclosure(Integer(2), precision);
  };
  CHECK(!refine(zero, sign, {.first = 16, .last = 1024}));
}

TEST_CASE("big_float: copies and moves keep the value and the precision") {
  BigFloat a(77);
  mpfr_set_si(a.data(), 42, MPFR_RNDN);
  BigFloat b = a;
  CHECK(b.precision() == 77);
  CHECK(b.to_rational() == 42);
  BigFloat c = std::move(a);
  CHECK(c.to_rational() == 42);
  a = b;  // what was moved from can be assigned to
  CHECK(a.precision() == 77);
  CHECK(a.to_rational() == 42);
}
