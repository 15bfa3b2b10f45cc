// SPDX-License-Identifier: MIT
// expansion.hpp - exact sums and products of doubles as unevaluated sums of doubles.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>

#include "convexact/number.hpp"
#include "number/roundoff.hpp"

namespace convexact {

/// The value of terms[0] + ... + terms[size-1], exactly: nonzero doubles of growing magnitude that
/// are strongly nonoverlapping in the sense of [Shewchuk1997]; size 0 is zero. All operations are
/// exact as long as no product of terms overflows and every number is a multiple of 2^-1074 (which
/// is up to the caller: see orient3d.cpp).
template <std::size_t Capacity>
struct Expansion {
  std::array<double, Capacity> terms;  // those from `size` on have no value
  std::size_t size = 0;

  void push_nonzero(double term) {
    if (term != 0) terms[size++] = term;
  }
  Sign sign() const { return size == 0 ? Sign::Zero : sign_of(terms[size - 1]); }
  /// Off by at most 16 u of the value, u = kUnitRoundoff. Proof: the terms below the k-th add up to
  /// less than its lowest bit, so the partial sums are below 2|t_k| and altogether below 4|t_n|,
  /// t_n the last; so rounding costs at most 4 u |t_n|. As two neighboring bits can only belong to
  /// two powers of two, and not to three terms, the value is at least |t_n| - |t_n|/2 - |t_n|/4.
  double estimate() const {
    double sum = 0;
    for (std::size_t i = 0; i < size; ++i) sum += terms[i];
    return sum;
  }
};

inline Expansion<2> to_expansion(const TwoTerms& t) {
  Expansion<2> e;
  e.push_nonzero(t.low);
  e.push_nonzero(t.high);
  return e;
}

/// x - y.
inline Expansion<2> difference(double x, double y) { return to_expansion(two_sum(x, -y)); }

/// e + f: merge by magnitude, then one pass that carries the rounded sum upwards; linear.
template <std::size_t M, std::size_t N>
Expansion<M + N> sum(const Expansion<M>& e, const Expansion<N>& f) {
  Expansion<M + N> result;
  std::size_t i = 0, j = 0;
  const auto next = [&] {
    const bool from_e = j == f.size || (i < e.size && std::abs(e.terms[i]) < std::abs(f.terms[j]));
    return from_e ? e.terms[i++] : f.terms[j++];
  };
  if (e.size + f.size == 0) return result;
  double carry = next();
  while (i < e.size || j < f.size) {
    const TwoTerms s = two_sum(carry, next());
    result.push_nonzero(s.low);
    carry = s.high;
  }
  result.push_nonzero(carry);
  return result;
}

/// e * factor.
template <std::size_t N>
Expansion<2 * N> scale(const Expansion<N>& e, double factor) {
  Expansion<2 * N> result;
  if (e.size == 0) return result;
  const TwoTerms first = two_product(e.terms[0], factor);
  result.push_nonzero(first.low);
  double carry = first.high;
  for (std::size_t i = 1; i < e.size; ++i) {
    const TwoTerms product = two_product(e.terms[i], factor);
    const TwoTerms lower = two_sum(carry, product.low);
    result.push_nonzero(lower.low);
    const TwoTerms upper = fast_two_sum(product.high, lower.high);
    result.push_nonzero(upper.low);
    carry = upper.high;
  }
  result.push_nonzero(carry);
  return result;
}

/// e * f for a short f.
template <std::size_t N>
Expansion<4 * N> product(const Expansion<N>& e, const Expansion<2>& f) {
  const auto low = f.size > 0 ? scale(e, f.terms[0]) : Expansion<2 * N>();
  const auto high = f.size > 1 ? scale(e, f.terms[1]) : Expansion<2 * N>();
  return sum(low, high);
}

template <std::size_t N>
Expansion<N> operator-(Expansion<N> e) {
  for (std::size_t i = 0; i < e.size; ++i) e.terms[i] = -e.terms[i];
  return e;
}

}  // namespace convexact
