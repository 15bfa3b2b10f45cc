// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include "convexact/number.hpp"
#include "number/arithmetic.hpp"

namespace convexact {
namespace {

// A fraction p / r > 0 times a power of two, as another such fraction, not reduced.
struct ScaledFraction {
  Integer p, r;

  ScaledFraction(const Rational& q, long exponent) : p(numerator(q)), r(denominator(q)) {
    (exponent > 0 ? p : r) <<= static_cast<unsigned long>(std::abs(exponent));
  }
};

bool is_power_of_two(mpz_srcptr r) { return mpz_scan1(r, 0) + 1 == mpz_sizeinbase(r, 2); }

// floor(log2(q)) for q > 0: the exponent gives it up to one, and a comparison decides.
long floor_log2(const Rational& q) {
  const mpq_srcptr fraction = q.backend().data();
  const long guess = exponent_of(q) - 1;
  if (is_power_of_two(mpq_denref(fraction))) return guess;
  const ScaledFraction scaled(q, -guess);
  return scaled.p < scaled.r ? guess - 1 : guess;
}

// Rounds |x| to a multiple of the unit in the last place of Float; `away` means towards infinity.
// Integers only: a Rational would be reduced after every operation, which takes most of the time.
template <class Float>
Float round_magnitude(const Rational& magnitude, Rounding rounding, bool away) {
  using Limits = std::numeric_limits<Float>;
  constexpr long kLeastUnit = Limits::min_exponent - Limits::digits;  // 2^-1074 for binary64
  const long exponent = floor_log2(magnitude);
  const long unit = std::max(exponent - Limits::digits + 1, kLeastUnit);
  const ScaledFraction scaled(magnitude, -unit);
  Integer whole, rest;
  divide_qr(scaled.p, scaled.r, whole, rest);
  const Integer twice = rest * 2;
  const bool odd = whole % 2 != 0;
  const bool bump = rounding == Rounding::Nearest ? twice > scaled.r || (twice == scaled.r && odd)
                                                  : away && rest != 0;
  if (bump) ++whole;
  // `whole` has at most digits + 1 bits (then a power of two), so both conversions are exact.
  const int size = static_cast<int>(bit_length(whole));
  if (size + unit > Limits::max_exponent) {
    const bool to_infinity = rounding == Rounding::Nearest || away;
    return to_infinity ? Limits::infinity() : Limits::max();
  }
  return static_cast<Float>(std::ldexp(whole.convert_to<double>(), static_cast<int>(unit)));
}

template <class Float>
Float round_to(const Rational& x, Rounding rounding) {
  if (x == 0) return 0;
  const bool negative = x < 0;
  const bool away = rounding == (negative ? Rounding::Down : Rounding::Up);
  const Float magnitude = round_magnitude<Float>(abs(x), rounding, away);
  return negative ? -magnitude : magnitude;
}

// Whether x is p / 2^k with |p| < 2^53 and far from the ends of the range: then it is a double.
bool is_surely_double(const Rational& x) {
  const mpq_srcptr q = x.backend().data();
  return mpz_sizeinbase(mpq_numref(q), 2) <= 53 && mpz_sizeinbase(mpq_denref(q), 2) <= 900 &&
         is_power_of_two(mpq_denref(q));
}

}  // namespace

double to_double(const Rational& x, Rounding rounding) {
  // Most numbers come from doubles. GMP truncates, so a double is converted exactly.
  if (is_surely_double(x)) return mpq_get_d(x.backend().data());
  return round_to<double>(x, rounding);
}
float to_float(const Rational& x, Rounding rounding) { return round_to<float>(x, rounding); }

}  // namespace convexact
