// SPDX-License-Identifier: MIT
// text.hpp - numbers and words in texts: hexadecimal numbers, quotes in messages, markup,
// thousands, a summary's lines.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <system_error>

#include "convexact/number.hpp"

namespace convexact {

/// Whether `text` is decimal digits, at least one, and nothing else.
[[nodiscard]] bool is_digits(std::string_view text);

/// Whether `text` begins like a hexadecimal number: an optional sign, then 0x or 0X.
[[nodiscard]] bool is_hex_float(std::string_view text);

/// The number that a text in C's hexadecimal notation spells, exactly, for any length:
/// "0x1.8p-3" is 3/16, "-0x10" is -16. Digits before or after the point, and the exponent of two,
/// may be missing.
/// @throws Error Malformed for anything else, or for an exponent beyond +-100000.
[[nodiscard]] Rational parse_hex_float(std::string_view text);

/// What std::from_chars gives for a whole decimal without sign, or for a name of infinity or NaN,
/// of which all are infinity here: sooner, and for libraries that lack it. Decimals whose mantissa
/// or power of ten `Float`, float or double, cannot hold are left to others: result_out_of_range.
/// @returns std::errc::invalid_argument for anything else.
template <class Float>
[[nodiscard]] std::errc from_short_decimal(std::string_view text, Float& value);

/// A finite double in C's hexadecimal notation, as %a of glibc writes it: "0x1.8p-3", "-0x0p+0",
/// "0x0.8p-1022" if it is subnormal. (C leaves the first digit open, and libraries differ.)
[[nodiscard]] std::string hex_float(double x);

/// `text` between quotes for an error message: shortened, and with printable characters only.
[[nodiscard]] std::string in_quotes(std::string_view text);

/// Plain text as HTML or XML, inside of elements and quoted attributes.
[[nodiscard]] std::string escaped_markup(std::string_view text);

/// 1234567 as "1,234,567".
[[nodiscard]] std::string with_separators(std::uint64_t count);

/// "1 point", "1,800 points".
[[nodiscard]] std::string counted(std::uint64_t count, const char* one, const char* many);

/// A line of a summary: the text after its label, in a separate column.
[[nodiscard]] std::string summary_line(const char* label, const std::string& text);

/// A number in a sentence: exact, unless that has more than 40 characters, which --json has; then
/// six digits, as "about 1.23457e+52".
[[nodiscard]] std::string in_sentence(const Rational& x);

}  // namespace convexact
