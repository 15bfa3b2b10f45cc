// SPDX-License-Identifier: MIT
#include "number/hex_float.hpp"

#include <charconv>

#include "convexact/error.hpp"
#include "convexact/number.hpp"

namespace convexact {
namespace {

constexpr long kMaxExponent = 100000;
constexpr std::string_view kHexDigits = "0123456789abcdefABCDEF";

[[noreturn]] void reject_hex(std::string_view text) {
  throw Error(ErrorCode::Malformed, "expected a hexadecimal number, found " + in_quotes(text));
}

bool has_sign(std::string_view text) {
  return !text.empty() && (text.front() == '-' || text.front() == '+');
}

// Takes the digits at the front of `rest` away.
std::string_view take_digits(std::string_view& rest) {
  const std::size_t end = std::min(rest.find_first_not_of(kHexDigits), rest.size());
  const std::string_view digits = rest.substr(0, end);
  rest.remove_prefix(end);
  return digits;
}

long parse_binary_exponent(std::string_view exponent, std::string_view text) {
  if (!exponent.empty() && exponent.front() == '+') exponent.remove_prefix(1);
  long value = 0;
  const char* const last = exponent.data() + exponent.size();
  const auto [end, status] = std::from_chars(exponent.data(), last, value);
  const bool is_in_range = -kMaxExponent <= value && value <= kMaxExponent;
  if (exponent.empty() || end != last || status != std::errc() || !is_in_range) reject_hex(text);
  return value;
}

}  // namespace

bool is_hex_float(std::string_view text) {
  if (has_sign(text)) text.remove_prefix(1);
  return text.size() >= 2 && text[0] == '0' && (text[1] == 'x' || text[1] == 'X');
}

Rational parse_hex_float(std::string_view text) {
  if (!is_hex_float(text)) reject_hex(text);
  std::string_view rest = text.substr(has_sign(text) ? 3 : 2);
  std::string digits(take_digits(rest));
  long exponent = 0;
  if (!rest.empty() && rest.front() == '.') {
    rest.remove_prefix(1);
    const std::string_view fraction = take_digits(rest);
    digits += fraction;
    exponent = -4 * static_cast<long>(fraction.size());
  }
  if (digits.empty()) reject_hex(text);
  if (!rest.empty()) {
    if (rest.front() != 'p' && rest.front() != 'P') reject_hex(text);
    exponent += parse_binary_exponent(rest.substr(1), text);
  }
  Rational value;
  mpz_set_str(mpq_numref(value.backend().data()), digits.c_str(), 16);
  if (text.front() == '-') value = -value;
  return scale_by_power_of_two(value, exponent);
}

}  // namespace convexact
