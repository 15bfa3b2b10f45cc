// SPDX-License-Identifier: MIT
#include "implicit/implicit_value.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace convexact {
namespace {

// An interval of doubles. Each operation rounds to nearest, and then each end to its neighbour
// outward. An overflow or NaN gives the interval of all numbers, which is always true.
struct DoubleRange {
  double low, high;
};

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr DoubleRange kAllNumbers{-kInfinity, kInfinity};

DoubleRange outward(double low, double high) {
  if (!std::isfinite(low) || !std::isfinite(high)) return kAllNumbers;
  return {std::nextafter(low, -kInfinity), std::nextafter(high, kInfinity)};
}

DoubleRange operator+(const DoubleRange& a, const DoubleRange& b) {
  return outward(a.low + b.low, a.high + b.high);
}
DoubleRange operator-(const DoubleRange& a, const DoubleRange& b) {
  return outward(a.low - b.high, a.high - b.low);
}

// The ends of a product or quotient are at ends of the arguments. A NaN among them gives all
// numbers, since min and max could lose it.
DoubleRange outward(const std::array<double, 4>& ends) {
  if (!std::all_of(ends.begin(), ends.end(), [](double x) { return std::isfinite(x); })) {
    return kAllNumbers;
  }
  return outward(*std::min_element(ends.begin(), ends.end()),
                 *std::max_element(ends.begin(), ends.end()));
}

DoubleRange operator*(const DoubleRange& a, const DoubleRange& b) {
  return outward({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
}

struct DoubleNumbers {
  using Number = DoubleRange;

  static Number number(double x) { return {x, x}; }
  static Number entry(const ImplicitRotation& rotation, std::size_t k) {
    return {rotation.rounded[k].low, rotation.rounded[k].high};
  }
  static Number quotient(const Number& a, const Number& b) {
    if (!(b.low > 0)) return kAllNumbers;  // too close to 0 for doubles
    return outward({a.low / b.low, a.low / b.high, a.high / b.low, a.high / b.high});
  }
  static Number root(const Number& a) {
    const Number root = outward(std::sqrt(std::max(a.low, 0.0)), std::sqrt(std::max(a.high, 0.0)));
    return {std::max(root.low, 0.0), root.high};
  }
  static Number least(const Number& a, const Number& b) {
    return {std::min(a.low, b.low), std::min(a.high, b.high)};
  }
  static Number greatest(const Number& a, const Number& b) {
    return {std::max(a.low, b.low), std::max(a.high, b.high)};
  }
  static Number magnitude(const Number& a) {
    if (a.low >= 0) return a;
    if (a.high <= 0) return {-a.high, -a.low};
    return {0, std::max(-a.low, a.high)};
  }
  static Number square(const Number& a) {
    const Number size = magnitude(a), square = size * size;
    return {std::max(square.low, 0.0), square.high};
  }
};

// Intervals of many bits; with numbers that come from doubles they do not overflow.
struct BigNumbers {
  using Number = Enclosure;
  long precision;

  Number number(double x) const { return number(to_rational(x)); }
  Number number(const Rational& x) const { return Enclosure(x, precision); }
  Number entry(const ImplicitRotation& rotation, std::size_t k) const {
    return number(rotation.exact[k]);
  }
  Number quotient(const Number& a, const Number& b) const { return a / b; }
  Number root(const Number& a) const { return sqrt(a); }
  Number least(const Number& a, const Number& b) const {
    return {std::min(a.low(), b.low()), std::min(a.high(), b.high()), precision};
  }
  Number greatest(const Number& a, const Number& b) const {
    return {std::max(a.low(), b.low()), std::max(a.high(), b.high()), precision};
  }
  Number magnitude(const Number& a) const { return greatest(a, -a); }
  Number square(const Number& a) const {
    const Number size = magnitude(a);
    const Enclosure nonnegative(std::max<Rational>(size.low(), 0), size.high(), precision);
    return nonnegative * nonnegative;
  }
};

}  // namespace

ImplicitRange enclose_value(const ImplicitShape& shape, const Point& x) {
  const ImplicitValue<DoubleNumbers> value{DoubleNumbers{}};
  const auto number = [&](int k) { return DoubleNumbers::number(x[k]); };
  const DoubleRange range = value(shape, {number(0), number(1), number(2)});
  return {range.low, range.high};
}

Enclosure enclose_value(const ImplicitShape& shape, const RationalPoint& x, long precision) {
  const BigNumbers numbers{precision};
  const ImplicitValue<BigNumbers> value{numbers};
  return value(shape, {numbers.number(x[0]), numbers.number(x[1]), numbers.number(x[2])});
}

}  // namespace convexact
