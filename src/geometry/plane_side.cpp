// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include "convexact/predicates.hpp"

namespace convexact {

Sign side_of(const Halfspace& halfspace, const Point& x) {
  // x_k = m_k 2^unit_k with integers m_k; everything in units of the smallest, or of 1.
  std::array<int, 3> unit{};
  std::array<double, 3> mantissa{};
  int smallest = 0;
  for (int k = 0; k < 3; ++k) {
    if (x[k] == 0) continue;
    int exponent = 0;
    mantissa[k] = std::ldexp(std::frexp(x[k], &exponent), 53);
    unit[k] = exponent - 53;
    smallest = std::min(smallest, unit[k]);
  }
  Integer sum = halfspace.offset(), term;
  mpz_t &s = sum.backend().data(), &t = term.backend().data();
  mpz_mul_2exp(s, s, static_cast<mp_bitcnt_t>(-smallest));
  for (int k = 0; k < 3; ++k) {
    if (mantissa[k] == 0) continue;
    mpz_set_d(t, mantissa[k]);
    mpz_mul(t, t, halfspace.normal()[k].backend().data());
    mpz_mul_2exp(t, t, static_cast<mp_bitcnt_t>(unit[k] - smallest));
    mpz_add(s, s, t);
  }
  return sign_of(sum);
}

}  // namespace convexact
