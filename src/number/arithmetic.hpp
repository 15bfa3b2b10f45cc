// SPDX-License-Identifier: MIT
// arithmetic.hpp - small exact arithmetic: exponents, common denominators, dot products, sums.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "convexact/number.hpp"

namespace convexact {

// GMP's own numbers behind ours, for the loops in which a temporary per operation would cost most
// of the time.
inline auto* raw(Integer& x) { return x.backend().data(); }
inline const auto* raw(const Integer& x) { return x.backend().data(); }

/// sum += a b and sum -= a b, without a temporary.
inline void add_product(Integer& sum, const Integer& a, const Integer& b) {
  mpz_addmul(raw(sum), raw(a), raw(b));
}
inline void subtract_product(Integer& sum, const Integer& a, const Integer& b) {
  mpz_submul(raw(sum), raw(a), raw(b));
}

/// The lexicographic order of points by their coordinates.
template <class Coordinates>
[[nodiscard]] bool precedes(const Coordinates& a, const Coordinates& b) {
  return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

/// Dot product, without temporaries.
[[nodiscard]] Integer dot(const IntegerVector3& a, const IntegerVector3& b);

/// The e with 2^(e-1) <= |x| < 2^e; 0 for x = 0. Precondition: x is finite.
[[nodiscard]] inline int exponent_of(double x) {
  int exponent = 0;
  (void)std::frexp(x, &exponent);
  return exponent;
}

/// The largest e <= exponent_of(x) - 53, but at least -1074: x is an integer times 2^e, and that
/// integer is below 2^53. Precondition: x is finite.
[[nodiscard]] inline int unit_exponent(double x) { return std::max(exponent_of(x) - 53, -1074); }

/// Each component rounded to nearest.
[[nodiscard]] inline Vector3<double> nearest(const RationalVector3& x) {
  return {to_double(x[0], Rounding::Nearest), to_double(x[1], Rounding::Nearest),
          to_double(x[2], Rounding::Nearest)};
}

/// An e with 2^(e-2) < |x| < 2^e, from the lengths of x alone. Precondition: x != 0.
[[nodiscard]] long exponent_of(const Rational& x);

/// The largest exponent_of() of the coordinates that are not 0; none if all of them are 0.
[[nodiscard]] std::optional<long> largest_exponent(std::span<const RationalVector3> points);

/// The largest integer that is at most x.
[[nodiscard]] Integer floor_of(const Rational& x);

/// Bits of the longest component; 0 for the zero vector.
[[nodiscard]] std::size_t bit_length(const IntegerVector3& v);

/// v with its least common denominator.
[[nodiscard]] HomogeneousPoint clear_denominators(const RationalVector3& v);

/// (v, w) times the least common denominator of all four, which is positive.
[[nodiscard]] HomogeneousPoint clear_denominators(const RationalVector3& v, const Rational& w);

/// Greatest common divisor, >= 0; gcd(0, 0) = 0.
[[nodiscard]] Integer gcd(const Integer& a, const Integer& b);

/// Divides (x, d), not all zero, by the greatest common divisor of all four.
void make_primitive(IntegerVector3& x, Integer& d);

/// A nonzero vector divided by the greatest common divisor of its components.
[[nodiscard]] IntegerVector3 primitive_direction(const IntegerVector3& v);

/// n >= 0 rationals times their least common denominator, which is returned (1 if n = 0).
/// @param integers  Receives the multiples; n entries.
Integer clear_denominators(std::span<const Rational> values, std::span<Integer> integers);

/// The positive multiple of n >= 0 rationals that consists of coprime integers; zeros remain zeros.
/// @param integers  Receives the multiple; n entries.
void make_primitive(std::span<const Rational> values, std::span<Integer> integers);

/// The exact sum of n terms; 0 for none. Terms are added in pairs, the sums in pairs again, and so
/// on: the bits of the denominators pile up only towards the end. Adding from left to right would
/// make every addition as long as the last one.
/// @par Cost  O(log n) times that of the last addition when denominators have little in common.
[[nodiscard]] Rational balanced_sum(std::vector<Rational> terms);

}  // namespace convexact
