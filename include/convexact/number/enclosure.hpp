// SPDX-License-Identifier: MIT
// enclosure.hpp - an interval that certainly holds a real number, with ends of any precision.
#pragma once
#include <optional>
#include <span>

#include "convexact/number/big_float.hpp"
#include "convexact/number/rational.hpp"

namespace convexact {

/// A closed interval [low, high] with binary floating-point ends of `precision` bits. Every
/// operation rounds its lower end down and its upper end up, so the interval holds the exact result
/// for all exact arguments in the intervals it was given.
///
/// The result has the larger of the precisions of the arguments. Ends are always finite: a result
/// beyond 2^(2^30) throws Error Unrepresentable. One below 2^-(2^30) widens to zero and stays true.
class Enclosure {
 public:
  /// [0, 0].
  explicit Enclosure(long precision) : low_(precision), high_(precision) {}
  /// The narrowest interval around x; a point if `precision` bits hold x.
  Enclosure(const Rational& x, long precision);
  Enclosure(const Integer& x, long precision);
  /// The narrowest interval around [low, high], low <= high.
  Enclosure(const Rational& low, const Rational& high, long precision);
  static Enclosure pi(long precision);

  long precision() const { return low_.precision(); }
  Rational low() const { return low_.to_rational(); }
  Rational high() const { return high_.to_rational(); }
  Rational width() const { return high() - low(); }
  double low_double() const;   ///< The largest double <= low, -infinity if there is none.
  double high_double() const;  ///< The smallest double >= high, infinity if there is none.

  /// The sign of every number in the interval; nothing if they differ.
  std::optional<Sign> sign() const;
  bool contains(const Rational& x) const { return low() <= x && x <= high(); }

  Enclosure operator-() const;
  Enclosure& operator+=(const Enclosure& other);
  Enclosure& operator-=(const Enclosure& other) { return *this += -other; }
  Enclosure& operator*=(const Enclosure& other);
  /// @throws Error InvalidArgument unless the sign of the divisor is certain and not zero.
  Enclosure& operator/=(const Enclosure& other);
  friend Enclosure operator+(Enclosure a, const Enclosure& b) { return a += b; }
  friend Enclosure operator-(Enclosure a, const Enclosure& b) { return a -= b; }
  friend Enclosure operator*(Enclosure a, const Enclosure& b) { return a *= b; }
  friend Enclosure operator/(Enclosure a, const Enclosure& b) { return a /= b; }

  /// Square root of a number that the caller knows to be >= 0; what lies below 0 is cut off.
  /// @throws Error InvalidArgument if the interval is below 0.
  friend Enclosure sqrt(const Enclosure& x);
  /// The angle in [0, pi] between the x axis and the point (x, y), y >= 0 and not both zero.
  /// @throws Error InvalidArgument if y may be negative, or if the box holds the origin.
  friend Enclosure atan2(const Enclosure& y, const Enclosure& x);

 private:
  void widen_to(long precision);
  void require_finite() const;
  BigFloat low_, high_;
};

// Visible also where no argument is an Enclosure yet.
Enclosure sqrt(const Enclosure& x);
Enclosure atan2(const Enclosure& y, const Enclosure& x);

/// The sum of exact terms, each rounded outward once and once more when added: n terms cost about
/// log2(n) + 1 bits. Zero for no terms.
[[nodiscard]] Enclosure enclose_sum(std::span<const Rational> terms, long precision);

}  // namespace convexact
