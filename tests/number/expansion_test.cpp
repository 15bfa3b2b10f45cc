// SPDX-License-Identifier: MIT
// Expansions: every operation against rationals, and the shape that their proofs rely on.
#include "number/expansion.hpp"

#include <doctest/doctest.h>

#include "convexact/number.hpp"
#include "property.hpp"

using namespace convexact;

namespace {

template <std::size_t N>
Rational value(const Expansion<N>& e) {
  Rational total = 0;
  for (std::size_t i = 0; i < e.size; ++i) total += to_rational(e.terms[i]);
  return total;
}

/// Nonzero terms of growing magnitude that do not overlap: each is below the lowest bit of the
/// next.
template <std::size_t N>
bool is_nonoverlapping(const Expansion<N>& e) {
  for (std::size_t i = 0; i < e.size; ++i) {
    if (e.terms[i] == 0) return false;
    if (i == 0) continue;
    const Integer next = numerator(scale_by_power_of_two(to_rational(e.terms[i]), 1074));
    const auto lowest = static_cast<long>(lsb(abs(next))) - 1074;
    if (std::abs(e.terms[i - 1]) >= std::ldexp(1.0, static_cast<int>(lowest))) return false;
  }
  return true;
}

double make(std::int64_t mantissa, std::uint8_t shift) {
  return std::ldexp(static_cast<double>(mantissa), shift % 120 - 60);
}

}  // namespace

TEST_CASE("expansion: sums and products of two doubles are exact") {
  check_property("two doubles", [](std::int64_t m, std::int64_t n, std::uint8_t s) {
    const double x = make(m, s), y = make(n, static_cast<std::uint8_t>(s * 7));
    const TwoTerms sum = two_sum(x, y), product = two_product(x, y);
    RC_ASSERT(to_rational(sum.high) + to_rational(sum.low) == to_rational(x) + to_rational(y));
    RC_ASSERT(sum.high == x + y);
    RC_ASSERT(to_rational(product.high) + to_rational(product.low) ==
              to_rational(x) * to_rational(y));
    RC_ASSERT(product.high == x * y);
  });
}

TEST_CASE("expansion: sum, scale, product, sign and estimate") {
  check_property("expansions", [](const std::array<std::int64_t, 7>& m, std::uint64_t shifts) {
    std::array<double, 7> x;
    for (std::size_t i = 0; i < 7; ++i)
      x[i] = make(m[i], static_cast<std::uint8_t>(shifts >> (8 * i)));
    const auto e = sum(difference(x[0], x[1]), difference(x[2], x[3]));
    const auto scaled = scale(e, x[4]);
    const auto times = product(e, difference(x[5], x[6]));
    const auto nothing = sum(times, -times);
    const Rational exact =
        to_rational(x[0]) - to_rational(x[1]) + to_rational(x[2]) - to_rational(x[3]);
    RC_ASSERT(value(e) == exact);
    RC_ASSERT(value(scaled) == exact * to_rational(x[4]));
    RC_ASSERT(value(times) == exact * (to_rational(x[5]) - to_rational(x[6])));
    RC_ASSERT(nothing.size == 0u);
    RC_ASSERT(is_nonoverlapping(e) && is_nonoverlapping(scaled) && is_nonoverlapping(times));
    RC_ASSERT(times.sign() == sign_of(value(times)));
    RC_ASSERT(abs(to_rational(times.estimate()) - value(times)) <=
              abs(value(times)) * to_rational(16 * 0x1p-53));
  });
}

TEST_CASE("expansion: one without a place to spare is negated, and nothing behind it") {
  const Expansion<2> e = difference(1.0, 0x1p-80);
  REQUIRE(e.size == 2);
  const Expansion<2> negated = -e;
  CHECK(negated.size == 2);
  CHECK(negated.terms == std::array{0x1p-80, -1.0});
}
