// SPDX-License-Identifier: MIT
#include "measure/fixed_point.hpp"

#include <algorithm>
#include <utility>

#include "number/arithmetic.hpp"

namespace convexact {

FixedRoot fixed_root(const Integer& x, long shift) {
  Integer root, rest;
  mpz_mul_2exp(raw(rest), raw(x), 2 * static_cast<mp_bitcnt_t>(shift));
  mpz_sqrtrem(raw(root), raw(rest), raw(rest));
  return {std::move(root), rest.is_zero()};
}

// 2^(2 bits) <= x 2^(2 shift) gives a root of at least 2^bits.
long shift_for_root(const Integer& x, long bits) {
  const long missing = 2 * bits + 1 - static_cast<long>(bit_length(x));
  return std::max((missing + 1) / 2, 0L);
}

// In units of 2^-bits the errors are:
// (1) The point, scaled so that it lies at least 2^bits from the origin, has a root for its y,
//     which is off by less than 1: its angle is off by at most 1.
// (2) The tangent t <= 1 of the angle with the nearer axis is rounded down: 1, since the derivative
//     of the arctangent is at most 1.
// (3) atan(t) = atan(c) + atan(r) with c = k / 16 next to t and r = (t - c) / (1 + c t), |r| <=
// 1/32
//     and rounded down: 1; atan(c): 2.
// (4) The series r - r^3 / 3 + r^5 / 5 - ...: each power is the one before times r^2. r^2 is off by
//     1 and the product rounded by 1, so all powers are off by less than 2 after the division by
//     2 n + 1 >= 3, which is rounded by 1: 2 for each term. What is cut off is less than the first
//     term left out, (1/32)^(2 terms + 1) < 1.
// (5) pi and pi / 2: 2.
FixedAngles::FixedAngles(long bits)
    : bits_(bits), terms_(bits / 10 + 1), one_(Integer(1) << static_cast<unsigned>(bits)) {
  pi_ = floor_of(Enclosure::pi(bits + 8).low() * Rational(one_));
}

long FixedAngles::error() const { return 1 + 1 + 1 + 2 + (2 * terms_ + 1) + 2; }

Integer FixedAngles::angle(const Integer& squared_cross, const Integer& dot) {
  const long shift = shift_for_root(std::max<Integer>(squared_cross, dot * dot), bits_);
  Integer x = abs(dot) << static_cast<unsigned>(shift), y = fixed_root(squared_cross, shift).floor;
  const bool is_steep = y > x;
  if (is_steep) std::swap(x, y);
  Integer result = arctangent((y << static_cast<unsigned>(bits_)) / x);
  if (is_steep) result = (pi_ >> 1) - result;
  return dot < 0 ? Integer(pi_ - result) : result;
}

Integer FixedAngles::arctangent(const Integer& tangent) {
  const auto bits = static_cast<mp_bitcnt_t>(bits_);
  Integer scaled = tangent * kSteps;
  const auto k = static_cast<unsigned long>((scaled + (one_ >> 1)) >> static_cast<unsigned>(bits_));
  Integer rest = scaled - one_ * k, square, term;
  const Integer below = one_ * kSteps + tangent * k;
  mpz_mul_2exp(raw(rest), raw(rest), bits);
  mpz_fdiv_q(raw(rest), raw(rest), raw(below));
  Integer sum = step(k) + rest;
  square = rest * rest;
  mpz_fdiv_q_2exp(raw(square), raw(square), bits);
  for (long n = 1; n < terms_; ++n) {
    rest *= square;
    mpz_fdiv_q_2exp(raw(rest), raw(rest), bits);
    mpz_fdiv_q_ui(raw(term), raw(rest), static_cast<unsigned long>(2 * n + 1));
    if (n % 2 == 0) {
      sum += term;
    } else {
      sum -= term;
    }
  }
  return sum;
}

const Integer& FixedAngles::step(unsigned long k) {
  std::optional<Integer>& angle = steps_[k];
  if (!angle) {
    const Enclosure exact =
        atan2(Enclosure(Integer(k), bits_ + 8), Enclosure(Integer(kSteps), bits_ + 8));
    angle = floor_of(exact.low() * Rational(one_));
  }
  return *angle;
}

}  // namespace convexact
