// SPDX-License-Identifier: MIT
// Decimals without std::from_chars, which libc++ before 20 has for integers only.
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

}  // namespace

template <class Float>
std::errc from_short_decimal(std::string_view text, Float& value) {
  if (names_no_number(text)) {
    value = std::numeric_limits<Float>::infinity();
    return {};
  }
  const std::size_t e = std::min(text.find_first_of("eE"), text.size());
  std::string digits(text.substr(0, e));
  std::int64_t exponent = 0;
  bool is_short = true;
  if (e < text.size()) {
    std::string_view power = text.substr(e + 1);
    if (power.starts_with('+') || power.starts_with('-')) power.remove_prefix(1);
    if (!is_digits(power)) return std::errc::invalid_argument;
    is_short = power.size() < 10;
    if (is_short) (void)std::from_chars(power.data(), power.data() + power.size(), exponent);
    if (text[e + 1] == '-') exponent = -exponent;
  }
  if (const std::size_t point = digits.find('.'); point != digits.npos) {
    digits.erase(point, 1);
    exponent -= static_cast<std::int64_t>(digits.size() - point);
  }
  if (!is_digits(digits)) return std::errc::invalid_argument;
  // A mantissa and a power of ten that are floating numbers: their product or quotient is rounded
  // once.
  static constexpr auto kPowers = powers_of_ten<Float>();
  constexpr std::uint64_t kMost = std::uint64_t{1} << std::numeric_limits<Float>::digits;
  std::uint64_t mantissa = 0;
  const char* const last = digits.data() + digits.size();
  const bool is_held =
      std::from_chars(digits.data(), last, mantissa).ec == std::errc() && mantissa <= kMost;
  const auto size = static_cast<std::size_t>(std::abs(exponent));
  value = static_cast<Float>(mantissa);
  if (is_held && mantissa == 0) return {};
  if (!is_held || !is_short || size >= kPowers.size()) return std::errc::result_out_of_range;
  value = exponent < 0 ? value / kPowers[size] : value * kPowers[size];
  return {};
}

template std::errc from_short_decimal(std::string_view, double&);
template std::errc from_short_decimal(std::string_view, float&);

}  // namespace convexact
