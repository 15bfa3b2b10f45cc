// SPDX-License-Identifier: MIT
#include <algorithm>
#include <charconv>
#include <cmath>

#include "convexact/error.hpp"
#include "convexact/number.hpp"

namespace convexact {
namespace {

[[noreturn]] void reject(std::string_view text) {
  throw Error(ErrorCode::Malformed, "expected a number, found " + in_quotes(text));
}

template <class Float>
[[noreturn]] void reject_as_infinite(std::string_view text) {
  const std::string expected =
      std::is_same_v<Float, float> ? "a number within binary32 (3.4028235e38)" : "a finite number";
  throw Error(ErrorCode::NotFinite, "expected " + expected + ", found " + in_quotes(text));
}

template <class Float>
Float rounded(const Rational& x) {
  if constexpr (std::is_same_v<Float, float>) {
    return to_float(x, Rounding::Nearest);
  } else {
    return to_double(x, Rounding::Nearest);
  }
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

// A decimal that std::from_chars found outside the range of normal numbers.
template <class Float>
Float round_out_of_range(std::string_view body, bool negative, std::string_view text) {
  // Every double is below 2e308, and everything below 1e-325 rounds to zero, in binary32 too.
  const long exponent = leading_exponent(body);
  Float magnitude = 0;
  if (exponent > 308) reject_as_infinite<Float>(text);
  if (exponent >= -325) magnitude = rounded<Float>(parse_rational(body));
  if (std::isinf(magnitude)) reject_as_infinite<Float>(text);
  return negative ? -magnitude : magnitude;
}

template <class Float>
Float nearest(std::string_view text) {
  std::string_view body = text;
  const bool negative = !body.empty() && body.front() == '-';
  if (!body.empty() && (body.front() == '-' || body.front() == '+')) body.remove_prefix(1);
  if (body.empty() || body.front() == '-') reject(text);
  Float value = 0;
  const auto [end, status] = std::from_chars(body.data(), body.data() + body.size(), value);
  if (end != body.data() + body.size() || status == std::errc::invalid_argument) reject(text);
  if (status == std::errc::result_out_of_range) {
    return round_out_of_range<Float>(body, negative, text);
  }
  if (!std::isfinite(value)) reject_as_infinite<Float>(text);
  return negative ? -value : value;
}

}  // namespace

double nearest_double(std::string_view text) { return nearest<double>(text); }
float nearest_float(std::string_view text) { return nearest<float>(text); }

Rational parse_number(std::string_view text, Decimal decimal) {
  const bool is_decimal = text.find_first_not_of("+-0123456789/") != std::string_view::npos;
  if (!is_decimal) return parse_rational(text);
  if (decimal == Decimal::Nearest32) return to_rational(nearest_float(text));
  const double near = nearest_double(text);  // in both cases: it refuses nan and infinity
  return decimal == Decimal::Exact ? parse_rational(text) : to_rational(near);
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  std::string shown = "'";
  for (const char c : text.substr(0, kLongest)) shown += c >= ' ' && c <= '~' ? c : '?';
  return shown + (text.size() > kLongest ? "...'" : "'");
}

}  // namespace convexact
