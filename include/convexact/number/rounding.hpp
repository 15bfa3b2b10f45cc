// SPDX-License-Identifier: MIT
// rounding.hpp - from a rational to a binary floating-point format, in a named direction.
#pragma once
#include "convexact/number/rational.hpp"

namespace convexact {

enum class Rounding {
  Down,     ///< The largest format number <= x; below the lowest one: -infinity.
  Up,       ///< The smallest format number >= x; above the largest one: +infinity.
  Nearest,  ///< IEEE 754 round half to even, with its overflow to infinity.
};

/// x in binary64, correctly rounded through subnormals. Down of a value above the largest double is
/// the largest double (and so on by symmetry), as IEEE 754 says. Zero becomes +0, an x that
/// rounds to zero keeps its sign.
[[nodiscard]] double to_double(const Rational& x, Rounding rounding);

/// x in binary32, likewise; rounded once.
[[nodiscard]] float to_float(const Rational& x, Rounding rounding);

}  // namespace convexact
