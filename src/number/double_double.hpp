// SPDX-License-Identifier: MIT
// double_double.hpp - an unevaluated sum of two doubles: 102 proven bits at a few flops each.
#pragma once
#include <cmath>

namespace convexact {

/// The number hi + lo, |lo| <= ulp(hi) / 2. Each operation x o y returns (x o y)(1 + e) with
/// |e| <= kUnit, as long as no intermediate result overflows or underflows; a caller has to exclude
/// both. Needs rounding to nearest and no contraction.
/// @par Source  [Dekker1971] for the exact sum and product; [Joldes2017] for the algorithms
/// and bounds: addition 3 u^2 + 13 u^3 (algorithm 6), product 7 u^2 (algorithm 10 with Dekker's
/// product), quotient 15 u^2 + 56 u^3 (algorithm 17), u = 2^-53.
class DoubleDouble {
 public:
  /// 15 u^2 + 56 u^3 < 2^-102.
  static constexpr double kUnit = 0x1p-102;

  constexpr DoubleDouble() = default;
  constexpr DoubleDouble(double x) : hi_(x) {}  // NOLINT: a double is one of these
  constexpr DoubleDouble(double hi, double lo) : hi_(hi), lo_(lo) {}

  constexpr double hi() const { return hi_; }
  constexpr double lo() const { return lo_; }

  /// a - b and a b exactly.
  static DoubleDouble difference(double a, double b) { return two_sum(a, -b); }
  static DoubleDouble product(double a, double b) {
    const double p = a * b;
    const Halves x = split(a), y = split(b);
    return {p, ((x.high * y.high - p) + x.high * y.low + x.low * y.high) + x.low * y.low};
  }

  friend DoubleDouble operator-(const DoubleDouble& x) { return {-x.hi_, -x.lo_}; }
  friend DoubleDouble operator+(const DoubleDouble& x, const DoubleDouble& y) {
    const DoubleDouble s = two_sum(x.hi_, y.hi_), t = two_sum(x.lo_, y.lo_);
    const DoubleDouble v = fast_two_sum(s.hi_, s.lo_ + t.hi_);
    return fast_two_sum(v.hi_, t.lo_ + v.lo_);
  }
  friend DoubleDouble operator-(const DoubleDouble& x, const DoubleDouble& y) { return x + (-y); }
  friend DoubleDouble operator*(const DoubleDouble& x, const DoubleDouble& y) {
    const DoubleDouble c = product(x.hi_, y.hi_);
    return fast_two_sum(c.hi_, c.lo_ + (x.hi_ * y.lo_ + x.lo_ * y.hi_));
  }
  friend DoubleDouble operator/(const DoubleDouble& x, const DoubleDouble& y) {
    const double quotient = x.hi_ / y.hi_;
    const DoubleDouble r = times(y, quotient);
    const double remainder = (x.hi_ - r.hi_) + (x.lo_ - r.lo_);
    return fast_two_sum(quotient, remainder / y.hi_);
  }
  DoubleDouble& operator+=(const DoubleDouble& y) { return *this = *this + y; }

  friend bool operator<(const DoubleDouble& x, const DoubleDouble& y) {
    return x.hi_ < y.hi_ || (x.hi_ == y.hi_ && x.lo_ < y.lo_);
  }
  friend bool operator>(const DoubleDouble& x, const DoubleDouble& y) { return y < x; }

 private:
  struct Halves {
    double high, low;
  };
  // Veltkamp: x = high + low, each of at most 26 bits.
  static Halves split(double x) {
    const double c = 0x1.0000002p27 * x;
    const double high = c - (c - x);
    return {high, x - high};
  }
  static DoubleDouble two_sum(double a, double b) {
    const double s = a + b;
    const double z = s - a;
    return {s, (a - (s - z)) + (b - z)};
  }
  // Exact if |a| >= |b|.
  static DoubleDouble fast_two_sum(double a, double b) {
    const double s = a + b;
    return {s, b - (s - a)};
  }
  static DoubleDouble times(const DoubleDouble& x, double y) {
    const DoubleDouble c = product(x.hi_, y);
    const DoubleDouble t = fast_two_sum(c.hi_, x.lo_ * y);
    return fast_two_sum(t.hi_, t.lo_ + c.lo_);
  }

  double hi_ = 0, lo_ = 0;
};

inline DoubleDouble abs(const DoubleDouble& x) { return x.hi() < 0 ? -x : x; }

}  // namespace convexact
