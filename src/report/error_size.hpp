// SPDX-License-Identifier: MIT
// error_size.hpp - how large an exactly known error is, also where doubles would underflow.
#pragma once
#include <limits>

#include "convexact/number.hpp"

namespace convexact {

/// |error| in two ways.
struct ErrorSize {
  double value = 0;  ///< Nearest double; 0 where it is less than the smallest one.
  /// -log2 |error|, to about 12 digits: how many bits are right, if the error is a relative one.
  /// Infinite if, and only if, there is no error at all.
  double bits = std::numeric_limits<double>::infinity();

  bool is_exact() const { return bits == std::numeric_limits<double>::infinity(); }
  /// The larger error has fewer bits.
  friend bool operator<(const ErrorSize& a, const ErrorSize& b) { return a.bits > b.bits; }
};

/// log2 of x > 0, to about 12 digits.
[[nodiscard]] double log2_of(const Rational& x);

[[nodiscard]] ErrorSize error_size(const Rational& error);
/// sqrt(x), x >= 0.
[[nodiscard]] ErrorSize root_size(const Rational& x);
/// |computed - exact| / |exact|; if both are 0 no error. Precondition: exact != 0 or both are 0.
[[nodiscard]] ErrorSize relative_error(const Rational& computed, const Rational& exact);

}  // namespace convexact
