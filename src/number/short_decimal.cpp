// SPDX-License-Identifier: MIT
// Short decimals, which most are: in seven tenths of the instructions of std::from_chars, and where
// it is missing.
#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <limits>

#include "number/text.hpp"

namespace convexact {
namespace {

// Such as "Infinity" and "nan(0)".
bool names_no_number(std::string_view text) {
  std::string word(text);
  for (char& c : word) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return word == "inf" || word == "infinity" || word == "nan" ||
         (word.starts_with("nan(") && word.ends_with(')'));
}

// 10^0, 10^1, ..., each of them a `Float`: 5^22 < 2^53 and 5^10 < 2^24.
template <class Float>
constexpr auto powers_of_ten() {
  std::array<Float, std::numeric_limits<Float>::digits == 53 ? 23 : 11> powers{1};
  for (std::size_t k = 1; k < powers.size(); ++k) powers[k] = 10 * powers[k - 1];
  return powers;
}

// Appends the digits at `next`, which is moved past them, to a number; modulo 2^64.
void append_digits(const char*& next, const char* last, std::uint64_t& number) {
  for (; next != last; ++next) {
    const auto digit = static_cast<unsigned char>(*next - '0');
    if (digit > 9) return;
    number = 10 * number + digit;
  }
}

}  // namespace

template <class Float>
std::errc from_short_decimal(std::string_view text, Float& value) {
  const char *next = text.data(), *const last = next + text.size();
  std::uint64_t mantissa = 0;
  append_digits(next, last, mantissa);
  std::int64_t digits = next - text.data(), exponent = 0;
  if (next != last && *next == '.') {
    const char* const fraction = ++next;
    append_digits(next, last, mantissa);
    exponent = fraction - next;
    digits -= exponent;
  }
  if (digits == 0) {
    if (!names_no_number(text)) return std::errc::invalid_argument;
    value = std::numeric_limits<Float>::infinity();
    return {};
  }
  // 10^19 < 2^64, so up to so many digits are held.
  bool is_short = digits <= 19;
  if (next != last) {
    if (*next != 'e' && *next != 'E') return std::errc::invalid_argument;
    std::string_view power(next + 1, static_cast<std::size_t>(last - next - 1));
    const bool is_negative = power.starts_with('-');
    if (is_negative || power.starts_with('+')) power.remove_prefix(1);
    if (!is_digits(power)) return std::errc::invalid_argument;
    is_short = is_short && (power.size() < 10 || mantissa == 0);
    std::int64_t shift = 0;
    if (power.size() < 10) (void)std::from_chars(power.data(), last, shift);
    exponent += is_negative ? -shift : shift;
  }
  // A mantissa and a power of ten that are floating numbers: their product or quotient is rounded
  // once.
  static constexpr auto kPowers = powers_of_ten<Float>();
  constexpr std::uint64_t kMost = std::uint64_t{1} << std::numeric_limits<Float>::digits;
  if (!is_short || mantissa > kMost) return std::errc::result_out_of_range;
  value = static_cast<Float>(mantissa);
  if (mantissa == 0) return {};
  const auto size = static_cast<std::size_t>(std::abs(exponent));
  if (size >= kPowers.size()) return std::errc::result_out_of_range;
  value = exponent < 0 ? value / kPowers[size] : value * kPowers[size];
  return {};
}

template std::errc from_short_decimal(std::string_view, double&);
template std::errc from_short_decimal(std::string_view, float&);

}  // namespace convexact
