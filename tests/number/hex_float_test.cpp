// SPDX-License-Identifier: MIT
// Hexadecimal numbers: by closed form, and against what the C library prints for doubles.
#include <doctest/doctest.h>

#include <bit>
#include <cstdio>
#include <limits>

#include "convexact/error.hpp"
#include "number/random.hpp"
#include "number/text.hpp"

using namespace convexact;

TEST_CASE("hex float: digits, point and exponent, each of which may be missing") {
  CHECK(parse_hex_float("0x1.8p-3") == Rational(3, 16));
  CHECK(parse_hex_float("-0x10") == -16);
  CHECK(parse_hex_float("+0X.8P+1") == 1);
  CHECK(parse_hex_float("0xa.p0") == 10);
  CHECK(parse_hex_float("0x0p99999") == 0);
  CHECK(parse_hex_float("-0x0.0") == 0);
  CHECK(parse_hex_float("0x123456789abcdef0123456789") ==
        Rational(Integer("0x123456789abcdef0123456789")));
  CHECK(is_hex_float("0x"));
  CHECK_FALSE(is_hex_float("10"));
  CHECK_FALSE(is_hex_float("-"));
}

TEST_CASE("hex_float: what glibc's %a prints") {
  CHECK(hex_float(0.0) == "0x0p+0");
  CHECK(hex_float(-0.0) == "-0x0p+0");
  CHECK(hex_float(0.1875) == "0x1.8p-3");
  CHECK(hex_float(0x1p-1023) == "0x0.8p-1022");
#ifdef __GLIBC__
  Random random(11);
  const auto check = [](double x) {
    char text[64];
    std::snprintf(text, sizeof text, "%a", x);
    CHECK(hex_float(x) == text);
  };
  for (int k = 0; k < 2000; ++k) {
    const std::uint64_t bits = random(), exponent = k % 2 == 0 ? bits >> 52 & 0x7ff : 0;
    const std::uint64_t cleared = bits >> 12 << (random() % 52);  // zeros at its end
    const std::uint64_t mantissa = cleared & 0xfffffffffffff;
    if (exponent != 0x7ff)
      check(std::bit_cast<double>(bits >> 63 << 63 | exponent << 52 | mantissa));
  }
#endif
}

TEST_CASE("hex float: every double as %a prints it comes back") {
  Random random(7);
  const auto check = [](double x) {
    char text[64];
    std::snprintf(text, sizeof text, "%a", x);
    CAPTURE(text);
    CHECK(parse_hex_float(text) == to_rational(x));
  };
  for (const double x :
       {1.0, -0.1, std::numeric_limits<double>::max(), std::numeric_limits<double>::min(),
        std::numeric_limits<double>::denorm_min()}) {
    check(x);
  }
  for (int k = 0; k < 200; ++k) check((uniform_unit(random) - 0.5) * std::pow(2.0, k - 100));
}

TEST_CASE("hex float: anything else is malformed") {
  for (const char* text :
       {"", "0x", "0x.", "-0x", "0xp1", "0x1p", "0x1p+", "0x1p++1", "0x1.8.1", "0x1 ", "x1", "1.5",
        "0x1p100001", "0x1p-99999999999999999999", "0xg", "--0x1", "inf", "nan"}) {
    CAPTURE(text);
    CHECK_THROWS_AS((void)parse_hex_float(text), Error);
  }
}
