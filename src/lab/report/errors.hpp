// SPDX-License-Identifier: MIT
// errors.hpp - the sizes of exactly known errors, even where doubles would underflow, and the
// errors of rounded planes.
#pragma once
#include <limits>

#include "convexact/dual.hpp"
#include "convexact/number.hpp"
#include "lab/report/rounded_dual.hpp"

namespace convexact {

/// |error| in two forms.
struct ErrorSize {
  double value = 0;  ///< Nearest double; 0 where it is less than the smallest one.
  /// -log2 |error|, to about 12 digits: the number of correct bits, if the error is a relative one.
  /// Infinite if, and only if, there is no error at all.
  double bits = std::numeric_limits<double>::infinity();

  bool is_exact() const { return bits == std::numeric_limits<double>::infinity(); }
  /// The larger error has fewer bits.
  friend bool operator<(const ErrorSize& a, const ErrorSize& b) { return a.bits > b.bits; }
};

[[nodiscard]] ErrorSize error_size(const Rational& error);
/// sqrt(x), x >= 0.
[[nodiscard]] ErrorSize root_size(const Rational& x);
/// |computed - exact| / |exact|; if both are 0 no error. Precondition: exact != 0 or both are 0.
[[nodiscard]] ErrorSize relative_error(const Rational& computed, const Rational& exact);

/// The largest relative error of a coordinate of a dual point.
[[nodiscard]] ErrorSize worst_coordinate(const RoundedDual& rounded, std::size_t halfspaces);

/// The largest distance of a vertex of the solid outside one of the rounded planes, relative to the
/// diameter of the solid's box. It is found exactly: doubles only exclude pairs of a plane and a
/// vertex that are proven not to be the worst one.
[[nodiscard]] ErrorSize worst_outside(const RoundedDual& rounded, const DualHull& dual,
                                      const RationalPoint& center);

}  // namespace convexact
