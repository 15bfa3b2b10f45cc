// SPDX-License-Identifier: MIT
// digits.hpp - numbers as decimal text of which every digit is certain.
#pragma once
#include <optional>
#include <string>

#include "convexact/number/enclosure.hpp"

namespace convexact {

// "Certain" means: the number differs from what is printed by less than one unit of the last digit
// printed. (Not: it begins with these digits, for then 2.999... and 3 could never be told apart.)
// Text is plain ("-0.00125", "1234.5") or scientific ("1.25e-9", "3.0e+25") where plain text would
// need more than five zeros after the point, or zeros before it that are not certain.

/// x rounded to `digits` >= 1 significant digits, half to even, so within half a unit. If x itself
/// has no more digits, then exactly x without trailing zeros: "0.5" is 1/2, "0.500" is not.
[[nodiscard]] std::string to_decimal(const Rational& x, int digits);

/// The middle of x rounded likewise, if that is within one unit of all of x; else nothing.
[[nodiscard]] std::optional<std::string> to_decimal(const Enclosure& x, int digits);

/// 1234567 as "1,234,567".
[[nodiscard]] std::string with_separators(std::size_t count);

}  // namespace convexact
