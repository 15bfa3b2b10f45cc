// SPDX-License-Identifier: MIT
// big_float.hpp - owner of one MPFR number whose precision is counted in bits.
#pragma once
#include <mpfr.h>

#include "convexact/number/rational.hpp"

namespace convexact {

/// A binary floating-point number of any precision. It only owns memory: arithmetic is done by
/// the caller with MPFR's functions on data(), each with its direction of rounding.
/// Exponents reach +-2^30 (MPFR's default range, which the library never changes).
class BigFloat {
 public:
  /// The number 0 with `precision` >= 1 bits. @throws Error InvalidArgument if precision < 1.
  explicit BigFloat(long precision);
  BigFloat(const BigFloat& other);
  BigFloat(BigFloat&& other) noexcept;
  BigFloat& operator=(BigFloat other) noexcept;
  ~BigFloat();

  mpfr_ptr data() { return value_; }
  mpfr_srcptr data() const { return value_; }
  long precision() const { return mpfr_get_prec(value_); }

  /// Exactly. Precondition: finite.
  Rational to_rational() const;

 private:
  mpfr_t value_;
};

}  // namespace convexact
