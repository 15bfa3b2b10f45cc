// SPDX-License-Identifier: MIT
// decimal.hpp - from decimal text to numbers: to the nearest binary64 or binary32, or to what is
// spelled.
#pragma once
#include <string_view>

#include "convexact/number/rational.hpp"

namespace convexact {

/// What a decimal in a file means.
enum class Decimal {
  Nearest,    ///< The double nearest to it, half to even; underflow rounds correctly too.
  Nearest32,  ///< The binary32 number nearest to it, rounded once; binary64 is rounded likewise.
  Exact,      ///< The rational that it spells.
};

/// The double nearest to a decimal: "-12", "+1.5", "5.", ".5e-3", of any length and exponent.
/// @throws Error Malformed if `text` is no decimal; NotFinite if it spells infinity or NaN, or
///         rounds beyond the largest double.
[[nodiscard]] double nearest_double(std::string_view text);

/// The binary32 number nearest to a decimal, rounded from its digits at once: by way of the double,
/// 1.00000017881393432617187499 would come out one unit too high.
/// @throws Error as nearest_double, for the largest binary32 number.
[[nodiscard]] float nearest_float(std::string_view text);

/// An integer or a fraction "p/q" as spelled; a decimal with a point or an exponent by `decimal`.
/// @throws Error as nearest_double and parse_rational.
[[nodiscard]] Rational parse_number(std::string_view text, Decimal decimal);

/// `text` between quotes for an error message: shortened, and printable whatever it holds.
[[nodiscard]] std::string in_quotes(std::string_view text);

}  // namespace convexact
