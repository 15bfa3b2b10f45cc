// SPDX-License-Identifier: MIT
// hex_float.hpp - numbers in C's hexadecimal notation, which spells every double exactly.
#pragma once
#include <string_view>

#include "convexact/number.hpp"

namespace convexact {

/// Whether `text` begins like a hexadecimal number: an optional sign, then 0x or 0X.
[[nodiscard]] bool is_hex_float(std::string_view text);

/// The number that is spelled, exactly, whatever its length: "0x1.8p-3" is 3/16, "-0x10" is -16.
/// Digits before or after the point, and the exponent of two, may be missing.
/// @throws Error Malformed for anything else, or for an exponent beyond +-100000.
[[nodiscard]] Rational parse_hex_float(std::string_view text);

}  // namespace convexact
