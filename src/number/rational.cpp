// SPDX-License-Identifier: MIT
#include <cmath>

#include "convexact/error.hpp"
#include "convexact/number.hpp"

namespace convexact {

Rational to_rational(double x) {
  // GMP would end the process by a signal, so the check is here.
  if (!std::isfinite(x)) throw Error(ErrorCode::NotFinite, "a number is NaN or infinite");
  Rational q;
  mpq_set_d(q.backend().data(), x);
  return q;
}

RationalVector3 to_rational(const Vector3<double>& v) {
  return {to_rational(v.x()), to_rational(v.y()), to_rational(v.z())};
}

std::string to_string(const Rational& x) { return x.str(); }
std::string to_string(const Integer& x) { return x.str(); }

std::size_t bit_length(const Integer& x) {
  return x == 0 ? 0 : mpz_sizeinbase(x.backend().data(), 2);
}

Rational scale_by_power_of_two(const Rational& x, long k) {
  Rational y;
  if (k >= 0) {
    mpq_mul_2exp(y.backend().data(), x.backend().data(), static_cast<unsigned long>(k));
  } else {
    mpq_div_2exp(y.backend().data(), x.backend().data(), static_cast<unsigned long>(-k));
  }
  return y;
}

}  // namespace convexact
