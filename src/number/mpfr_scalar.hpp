// SPDX-License-Identifier: MIT
// mpfr_scalar.hpp - MPFR numbers with operators, rounded to nearest: a scalar of any length.
#pragma once
#include <array>

#include "convexact/number.hpp"

namespace convexact {

/// Exponents of an MpfrScalar.
enum class ExponentsOf {
  Mpfr,    ///< Up to +-2^30.
  Binary,  ///< Of the IEEE 754 format of that length: subnormals, and infinity by overflow.
};

/// A number of `kBits` bits. Each operation is the exact result rounded to nearest, ties to even:
/// with ExponentsOf::Binary, 24 and 53 bits are C's float and double, bit for bit.
///
/// The bits live inside the object, so no operation allocates; only one whose result is subnormal
/// is made twice.
template <long kBits, ExponentsOf kExponents = ExponentsOf::Mpfr>
class MpfrScalar {
  static constexpr bool kIsBinary = kExponents == ExponentsOf::Binary;
  static_assert(!kIsBinary || kBits == 24 || kBits == 53, "binary32 or binary64");

 public:
  MpfrScalar() {
    mpfr_custom_init(limbs_.data(), kBits);
    mpfr_custom_init_set(&number_, MPFR_ZERO_KIND, 0, kBits, limbs_.data());
  }
  explicit MpfrScalar(double x) : MpfrScalar() { assign(mpfr_set_d, x); }
  explicit MpfrScalar(const Rational& x) : MpfrScalar() { assign(mpfr_set_q, x.backend().data()); }
  MpfrScalar(const MpfrScalar& other) : number_(other.number_), limbs_(other.limbs_) {
    mpfr_custom_move(&number_, limbs_.data());
  }
  MpfrScalar& operator=(const MpfrScalar& other) {
    number_ = other.number_;
    limbs_ = other.limbs_;
    mpfr_custom_move(&number_, limbs_.data());
    return *this;
  }

  friend MpfrScalar operator-(const MpfrScalar& a) { return from(mpfr_neg, a); }
  friend MpfrScalar operator+(const MpfrScalar& a, const MpfrScalar& b) {
    return from(mpfr_add, a, b);
  }
  friend MpfrScalar operator-(const MpfrScalar& a, const MpfrScalar& b) {
    return from(mpfr_sub, a, b);
  }
  friend MpfrScalar operator*(const MpfrScalar& a, const MpfrScalar& b) {
    return from(mpfr_mul, a, b);
  }
  friend MpfrScalar operator/(const MpfrScalar& a, const MpfrScalar& b) {
    return from(mpfr_div, a, b);
  }
  MpfrScalar& operator+=(const MpfrScalar& b) { return *this = *this + b; }

  friend bool operator<(const MpfrScalar& a, const MpfrScalar& b) {
    return mpfr_less_p(&a.number_, &b.number_) != 0;
  }
  friend bool operator>(const MpfrScalar& a, const MpfrScalar& b) { return b < a; }
  friend bool operator<=(const MpfrScalar& a, const MpfrScalar& b) {
    return mpfr_lessequal_p(&a.number_, &b.number_) != 0;
  }
  /// The nearest double.
  friend double leading(const MpfrScalar& x) { return mpfr_get_d(&x.number_, MPFR_RNDN); }
  /// Exactly. Precondition: finite.
  friend Rational exactly(const MpfrScalar& x) {
    Rational q;
    mpfr_get_q(q.backend().data(), &x.number_);
    return q;
  }

 private:
  template <class Operation, class... Operands>
  static MpfrScalar from(Operation operation, const Operands&... operands) {
    MpfrScalar result;
    result.assign(operation, &operands.number_...);
    return result;
  }

  template <class Operation, class... Operands>
  void assign(Operation operation, const Operands&... operands) {
    const int above = operation(&number_, operands..., MPFR_RNDN);
    if constexpr (kIsBinary) {
      if (mpfr_regular_p(&number_) == 0) return;
      const long exponent = mpfr_get_exp(&number_);  // |x| is in [1/2, 1) times 2^this
      if (exponent > kTop) mpfr_set_inf(&number_, mpfr_sgn(&number_));
      if (exponent - kBottom >= kBits) return;
      // Such a number has fewer bits: it is rounded again from the exact result, so that no two
      // roundings add up. (A result that the first rounding raised to a power of two is raised to
      // it by this one, too.)
      if (exponent > kBottom) {
        BigFloat shorter(exponent - kBottom);
        operation(shorter.data(), operands..., MPFR_RNDN);
        mpfr_set(&number_, shorter.data(), MPFR_RNDN);
      } else {
        round_to_last_bit(exponent, above);
      }
    }
  }

  // |x| < 2^kBottom becomes 2^kBottom or zero; exactly half way it becomes zero. `above`: MPFR's
  // report on how x was rounded.
  void round_to_last_bit(long exponent, int above) {
    const int sign = mpfr_sgn(&number_);
    const bool is_half = mpfr_cmp_si_2exp(&number_, sign, kBottom - 1) == 0;
    if (exponent < kBottom || (is_half && above * sign >= 0)) {
      mpfr_set_zero(&number_, sign);
    } else {
      mpfr_set_si_2exp(&number_, sign, kBottom, MPFR_RNDN);
    }
  }

  // The largest numbers are below 2^kTop, the smallest positive one is 2^kBottom.
  static constexpr long kTop = kBits == 24 ? 128 : 1024;
  static constexpr long kBottom = kBits == 24 ? -149 : -1074;
  static constexpr long kLimbs = (kBits + GMP_NUMB_BITS - 1) / GMP_NUMB_BITS;

  __mpfr_struct number_;
  std::array<mp_limb_t, kLimbs> limbs_{};
};

}  // namespace convexact
