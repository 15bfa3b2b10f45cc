// SPDX-License-Identifier: MIT
#include "report/error_size.hpp"

#include <cmath>

#include "convexact/number.hpp"

namespace convexact {

double log2_of(const Rational& x) {
  const long s =
      static_cast<long>(bit_length(numerator(x))) - static_cast<long>(bit_length(denominator(x)));
  return std::log2(to_double(scale_by_power_of_two(x, -s), Rounding::Nearest)) +
         static_cast<double>(s);
}

ErrorSize error_size(const Rational& error) {
  if (error == 0) return {};
  const Rational size = abs(error);
  return {to_double(size, Rounding::Nearest), -log2_of(size)};
}

ErrorSize root_size(const Rational& x) {
  if (x == 0) return {};
  const double bits = -log2_of(x) / 2;
  return {std::exp2(-bits), bits};
}

ErrorSize relative_error(const Rational& computed, const Rational& exact) {
  if (computed == exact) return {};
  return error_size((computed - exact) / exact);
}

}  // namespace convexact
