// SPDX-License-Identifier: MIT
// Decimals to doubles. The expected value is the exact rational rounded by to_double, whose own
// tests go by the definition; nothing else of decimal.cpp takes that way but for subnormals, which
// are written out by hand as well.
#include <doctest/doctest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <limits>

#include "convexact/number.hpp"
#include "expect_error.hpp"
#include "number/text.hpp"
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

TEST_CASE("nearest_float: hard decimals round once, from what they spell (#13)") {
  // Half way between two binary32 numbers and a little beside it: by way of the nearest double,
  // which is the half way itself, both would go to even.
  CHECK(nearest_float("1.00000017881393432617187499") == 1 + std::ldexp(1.f, -23));
  CHECK(nearest_float("1.000000059604644775390625000001") == 1 + std::ldexp(1.f, -23));
  CHECK(nearest_float("-1.000000059604644775390625") == -1);
  CHECK(nearest_float("16777217") == 16777216);
  CHECK(nearest_float("16777217.000000000000000000000001") == 16777218);
  CHECK(nearest_float("3.4028235677973366163e38") == std::numeric_limits<float>::max());
  CHECK(nearest_float("7.00649232162408535461864791644958e-46") == 0);
  CHECK(nearest_float("7.00649232162408535461864791644959e-46") ==
        std::numeric_limits<float>::denorm_min());
  CHECK(std::signbit(nearest_float("-1e-99999")));
  CHECK(nearest_float("1.1754943508e-38") == std::numeric_limits<float>::min());
  for (const std::string text : {"0.1", "+1.5", "-.5e-3", "1e-40", "1.17549430e-38", "8.5e22"}) {
    CAPTURE(text);
    CHECK(nearest_float(text) == to_float(parse_rational(text), Rounding::Nearest));
  }
}

TEST_CASE("nearest_float: half way between two numbers, beside it, and the usual print (#13)") {
  check_property("rounds to the nearest, ties to even", [](std::uint32_t bits) {
    const float low = std::abs(std::bit_cast<float>(bits));
    RC_PRE(std::isfinite(low) && low < std::numeric_limits<float>::max());
    std::array<char, 64> printed{};
    std::snprintf(printed.data(), printed.size(), "%.9g", static_cast<double>(low));
    RC_ASSERT(nearest_float(printed.data()) == low);
    const float high = std::nextafter(low, std::numeric_limits<float>::infinity());
    const auto [digits, exponent] = decimal_of((to_rational(low) + to_rational(high)) / 2);
    const bool low_is_even = (std::bit_cast<std::uint32_t>(low) & 1) == 0;
    RC_ASSERT(nearest_float(digits + exponent) == (low_is_even ? low : high));
    RC_ASSERT(nearest_float(digits + ".00001" + exponent) == high);
    const std::string below = to_string(Integer(Integer(digits) - 1));
    RC_ASSERT(nearest_float(below + ".99999" + exponent) == low);
  });
}

TEST_CASE("nearest_float: what is no number of binary32 (#13)") {
  for (const std::string text : {"", "-", "1e", "0x1p3", "1.2.3", "1/2"}) {
    CAPTURE(text);
    CHECK(error_of([&] { return nearest_float(text); }).code() == ErrorCode::Malformed);
  }
  for (const std::string text : {"nan", "-inf", "3.4028235677973366164e38", "-1e39", "1e400"}) {
    CAPTURE(text);
    CHECK(error_of([&] { return nearest_float(text); }).code() == ErrorCode::NotFinite);
  }
}

TEST_CASE("parse_number: integers and fractions are exact, decimals by choice") {
  const std::string large = "-123456789012345678901234567890";
  CHECK(to_string(parse_number(large, Decimal::Nearest)) == large);
  CHECK(parse_number("-6/4", Decimal::Nearest) == Rational(-3, 2));
  CHECK(parse_number("0.1", Decimal::Nearest) == to_rational(0.1));
  CHECK(parse_number("0.1", Decimal::Exact) == Rational(1, 10));
  CHECK(parse_number("0.1", Decimal::Nearest32) == to_rational(0.1f));
  CHECK(parse_number("16777217", Decimal::Nearest32) == 16777217);
  CHECK(error_of([] { return parse_number("1e400", Decimal::Exact); }).code() ==
        ErrorCode::NotFinite);
  CHECK(error_of([] { return parse_number("nan", Decimal::Exact); }).code() ==
        ErrorCode::NotFinite);
}

TEST_CASE("from_short_decimal: right where it decides, which it does for short decimals") {
  const auto check = [](const std::string& text, auto value, bool is_short) {
    CAPTURE(text);
    const std::errc status = from_short_decimal(text, value);
    CHECK(status == (is_short ? std::errc() : std::errc::result_out_of_range));
    if (!is_short) return;
    const Rational exact = parse_rational(text);
    CHECK(value == (std::is_same_v<decltype(value), float> ? to_float(exact, Rounding::Nearest)
                                                           : to_double(exact, Rounding::Nearest)));
  };
  for (const std::string text : {"0", "0.1", ".5", "5.", "1e22", "1.5E-3", "0.000123456", "8.5e+9",
                                 "9007199254740992e-22", "0e9999", "00.00e-99999"}) {
    check(text, 0.0, true);
  }
  double zero = 1;  // whatever its exponent
  CHECK(from_short_decimal("00.00e-99999999999999", zero) == std::errc());
  CHECK(zero == 0);
  for (const std::string text : {"0.1", "16777216e10", "16777216e-10", "8.5e9", "0.000123456"}) {
    check(text, 0.0f, true);
  }
  // Digits are counted modulo 2^64: the last of these are 0, 1 and 2 there.
  for (const std::string text :
       {"1e23", "9007199254740993", "12345678901234567890123", "1e-23", "18446744073709551616",
        "18446744073709551617", "36893488147419103234", "184467440737095516.16",
        "1e99999999999999999999", "1e-99999999999999999999"}) {
    check(text, 0.0, false);
  }
  for (const std::string text : {"1e11", "16777217", "1e-11"}) check(text, 0.0f, false);
  check_property("six digits round as the rationals they spell", [&](std::uint32_t bits) {
    std::array<char, 64> printed{};
    std::snprintf(printed.data(), printed.size(), "%.6g", (bits >> 8) * std::pow(0.1, bits % 16));
    check(printed.data(), 0.0, true);
  });
}

TEST_CASE("from_short_decimal: what is no decimal, and what is no number") {
  double value = 0;
  for (const std::string text :
       {"", "+", "-1", ".", "+1", "1e", "1e+", "1e+-1", "0x1p3", "1d3", "1,5", " 1", "1 ", "1.2.3",
        "e5", "1_000", "1/2", "1e5.", "infinit"}) {
    CAPTURE(text);
    CHECK(from_short_decimal(text, value) == std::errc::invalid_argument);
  }
  for (const std::string text : {"nan", "NaN", "inf", "INF", "Infinity", "nan(0)"}) {
    CAPTURE(text);
    CHECK(from_short_decimal(text, value) == std::errc());
    CHECK_FALSE(std::isfinite(value));
  }
}

TEST_CASE("in_quotes: short and printable") {
  CHECK(in_quotes("a\nb\x80") == "'a?b?'");
  CHECK(in_quotes(std::string(100, 'x')) == "'" + std::string(40, 'x') + "...'");
}
