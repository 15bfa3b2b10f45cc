// SPDX-License-Identifier: MIT
#include "convexact/error.hpp"
#include "convexact/number.hpp"

namespace convexact {

BigFloat::BigFloat(long precision) {
  if (precision < 1 || precision > MPFR_PREC_MAX) {
    throw Error(ErrorCode::InvalidArgument, "a precision is at least one bit");
  }
  mpfr_init2(value_, precision);
  mpfr_set_zero(value_, 1);
}

BigFloat::BigFloat(const BigFloat& other) {
  mpfr_init2(value_, other.precision());
  mpfr_set(value_, other.value_, MPFR_RNDN);  // same precision: exact
}

// What is moved from stays a valid number, the smallest there is.
BigFloat::BigFloat(BigFloat&& other) noexcept {
  mpfr_init2(value_, MPFR_PREC_MIN);
  mpfr_set_zero(value_, 1);
  mpfr_swap(value_, other.value_);
}

BigFloat& BigFloat::operator=(BigFloat other) noexcept {
  mpfr_swap(value_, other.value_);
  return *this;
}

BigFloat::~BigFloat() { mpfr_clear(value_); }

Rational BigFloat::to_rational() const {
  Rational q;
  mpfr_get_q(q.backend().data(), value_);
  return q;
}

}  // namespace convexact
