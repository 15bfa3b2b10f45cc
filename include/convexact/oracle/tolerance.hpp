// SPDX-License-Identifier: MIT
// tolerance.hpp - how large a violation somebody is willing to accept.
#pragma once
#include <string>
#include <string_view>

#include "convexact/number/rational.hpp"

namespace convexact {

/// A distance, absolute in length units or relative to the diameter of the input. 0 by default:
/// nothing passes.
struct Tolerance {
  Rational value = 0;
  bool relative = false;

  /// Whether a distance with this square is within the tolerance; exact.
  bool allows(const Rational& squared_distance, const Rational& squared_diameter) const;
};

/// "1.00e-9", or "1.00e-9 of the diameter": to three digits.
[[nodiscard]] std::string describe(const Tolerance& tolerance);

/// The root of an exact square to three digits: "3.47e-16".
[[nodiscard]] std::string decimal_of_root(const Rational& squared);

/// "1e-9" is absolute, "1e-9d" relative to the diameter; decimals mean what they spell.
/// @throws Error InvalidArgument for anything else, and for negative numbers.
[[nodiscard]] Tolerance parse_tolerance(std::string_view text);

/// The least decimal of three significant digits that, as an absolute tolerance, allows distances
/// with this square: "3.15e-16".
/// @param squared_distance  Positive.
[[nodiscard]] std::string least_tolerance(const Rational& squared_distance);

}  // namespace convexact
