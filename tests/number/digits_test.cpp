// SPDX-License-Identifier: MIT
// Decimal text. Expected strings are written out by hand; the property reads the text back exactly.
#include <doctest/doctest.h>

#include "convexact/error.hpp"
#include "convexact/number.hpp"
#include "number/precision.hpp"
#include "number/text.hpp"
#include "property.hpp"
#include "refine_decimal.hpp"
using namespace convexact;

TEST_CASE("to_decimal: a rational that ends is written exactly, without trailing zeros") {
  CHECK(to_decimal(Rational(0), 5) == "0");
  CHECK(to_decimal(Rational(1, 2), 5) == "0.5");
  CHECK(to_decimal(Rational(-5, 4), 5) == "-1.25");
  CHECK(to_decimal(Rational(6), 17) == "6");
  CHECK(to_decimal(Rational(3000000), 3) == "3000000");
  CHECK(to_decimal(Rational(1234), 4) == "1234");
  CHECK(to_decimal(parse_rational("1e30"), 3) == "1e+30");
  CHECK(to_decimal(parse_rational("1.25e30"), 3) == "1.25e+30");
  CHECK(to_decimal(parse_rational("1.25e-6"), 3) == "0.00000125");
  CHECK(to_decimal(parse_rational("1.25e-7"), 3) == "1.25e-7");
}

TEST_CASE("to_decimal: others are rounded to nearest, half to even, zeros kept") {
  CHECK(to_decimal(Rational(1, 3), 4) == "0.3333");
  CHECK(to_decimal(Rational(-2, 3), 4) == "-0.6667");
  CHECK(to_decimal(Rational(100001, 10), 4) == "1.000e+4");
  CHECK(to_decimal(Rational(100001, 10), 5) == "10000");
  CHECK(to_decimal(Rational(100001, 100), 5) == "1000.0");
  CHECK(to_decimal(Rational(99999, 100000), 4) == "1.000");  // carries into a new digit
  CHECK(to_decimal(Rational(5, 2), 1) == "2");
  CHECK(to_decimal(Rational(7, 2), 1) == "4");
  CHECK(to_decimal(Rational(2, 3), 1) == "0.7");
  CHECK_THROWS_AS((void)to_decimal(Rational(1), 0), Error);
}

TEST_CASE("to_decimal: read back, within half a unit of the last digit") {
  check_property("read back", [](std::int64_t p, std::uint64_t q, std::uint8_t d, std::int8_t k) {
    const Rational x = scale_by_power_of_two(Rational(Integer(p), Integer(q) + 1), k);
    RC_PRE(x != 0);
    const int digits = 1 + d % 30;
    const Rational back = parse_rational(to_decimal(x, digits));
    // A number with d digits is at least 10^(d - 1) units.
    Rational relative(1, 2);
    for (int i = 1; i < digits; ++i) relative /= 10;
    RC_ASSERT(abs(Rational(back - x)) <= abs(back) * relative);
  });
}

TEST_CASE("to_decimal: an enclosure gives digits only when each is certain") {
  const auto root_two = [](long precision) { return sqrt(Enclosure(Integer(2), precision)); };
  CHECK(to_decimal(root_two(20), 5) == "1.4142");
  CHECK(!to_decimal(root_two(20), 9));
  CHECK(refine_decimal(root_two, 21) == "1.41421356237309504880");
  CHECK(to_decimal(Enclosure(Rational(-3, 4), 10), 9) == "-0.75");  // a point
  CHECK(!to_decimal(Enclosure::pi(10) - Enclosure::pi(10), 1));     // may be zero
}

TEST_CASE("to_decimal: a short number behind an interval is found, with its zeros") {
  // 3/2 as the product of irrational numbers: no precision tells it from 1.4999...
  const auto three_halves = [](long precision) {
    const Enclosure root = sqrt(Enclosure(Integer(3), precision));
    return root * root / Enclosure(Integer(2), precision);
  };
  CHECK(refine_decimal(three_halves, 10) == "1.500000000");
  const auto negative = [&](long precision) { return -three_halves(precision); };
  CHECK(refine_decimal(negative, 3) == "-1.50");
}

// 10^39 has 40 digits, and 2^200 = 1606938044258990275541962092341162602522202993782792835301376.
TEST_CASE("in_sentence: exact up to 40 characters, then six digits") {
  CHECK(in_sentence(Rational(-7, 3)) == "-7/3");
  CHECK(in_sentence(parse_rational("1e39")) == "1" + std::string(39, '0'));
  CHECK(in_sentence(parse_rational("1e40")) == "about 1e+40");
  CHECK(in_sentence(scale_by_power_of_two(1, 200)) == "about 1.60694e+60");
  CHECK(in_sentence(scale_by_power_of_two(1, -200)) == "about 6.22302e-61");
}
