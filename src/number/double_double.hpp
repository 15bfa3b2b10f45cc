// SPDX-License-Identifier: MIT
// double_double.hpp - an unevaluated sum of two doubles: 102 proven bits at a few flops each.
#pragma once
#include "number/roundoff.hpp"

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
  constexpr DoubleDouble(const TwoTerms& t) : hi_(t.high), lo_(t.low) {}  // NOLINT: likewise

  constexpr double hi() const { return hi_; }
  constexpr double lo() const { return lo_; }

  /// a - b and a b exactly.
  static DoubleDouble difference(double a, double b) { return two_sum(a, -b); }
  static DoubleDouble product(double a, double b) { return two_product(a, b); }

  friend constexpr DoubleDouble operator-(const DoubleDouble& x) { return {-x.hi_, -x.lo_}; }
  friend constexpr DoubleDouble operator+(const DoubleDouble& x, const DoubleDouble& y) {
    const TwoTerms s = two_sum(x.hi_, y.hi_), t = two_sum(x.lo_, y.lo_);
    const TwoTerms v = fast_two_sum(s.high, s.low + t.high);
    return fast_two_sum(v.high, t.low + v.low);
  }
  friend constexpr DoubleDouble operator-(const DoubleDouble& x, const DoubleDouble& y) {
    return x + (-y);
  }
  friend constexpr DoubleDouble operator*(const DoubleDouble& x, const DoubleDouble& y) {
    const TwoTerms c = two_product(x.hi_, y.hi_);
    return fast_two_sum(c.high, c.low + (x.hi_ * y.lo_ + x.lo_ * y.hi_));
  }
  friend constexpr DoubleDouble operator/(const DoubleDouble& x, const DoubleDouble& y) {
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
  static constexpr DoubleDouble times(const DoubleDouble& x, double y) {
    const TwoTerms c = two_product(x.hi_, y);
    const TwoTerms t = fast_two_sum(c.high, x.lo_ * y);
    return fast_two_sum(t.high, t.low + c.low);
  }

  double hi_ = 0, lo_ = 0;
};

inline DoubleDouble abs(const DoubleDouble& x) { return x.hi() < 0 ? -x : x; }

}  // namespace convexact
