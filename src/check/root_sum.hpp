// SPDX-License-Identifier: MIT
// root_sum.hpp - sums of square roots with rational factors, and their exact order.
#pragma once
#include <compare>
#include <map>
#include <tuple>
#include <utility>

#include "exact.hpp"

namespace check {

// The sum of factor * sqrt(radicand): the factors by their radicands, integers > 0. No factor is 0.
// A rational number has the radicand 1.
using RootSum = std::map<Integer, Rational>;

inline void add_term(RootSum& sum, const Integer& radicand, const Rational& factor) {
  Rational& total = sum[radicand];
  total += factor;
  if (total == 0) sum.erase(radicand);
}
inline RootSum difference(RootSum a, const RootSum& b) {
  for (const auto& [radicand, factor] : b) add_term(a, radicand, -factor);
  return a;
}

// The same number with one root for each square class. Two radicands are in one class if their
// product is a square: sqrt(n) = sqrt(n m) / m * sqrt(m).
inline RootSum by_square_class(const RootSum& sum) {
  RootSum result;
  for (const auto& [n, factor] : sum) {
    auto m = result.begin();
    Integer product;
    for (; m != result.end(); ++m) {
      product = n * m->first;
      if (mpz_perfect_square_p(product.get_mpz_t()) != 0) break;
    }
    if (m == result.end()) {
      result.insert({n, factor});
    } else {
      add_term(result, Integer(m->first), factor * quotient(sqrt(product), m->first));
    }
  }
  return result;
}

// Two numbers with the sum between them. Each term, the root of factor^2 radicand, lies between two
// neighbouring multiples of a power of two that is chosen so that it has about this many bits.
inline std::pair<Rational, Rational> bounds(const RootSum& sum, long bits) {
  std::pair<Rational, Rational> ends;
  for (const auto& [radicand, factor] : sum) {
    const Rational square = factor * factor * radicand;
    const long k = bits - (long(mpz_sizeinbase(square.get_num_mpz_t(), 2)) -
                           long(mpz_sizeinbase(square.get_den_mpz_t(), 2))) /
                              2;
    const Rational in_units = square * power_of_two(2 * k), unit = power_of_two(-k);
    const Integer root = sqrt(Integer(in_units.get_num() / in_units.get_den())), next = root + 1;
    ends.first += unit * (factor > 0 ? root : Integer(-next));
    ends.second += unit * (factor > 0 ? next : Integer(-root));
  }
  return ends;
}

// -1, 0 or 1. Roots of different square classes are linearly independent over the rationals, so a
// sum with any of them left is not zero, and with enough bits its bounds are on one side of zero.
inline int sign(const RootSum& sum) {
  const RootSum terms = by_square_class(sum);
  for (long bits = 128; !terms.empty(); bits *= 2) {
    const auto [low, high] = bounds(terms, bits);
    if (low > 0) return 1;
    if (high < 0) return -1;
  }
  return 0;
}

// The cost of a removal. Bounds tell most costs apart; otherwise the sign of the difference does.
class Cost {
 public:
  Cost() = default;  // zero
  explicit Cost(RootSum sum) : sum_(std::move(sum)) { std::tie(low_, high_) = bounds(sum_, 128); }

  friend std::strong_ordering operator<=>(const Cost& a, const Cost& b) {
    if (a.high_ < b.low_) return std::strong_ordering::less;
    if (b.high_ < a.low_) return std::strong_ordering::greater;
    return sign(difference(a.sum_, b.sum_)) <=> 0;
  }
  friend bool operator==(const Cost& a, const Cost& b) { return (a <=> b) == 0; }

 private:
  RootSum sum_;
  Rational low_, high_;
};

}  // namespace check
