// SPDX-License-Identifier: MIT
#include "convexact/number/decimal.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "convexact/error.hpp"
#include "convexact/number/rounding.hpp"

namespace convexact {
namespace {

[[noreturn]] void reject(std::string_view text) {
  throw Error(ErrorCode::Malformed, "expected a number, found " + in_quotes(text));
}

[[noreturn]] void reject_as_infinite(std::string_view text) {
  throw Error(ErrorCode::NotFinite, "expected a finite number, found " + in_quotes(text));
}

// The exponent e of the first nonzero digit: |x| = d.ddd * 10^e. Saturates far beyond any double.
// `text` is a decimal that std::from_chars accepted, so its form needs no second check.
long leading_exponent(std::string_view text) {
  constexpr long kFar = 1000000000;
  long exponent = 0;
  const auto e = text.find_first_of("eE");
  if (e != std::string_view::npos) {
    std::string_view digits = text.substr(e + 1);
    const bool negative = digits.front() == '-';
    if (negative || digits.front() == '+') digits.remove_prefix(1);
    const auto status = std::from_chars(digits.data(), digits.data() + digits.size(), exponent).ec;
    if (status != std::errc() || exponent > kFar) exponent = kFar;
    if (negative) exponent = -exponent;
  }
  const std::string_view mantissa = text.substr(0, e);
  const long point = static_cast<long>(std::min(mantissa.find('.'), mantissa.size()));
  const long first = static_cast<long>(mantissa.find_first_of("123456789"));
  return exponent + (first < point ? point - first - 1 : point - first);
}

// A decimal that std::from_chars found outside the range of normal doubles.
double round_out_of_range(std::string_view body, bool negative, std::string_view text) {
  // Every double is below 2e308, and everything below 1e-325 rounds to zero.
  const long exponent = leading_exponent(body);
  double magnitude = 0;
  if (exponent > 308) reject_as_infinite(text);
  if (exponent >= -325) magnitude = to_double(parse_rational(body), Rounding::Nearest);
  if (std::isinf(magnitude)) reject_as_infinite(text);
  return negative ? -magnitude : magnitude;
}

}  // namespace

double nearest_double(std::string_view text) {
  std::string_view body = text;
  const bool negative = !body.empty() && body.front() == '-';
  if (!body.empty() && (body.front() == '-' || body.front() == '+')) body.remove_prefix(1);
  if (body.empty() || body.front() == '-') reject(text);
  double value = 0;
  const auto [end, status] = std::from_chars(body.data(), body.data() + body.size(), value);
  if (end != body.data() + body.size() || status == std::errc::invalid_argument) reject(text);
  if (status == std::errc::result_out_of_range) return round_out_of_range(body, negative, text);
  if (!std::isfinite(value)) reject_as_infinite(text);
  return negative ? -value : value;
}

Rational parse_number(std::string_view text, Decimal decimal) {
  const bool is_decimal = text.find_first_not_of("+-0123456789/") != std::string_view::npos;
  if (!is_decimal) return parse_rational(text);
  const double nearest = nearest_double(text);  // in both cases: it refuses nan and infinity
  return decimal == Decimal::Exact ? parse_rational(text) : to_rational(nearest);
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  std::string shown = "'";
  for (const char c : text.substr(0, kLongest)) shown += c >= ' ' && c <= '~' ? c : '?';
  return shown + (text.size() > kLongest ? "...'" : "'");
}

}  // namespace convexact
