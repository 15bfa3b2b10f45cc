// SPDX-License-Identifier: MIT
// roundoff.hpp - the error of one operation on doubles: its bound, sums and products with it, and
// intervals that hold it.
#pragma once
#include <bit>
#include <cstdint>
#include <limits>

namespace convexact {

/// Half the distance between 1 and the next double: x op y is (x op y)(1 + e) with
/// |e| <= kUnitRoundoff, where nothing overflows or underflows.
inline constexpr double kUnitRoundoff = 0x1p-53;

/// high + low, high being the rounded result of an operation and low its error.
struct TwoTerms {
  double high, low;
};

// All of these need rounding to nearest and no contraction. A sum is exact if it does not overflow;
// a product if, in addition, its error is a multiple of 2^-1074.

/// x + y = high + low exactly. [Knuth1997, sec. 4.2.2]
constexpr TwoTerms two_sum(double x, double y) {
  const double high = x + y, y_part = high - x, x_part = high - y_part;
  return {high, (x - x_part) + (y - y_part)};
}

/// The same for |x| >= |y| or x = 0. [Dekker1971]
constexpr TwoTerms fast_two_sum(double x, double y) {
  const double high = x + y;
  return {high, y - (high - x)};
}

/// A double as the sum of two with 26 significant bits each. [Dekker1971]
constexpr TwoTerms split(double x) {
  const double shifted = 0x8000001p0 * x;  // 2^27 + 1
  const double high = shifted - (shifted - x);
  return {high, x - high};
}

/// x * y = high + low exactly. [Dekker1971]
constexpr TwoTerms two_product(double x, double y) {
  const double high = x * y;
  const TwoTerms s = split(x), t = split(y);
  const double rest = ((high - s.high * t.high) - s.low * t.high) - s.high * t.low;
  return {high, s.low * t.low - rest};
}

/// One double further up or down: the most that a single rounding may have changed. As
/// std::nextafter() towards an infinity, but without a call: the bits of a double are in the order
/// of its size.
[[nodiscard]] inline double next_above(double x) {
  if (x == 0) return std::numeric_limits<double>::denorm_min();
  if (!(x < std::numeric_limits<double>::infinity())) return x;  // nor is NaN
  const auto bits = std::bit_cast<std::uint64_t>(x);
  return std::bit_cast<double>(x > 0 ? bits + 1 : bits - 1);
}
[[nodiscard]] inline double next_below(double x) { return -next_above(-x); }

/// lower <= x <= upper for some x >= 0. The ends of a product or quotient are rounded to nearest:
/// after n operations in a row they have to be moved apart by n roundings.
template <class Scalar>
struct Interval {
  Scalar lower, upper;

  friend Interval operator*(const Interval& a, const Interval& b) {
    return {a.lower * b.lower, a.upper * b.upper};
  }
  friend Interval operator/(const Interval& a, const Interval& b) {
    return {a.lower / b.upper, a.upper / b.lower};
  }
};

}  // namespace convexact
