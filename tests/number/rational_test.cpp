// SPDX-License-Identifier: MIT
// Conversions into Rational. Expected values are written out by hand.
#include <doctest/doctest.h>

#include <array>
#include <limits>

#include "convexact/error.hpp"
#include "convexact/number.hpp"
#include "number/arithmetic.hpp"

using namespace convexact;

TEST_CASE("to_rational: a double is a dyadic rational") {
  CHECK(to_string(to_rational(0.0)) == "0");
  CHECK(to_string(to_rational(-0.0)) == "0");
  CHECK(to_string(to_rational(-0.75)) == "-3/4");
  CHECK(to_string(to_rational(0.1)) == "3602879701896397/36028797018963968");
  CHECK(to_rational(std::numeric_limits<double>::denorm_min()) ==
        scale_by_power_of_two(Rational(1), -1074));
}

TEST_CASE("to_rational: NaN and infinity are refused") {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity()}) {
    try {
      (void)to_rational(bad);
      FAIL("accepted");
    } catch (const Error& error) {
      CHECK(error.code() == ErrorCode::NotFinite);
      CHECK(exit_code(error.code()) == 3);
    }
  }
}

TEST_CASE("parse_rational: decimals and fractions as spelled") {
  CHECK(to_string(parse_rational("0.1")) == "1/10");
  CHECK(to_string(parse_rational("+1.5")) == "3/2");
  CHECK(to_string(parse_rational("5.")) == "5");
  CHECK(to_string(parse_rational("-.5e-3")) == "-1/2000");
  CHECK(to_string(parse_rational("12E+2")) == "1200");
  CHECK(to_string(parse_rational("-6/4")) == "-3/2");
}

TEST_CASE("parse_rational: anything else is malformed") {
  for (const char* bad :
       {"", "-", ".", "e5", "1e", "1e+", "1.2.3", "nan", "inf", "0x1", "1/0", "1/-2", "1 ", " 1",
        "1e999999", "--1", "1e1.5", "/2", "1e99999999999999999999"}) {
    CAPTURE(bad);
    CHECK_THROWS_AS((void)parse_rational(bad), Error);
  }
}

TEST_CASE("parse_rational: exponents beyond +-100000 are refused, the least of longs too") {
  CHECK(parse_rational("1e100000") * parse_rational("1e-100000") == 1);
  for (const char* const exponent : {"100001", "-100001", "9223372036854775807",
                                     "-9223372036854775808", "-9223372036854775809"}) {
    CAPTURE(exponent);
    CHECK_THROWS_AS((void)parse_rational(std::string("1e") + exponent), Error);
  }
}

TEST_CASE("gcd and bit_length: zero and sign") {
  CHECK(gcd(0, 0) == 0);
  CHECK(gcd(-12, 18) == 6);
  CHECK(bit_length(0) == 0);
  CHECK(bit_length(-8) == 4);
}

TEST_CASE(
    "make_primitive of fractions: the least integers in proportion, also by a factor of two") {
  const std::array<Rational, 3> values{Rational(2, 3), Rational(4, 3), Rational(2)};
  std::array<Integer, 3> integers;
  make_primitive(values, integers);
  CHECK(integers == std::array<Integer, 3>{1, 2, 3});
  const std::array<Rational, 3> with_zero{Rational(0), Rational(-5, 2), Rational(15)};
  make_primitive(with_zero, integers);
  CHECK(integers == std::array<Integer, 3>{0, -1, 6});
}

TEST_CASE("make_primitive: divides by what all four share, and by nothing else") {
  IntegerVector3 x(12, -18, 0);
  Integer d = -30;
  make_primitive(x, d);
  CHECK(x == IntegerVector3(2, -3, 0));
  CHECK(d == -5);
  make_primitive(x, d);
  CHECK(d == -5);
  x = {0, 0, -7}, d = 0;
  make_primitive(x, d);
  CHECK(x == IntegerVector3(0, 0, -1));
  CHECK(d == 0);
}

TEST_CASE("floor_of: towards minus infinity") {
  CHECK(floor_of(Rational(0)) == 0);
  CHECK(floor_of(Rational(7, 2)) == 3);
  CHECK(floor_of(Rational(-7, 2)) == -4);
  CHECK(floor_of(Rational(-4)) == -4);
}

TEST_CASE("largest_exponent: of the coordinates that are not 0") {
  const std::vector<RationalVector3> none, zeros(2, RationalVector3::Zero());
  CHECK_FALSE(largest_exponent(none));
  CHECK_FALSE(largest_exponent(zeros));
  const std::vector<RationalVector3> points{{Rational(0), Rational(1, 1024), Rational(0)},
                                            {Rational(1, 8), Rational(-5), Rational(0)}};
  CHECK(largest_exponent(points) == exponent_of(Rational(-5)));
}
