// SPDX-License-Identifier: MIT
// Directed rounding. Expected values come from the definition: the neighbours of x in the format.
#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "convexact/number.hpp"
#include "number/roundoff.hpp"
#include "property.hpp"
using namespace convexact;

namespace {
const Rational kTiny = scale_by_power_of_two(Rational(1), -1074);
constexpr double kMin = std::numeric_limits<double>::denorm_min();
constexpr double kMax = std::numeric_limits<double>::max();
constexpr double kInf = std::numeric_limits<double>::infinity();

double finite_double(std::uint64_t bits) {
  const double x = std::bit_cast<double>(bits);
  return std::isfinite(x) ? x : 1.0;
}
}  // namespace

TEST_CASE("to_double: a double comes back, in every direction") {
  check_property("a double comes back", [](std::uint64_t bits) {
    const double x = finite_double(bits);
    for (const Rounding r : {Rounding::Down, Rounding::Up, Rounding::Nearest}) {
      RC_ASSERT(to_double(to_rational(x), r) == x);
    }
  });
}

TEST_CASE("to_double: between two neighbours each direction takes the one it names") {
  check_property("the named neighbour", [](std::uint64_t bits, std::uint32_t part) {
    const double low = finite_double(bits), high = std::nextafter(low, kInf);
    RC_PRE(std::isfinite(high));
    // x = low + t (high - low), 0 < t < 1
    const Rational t(Integer(part) + 1, (Integer(1) << 32) + 1);
    const Rational x = to_rational(low) + t * (to_rational(high) - to_rational(low));
    RC_ASSERT(to_double(x, Rounding::Down) == low);
    RC_ASSERT(to_double(x, Rounding::Up) == high);
    RC_ASSERT(to_double(x, Rounding::Nearest) == (2 * t < 1 ? low : high));
  });
}

TEST_CASE("to_double: all small fractions, by their neighbours and by IEEE 754's division") {
  for (int q = 1; q <= 70; ++q) {
    for (int p = 1; p <= 200; ++p) {
      CAPTURE(p);
      CAPTURE(q);
      const Rational x(p, q);
      const double low = to_double(x, Rounding::Down), high = to_double(x, Rounding::Up);
      CHECK(to_rational(low) <= x);
      CHECK(to_rational(high) >= x);
      CHECK((low == high ? to_rational(low) == x : std::nextafter(low, kInf) == high));
      CHECK(to_double(x, Rounding::Nearest) == static_cast<double>(p) / q);  // IEEE 754 division
    }
  }
}

TEST_CASE("to_double: subnormals") {
  const Rational third = kTiny / 3;
  CHECK(to_double(third, Rounding::Down) == 0.0);
  CHECK(to_double(third, Rounding::Up) == kMin);
  CHECK(to_double(third, Rounding::Nearest) == 0.0);
  CHECK(std::signbit(to_double(-third, Rounding::Up)));
  CHECK(to_double(-third, Rounding::Down) == -kMin);
  CHECK(to_double(kTiny / 2, Rounding::Nearest) == 0.0);           // half: to even
  CHECK(to_double(kTiny * 3 / 2, Rounding::Nearest) == 2 * kMin);  // half: to even
  CHECK(to_double(kTiny * 5 / 2, Rounding::Nearest) == 2 * kMin);
}

TEST_CASE("to_double: beyond the largest double") {
  const Rational huge = to_rational(kMax) * 2;
  CHECK(to_double(huge, Rounding::Down) == kMax);
  CHECK(to_double(huge, Rounding::Up) == kInf);
  CHECK(to_double(huge, Rounding::Nearest) == kInf);
  CHECK(to_double(-huge, Rounding::Up) == -kMax);
  CHECK(to_double(-huge, Rounding::Down) == -kInf);
  // Just below the middle between the largest double and 2^1024.
  const Rational below = scale_by_power_of_two(Rational((Integer(1) << 54) - 1), 970) - 1;
  CHECK(to_double(below, Rounding::Nearest) == kMax);
  CHECK(to_double(below + 1, Rounding::Nearest) == kInf);
}

TEST_CASE("to_float: rounds once") {
  // 1 + 2^-24 + 2^-60 is above the half way; via double it would fall on it and go to even.
  const Rational x =
      1 + scale_by_power_of_two(Rational(1), -24) + scale_by_power_of_two(Rational(1), -60);
  CHECK(to_float(x, Rounding::Nearest) == 1.0f + 0x1p-23f);
  CHECK(to_float(x, Rounding::Down) == 1.0f);
  CHECK(to_float(to_rational(1e300), Rounding::Nearest) == std::numeric_limits<float>::infinity());
  CHECK(to_float(scale_by_power_of_two(Rational(1), -149), Rounding::Nearest) ==
        std::numeric_limits<float>::denorm_min());
}

TEST_CASE("next_above, next_below: as nextafter() has it, for doubles of every kind") {
  const auto agree = [](double x) {
    const auto bits = [](double y) { return std::bit_cast<std::uint64_t>(y); };
    return bits(next_above(x)) == bits(std::nextafter(x, kInf)) &&
           bits(next_below(x)) == bits(std::nextafter(x, -kInf));
  };
  for (const double x : {0.0, kMin, std::numeric_limits<double>::min(), 1.0, 0x1p52, 0x1p-1022,
                         std::nextafter(1.0, 0.0), kMax, kInf}) {
    CAPTURE(x);
    CHECK(agree(x));
    CHECK(agree(-x));
  }
  for (std::uint64_t k = 0; k < 4096; ++k) {  // every exponent, with either sign
    CHECK(agree(finite_double(k << 52)));
    CHECK(agree(finite_double((k << 52) + 12345)));
  }
  CHECK(std::isnan(next_above(std::numeric_limits<double>::quiet_NaN())));
  CHECK(std::isnan(next_below(std::numeric_limits<double>::quiet_NaN())));
}
