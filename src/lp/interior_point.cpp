// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>

#include "convexact/linear_program.hpp"

namespace convexact {

RationalPoint round_to_grid(const RationalPoint& x, long exponent) {
  RationalPoint rounded;
  for (int k = 0; k < 3; ++k) {
    const Rational steps = scale_by_power_of_two(x[k], -exponent) + Rational(1, 2);
    Integer whole;
    mpz_fdiv_q(whole.backend().data(), mpq_numref(steps.backend().data()),
               mpq_denref(steps.backend().data()));
    rounded[k] = scale_by_power_of_two(Rational(whole), exponent);
  }
  return rounded;
}

bool is_strictly_inside(std::span<const Halfspace> halfspaces, const RationalPoint& x) {
  return std::all_of(halfspaces.begin(), halfspaces.end(),
                     [&](const Halfspace& halfspace) { return halfspace(x) < 0; });
}

std::optional<RationalPoint> short_dyadic_interior_point(std::span<const Halfspace> halfspaces,
                                                         const RationalPoint& inside) {
  if (!is_strictly_inside(halfspaces, inside)) return std::nullopt;
  if (inside.isZero(0)) return inside;
  // |p/q| < 2^(bits(p) - bits(q) + 1), which rounds to 0 in steps of twice that.
  long exponent = std::numeric_limits<long>::min();
  for (const Rational& x : inside) {
    if (x == 0) continue;
    const long bits =
        static_cast<long>(bit_length(numerator(x))) - static_cast<long>(bit_length(denominator(x)));
    exponent = std::max(exponent, bits + 2);
  }
  // Ends: the interior is open, and the roundings converge to a point of it.
  RationalPoint rounded = round_to_grid(inside, exponent);
  while (!is_strictly_inside(halfspaces, rounded)) rounded = round_to_grid(inside, --exponent);
  return rounded;
}

}  // namespace convexact
