// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include "convexact/geometry.hpp"
#include "number/arithmetic.hpp"

namespace convexact {

Sign side_of(const Halfspace& halfspace, const Point& x) {
  // x_k = m_k 2^unit_k with integers m_k; everything in units of the smallest, or of 1.
  std::array<int, 3> unit{};
  int smallest = 0;
  for (int k = 0; k < 3; ++k) {
    if (x[k] == 0) continue;
    unit[k] = unit_exponent(x[k]);
    smallest = std::min(smallest, unit[k]);
  }
  Integer sum = halfspace.offset(), term;
  mpz_mul_2exp(raw(sum), raw(sum), static_cast<mp_bitcnt_t>(-smallest));
  for (int k = 0; k < 3; ++k) {
    if (x[k] == 0) continue;
    mpz_set_d(raw(term), std::ldexp(x[k], -unit[k]));
    mpz_mul_2exp(raw(term), raw(term), static_cast<mp_bitcnt_t>(unit[k] - smallest));
    add_product(sum, term, halfspace.normal()[k]);
  }
  return sign_of(sum);
}

}  // namespace convexact
