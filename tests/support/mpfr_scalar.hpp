// SPDX-License-Identifier: MIT
// mpfr_scalar.hpp - MPFR numbers with operators, rounded to nearest: a scalar for the float loop.
#pragma once
#include <utility>

#include "convexact/number/big_float.hpp"

namespace convexact {

/// A number of `kBits` bits. Each operation is off by at most 2^-kBits of its result; with 53 bits
/// it gives what doubles give wherever these neither overflow nor underflow.
template <long kBits>
class MpfrScalar {
 public:
  MpfrScalar() : value_(kBits) {}
  explicit MpfrScalar(double x) : MpfrScalar() { mpfr_set_d(value_.data(), x, MPFR_RNDN); }
  explicit MpfrScalar(const Rational& x) : MpfrScalar() {
    mpfr_set_q(value_.data(), x.backend().data(), MPFR_RNDN);
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
    return mpfr_less_p(a.value_.data(), b.value_.data()) != 0;
  }
  friend bool operator>(const MpfrScalar& a, const MpfrScalar& b) { return b < a; }
  friend bool operator<=(const MpfrScalar& a, const MpfrScalar& b) {
    return mpfr_lessequal_p(a.value_.data(), b.value_.data()) != 0;
  }
  friend double leading(const MpfrScalar& x) { return mpfr_get_d(x.value_.data(), MPFR_RNDN); }

 private:
  template <class Operation, class... Operands>
  static MpfrScalar from(Operation operation, const Operands&... operands) {
    MpfrScalar result;
    operation(result.value_.data(), operands.value_.data()..., MPFR_RNDN);
    return result;
  }

  BigFloat value_;
};

}  // namespace convexact
