// SPDX-License-Identifier: MIT
// Decimals to doubles. The expected value is the exact rational rounded by to_double, whose own
// tests go by the definition; nothing else of decimal.cpp takes that way but for subnormals, which
// are written out by hand as well.
#include "convexact/number/decimal.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "convexact/number/rounding.hpp"
#include "expect_error.hpp"
#include "property.hpp"

using namespace convexact;

namespace {

// The finite decimal that a dyadic rational is, as "digits" and "e-k".
std::pair<std::string, std::string> decimal_of(const Rational& dyadic) {
  const std::size_t k = bit_length(denominator(dyadic)) - 1;
  Integer power;
  mpz_ui_pow_ui(power.backend().data(), 5, k);
  return {to_string(Integer(numerator(dyadic) * power)), "e-" + std::to_string(k)};
}

double rounded(const std::string& text) {
  return to_double(parse_rational(text), Rounding::Nearest);
}

}  // namespace

TEST_CASE("nearest_double: hard decimals round as the rationals they spell") {
  for (const std::string text :
       {"0.1",
        "+1.5",
        "5.",
        "-.5e-3",
        "9007199254740993",
        "9007199254740992.99999999999999999999",
        "9007199254740993.00000000000000000000000000000000000000000000000000000000000000000001",
        "2.2250738585072011e-308",
        "2.2250738585072014e-308",
        "4.9406564584124654e-324",
        "5e-324",
        "2.4703282292062328e-324",
        "2.4703282292062327e-324",
        "1e-323",
        "7.4e-324",
        "1e-400",
        "1.7976931348623157e308",
        "1.7976931348623158e308",
        "1.797693134862315807e308",
        "8.98846567431157953864652595394501e307",
        "6.9294956446009195e15",
        "3.2378839133029012e-319",
        "0e9999",
        "0.0e-99999",
        "-0.0",
        "1e23",
        "8.5e22",
        "1000000000000000000000000e-23"}) {
    CAPTURE(text);
    CHECK(nearest_double(text) == rounded(text));
    CHECK(nearest_double("-" + text.substr(text.find_first_not_of("+-"))) ==
          -std::abs(rounded(text)));
  }
}

TEST_CASE("nearest_double: below the smallest double") {
  CHECK(nearest_double("2.4703282292062327e-324") == 0);
  CHECK(nearest_double("2.4703282292062328e-324") == std::numeric_limits<double>::denorm_min());
  CHECK(std::signbit(nearest_double("-1e-999999999999999999999999")));
  CHECK(nearest_double("0." + std::string(400, '0') + "5e400") == 0.5);
  CHECK(nearest_double("0." + std::string(330, '0') + "1") == 0);
}

TEST_CASE("nearest_double: half way between two doubles, and a little beside it") {
  check_property("ties go to even, anything else to the nearer", [](std::uint64_t bits) {
    const double low = std::abs(std::bit_cast<double>(bits));
    RC_PRE(std::isfinite(low) && low < std::numeric_limits<double>::max());
    const double high = std::nextafter(low, std::numeric_limits<double>::infinity());
    const auto [digits, exponent] = decimal_of((to_rational(low) + to_rational(high)) / 2);
    const bool low_is_even = (std::bit_cast<std::uint64_t>(low) & 1) == 0;
    RC_ASSERT(nearest_double(digits + exponent) == (low_is_even ? low : high));
    RC_ASSERT(nearest_double(digits + ".00001" + exponent) == high);
    const std::string below = to_string(Integer(Integer(digits) - 1));
    RC_ASSERT(nearest_double(below + ".99999" + exponent) == low);
  });
}

TEST_CASE("nearest_double: what is no finite decimal") {
  for (const std::string text : {"", "+", "-", ".", "+-1", "-+1", "1e", "1e+", "0x1p3", "1d3",
                                 "1,5", " 1", "1 ", "1.2.3", "e5", "--1", "1_000", "1/2"}) {
    CAPTURE(text);
    CHECK(error_of([&] { return nearest_double(text); }).code() == ErrorCode::Malformed);
  }
  for (const std::string& text : std::vector<std::string>{
           "nan", "NaN", "-nan", "inf", "-INF", "+infinity", "1e309", "-1.7976931348623159e308",
           "1.797693134862315808e308", "1e99999999999999999999", "1" + std::string(400, '0')}) {
    CAPTURE(text);
    CHECK(error_of([&] { return nearest_double(text); }).code() == ErrorCode::NotFinite);
  }
}

TEST_CASE("parse_number: integers and fractions are exact, decimals by choice") {
  const std::string large = "-123456789012345678901234567890";
  CHECK(to_string(parse_number(large, Decimal::Nearest)) == large);
  CHECK(parse_number("-6/4", Decimal::Nearest) == Rational(-3, 2));
  CHECK(parse_number("0.1", Decimal::Nearest) == to_rational(0.1));
  CHECK(parse_number("0.1", Decimal::Exact) == Rational(1, 10));
  CHECK(error_of([] { return parse_number("1e400", Decimal::Exact); }).code() ==
        ErrorCode::NotFinite);
  CHECK(error_of([] { return parse_number("nan", Decimal::Exact); }).code() ==
        ErrorCode::NotFinite);
}

TEST_CASE("in_quotes: short and printable") {
  CHECK(in_quotes("a\nb\x80") == "'a?b?'");
  CHECK(in_quotes(std::string(100, 'x')) == "'" + std::string(40, 'x') + "...'");
}
