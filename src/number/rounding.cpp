// SPDX-License-Identifier: MIT
#include "convexact/number/rounding.hpp"

#include <cmath>
#include <limits>

namespace convexact {
namespace {

// floor(log2(q)) for q > 0: the bit lengths tell it up to one, a comparison decides.
long floor_log2(const Rational& q) {
  const Integer p = numerator(q), r = denominator(q);
  const long guess = static_cast<long>(bit_length(p)) - static_cast<long>(bit_length(r));
  return scale_by_power_of_two(q, -guess) < 1 ? guess - 1 : guess;
}

// Rounds |x| to a multiple of the unit in the last place of Float; `away` means towards infinity.
template <class Float>
Float round_magnitude(const Rational& magnitude, Rounding rounding, bool away) {
  using Limits = std::numeric_limits<Float>;
  constexpr long kLeastUnit = Limits::min_exponent - Limits::digits;  // 2^-1074 for binary64
  const long exponent = floor_log2(magnitude);
  const long unit = std::max(exponent - Limits::digits + 1, kLeastUnit);
  const Rational scaled = scale_by_power_of_two(magnitude, -unit);
  Integer whole = numerator(scaled) / denominator(scaled);
  const Rational rest = scaled - Rational(whole);
  const Rational half(1, 2);
  const bool odd = whole % 2 != 0;
  const bool bump =
      rounding == Rounding::Nearest ? rest > half || (rest == half && odd) : away && rest != 0;
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

}  // namespace

double to_double(const Rational& x, Rounding rounding) { return round_to<double>(x, rounding); }
float to_float(const Rational& x, Rounding rounding) { return round_to<float>(x, rounding); }

}  // namespace convexact
