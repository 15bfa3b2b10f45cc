// SPDX-License-Identifier: MIT
// MPFR in the formats of C's float and double against what the processor computes.
#include "number/mpfr_scalar.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

using namespace convexact;

namespace {

using Binary32 = MpfrScalar<24, ExponentsOf::Binary>;
using Binary64 = MpfrScalar<53, ExponentsOf::Binary>;

// The same number, or both not a number; zeros by their sign.
template <class Number>
bool same(Number a, double b) {
  return std::isnan(a) ? std::isnan(b) : a == b && std::signbit(a) == std::signbit(b);
}

// Each operation on each pair.
template <class Number, class Scalar>
void check_operations(const std::vector<Number>& numbers) {
  for (const Number a : numbers) {
    for (const Number b : numbers) {
      CAPTURE(a);
      CAPTURE(b);
      const Scalar x(a), y(b);
      CHECK(same(a, leading(x)));
      CHECK(same(static_cast<Number>(a + b), leading(x + y)));
      CHECK(same(static_cast<Number>(a - b), leading(x - y)));
      CHECK(same(static_cast<Number>(a * b), leading(x * y)));
      CHECK(same(static_cast<Number>(a / b), leading(x / y)));
      CHECK((a < b) == (x < y));
      CHECK((a <= b) == (x <= y));
    }
  }
}

// Powers of two around every limit, their neighbours, and random bits.
template <class Number, class Bits>
std::vector<Number> delicate_numbers(std::size_t random_ones) {
  using Limits = std::numeric_limits<Number>;
  const Number smallest = Limits::denorm_min(), least = Limits::min();
  std::vector<Number> numbers = {
      0,     -Number(0),          Limits::infinity(), -Limits::infinity(),
      1,     Limits::quiet_NaN(), Limits::max(),      smallest,
      least, 3 * smallest,        Number(0.5),        Number(0.75)};
  for (const Number x : {least, std::sqrt(least), std::sqrt(smallest), std::sqrt(Limits::max())}) {
    for (const Number y : {x, x / 2, x * 2}) {
      numbers.push_back(y);
      numbers.push_back(std::nextafter(y, Number(0)));
      numbers.push_back(-std::nextafter(y, Number(1)));
    }
  }
  std::mt19937_64 random(7);
  while (random_ones-- > 0) numbers.push_back(std::bit_cast<Number>(static_cast<Bits>(random())));
  return numbers;
}

}  // namespace

TEST_CASE("MPFR scalar: binary32 is C's float, bit for bit") {
  check_operations<float, Binary32>(delicate_numbers<float, std::uint32_t>(120));
}

TEST_CASE("MPFR scalar: binary64 is C's double, bit for bit") {
  check_operations<double, Binary64>(delicate_numbers<double, std::uint64_t>(120));
}

// The processor rounds a double to a float: another operation whose results may be subnormal.
TEST_CASE("MPFR scalar: doubles and rationals become floats with one rounding") {
  std::mt19937_64 random(11);
  std::uniform_int_distribution<int> exponent(-1000, 50), near(-165, -120);
  for (int i = 0; i < 4000; ++i) {
    const double mantissa = 1 + std::ldexp(static_cast<double>(random() >> 12), -52);
    const double x =
        std::ldexp(i % 2 == 0 ? mantissa : -mantissa, i % 3 ? near(random) : exponent(random));
    CAPTURE(x);
    CHECK(same(static_cast<float>(x), leading(Binary32(x))));
    CHECK(same(static_cast<float>(x), leading(Binary32(to_rational(x)))));
  }
  // Half way between 0 and the smallest float, and next to it.
  const Rational half = to_rational(0x1p-150), little(1, Integer(1) << 400);
  CHECK(leading(Binary32(half)) == 0);
  CHECK(leading(Binary32(Rational(half + little))) == 0x1p-149);
  CHECK(leading(Binary32(Rational(half - little))) == 0);
  CHECK(leading(Binary32(Rational(-half - little))) == -0x1p-149);
  CHECK(leading(Binary32(Rational(3 * half))) == 0x1p-148);  // ties go to even
}

TEST_CASE("MPFR scalar: a copy is a number of its own") {
  MpfrScalar<256> a(1.5);
  const MpfrScalar<256> b = a;
  a = a * a;
  CHECK(leading(a) == 2.25);
  CHECK(leading(b) == 1.5);
  CHECK(exactly(MpfrScalar<1024>(1.0) / MpfrScalar<1024>(3.0)) != Rational(1, 3));
  CHECK(exactly(MpfrScalar<64>(Rational(3, 4))) == Rational(3, 4));
}
