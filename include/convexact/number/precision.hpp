// SPDX-License-Identifier: MIT
// precision.hpp - the two binary floating-point formats that results are written in.
#pragma once
#include "convexact/number/rounding.hpp"

namespace convexact {

enum class Precision {
  Binary64,  ///< IEEE 754 double: 53 bits, up to about 1.8e308.
  Binary32,  ///< IEEE 754 float: 24 bits, up to about 3.4e38.
};

/// Bits of the significand, the leading one included.
[[nodiscard]] constexpr int significand_bits(Precision precision) {
  return precision == Precision::Binary64 ? 53 : 24;
}

/// x in the format `precision`, as to_double() and to_float() round; a double holds either.
[[nodiscard]] inline double round_to(Precision precision, const Rational& x, Rounding rounding) {
  return precision == Precision::Binary64 ? to_double(x, rounding) : to_float(x, rounding);
}

}  // namespace convexact
