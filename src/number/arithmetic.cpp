// SPDX-License-Identifier: MIT
#include "number/arithmetic.hpp"

#include <algorithm>

namespace convexact {
namespace {

Integer common_denominator(const RationalVector3& v, Integer common) {
  for (int k = 0; k < 3; ++k) common = lcm(common, denominator(v[k]));
  return common;
}

// x times a multiple of its denominator.
Integer times(const Rational& x, const Integer& multiple) {
  return numerator(x) * (multiple / denominator(x));
}

IntegerVector3 times(const RationalVector3& v, const Integer& multiple) {
  return {times(v[0], multiple), times(v[1], multiple), times(v[2], multiple)};
}

}  // namespace

Integer gcd(const Integer& a, const Integer& b) {
  Integer g;
  mpz_gcd(raw(g), raw(a), raw(b));
  return g;
}

IntegerVector3 primitive_direction(const IntegerVector3& v) {
  const Integer common = gcd(gcd(v[0], v[1]), v[2]);
  return {v[0] / common, v[1] / common, v[2] / common};
}

void make_primitive(IntegerVector3& x, Integer& d) {
  // One after another, not in pairs: the first divisor is mostly short, so the others are cheap.
  Integer divisor = gcd(d, x[0]);
  for (int k = 1; k < 3 && divisor != 1; ++k) divisor = gcd(divisor, x[k]);
  if (divisor == 1) return;
  for (Integer* z : {&x[0], &x[1], &x[2], &d}) mpz_divexact(raw(*z), raw(*z), raw(divisor));
}

Integer dot(const IntegerVector3& a, const IntegerVector3& b) {
  Integer sum;
  mpz_mul(raw(sum), raw(a[0]), raw(b[0]));
  add_product(sum, a[1], b[1]);
  add_product(sum, a[2], b[2]);
  return sum;
}

long exponent_of(const Rational& x) {
  const mpq_srcptr q = x.backend().data();
  return static_cast<long>(mpz_sizeinbase(mpq_numref(q), 2)) -
         static_cast<long>(mpz_sizeinbase(mpq_denref(q), 2)) + 1;
}

std::size_t bit_length(const IntegerVector3& v) {
  return std::max({bit_length(v[0]), bit_length(v[1]), bit_length(v[2])});
}

IntegerFraction clear_denominators(const RationalVector3& v) {
  const Integer common = common_denominator(v, 1);
  return {times(v, common), common};
}

IntegerFraction clear_denominators(const RationalVector3& v, const Rational& w) {
  const Integer common = common_denominator(v, denominator(w));
  return {times(v, common), times(w, common)};
}

Integer clear_denominators(std::span<const Rational> values, std::span<Integer> integers) {
  Integer common = 1;
  for (const Rational& x : values) {
    mpz_lcm(raw(common), raw(common), mpq_denref(x.backend().data()));
  }
  for (std::size_t k = 0; k < values.size(); ++k) integers[k] = times(values[k], common);
  return common;
}

void make_primitive(std::span<const Rational> values, std::span<Integer> integers) {
  (void)clear_denominators(values, integers);
  Integer common = 0;
  for (const Integer& x : integers) common = gcd(common, x);
  if (common <= 1) return;
  for (Integer& x : integers) x /= common;
}

Rational balanced_sum(std::vector<Rational> terms) {
  if (terms.empty()) return 0;
  while (terms.size() > 1) {
    const std::size_t pairs = terms.size() / 2;
    for (std::size_t i = 0; i < pairs; ++i) terms[i] = terms[2 * i] + terms[2 * i + 1];
    if (terms.size() % 2 == 1) terms[pairs] = std::move(terms.back());
    terms.resize((terms.size() + 1) / 2);
  }
  return std::move(terms.front());
}

}  // namespace convexact
