// SPDX-License-Identifier: MIT
// Numbers from text: fractions and decimals exactly, decimals to the nearest double or binary32
// number, hexadecimal numbers.
#include <algorithm>
#include <charconv>
#include <cmath>

#include "convexact/error.hpp"
#include "convexact/number.hpp"
#include "number/text.hpp"

namespace convexact {

std::string in_quotes(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  std::string shown = "'";
  for (const char c : text.substr(0, kLongest)) shown += c >= ' ' && c <= '~' ? c : '?';
  return shown + (text.size() > kLongest ? "...'" : "'");
}

bool is_digits(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == text.npos;
}

namespace {

constexpr long kMaxDecimalExponent = 100000;

[[noreturn]] void reject_number(std::string_view text) {
  throw Error(ErrorCode::Malformed, "expected a number, found '" + std::string(text) + "'");
}

Integer parse_digits(std::string_view digits) {
  Integer value;
  mpz_set_str(value.backend().data(), std::string(digits).c_str(), 10);
  return value;
}

Integer power_of_ten(unsigned long exponent) {
  Integer power;
  mpz_ui_pow_ui(power.backend().data(), 10, exponent);
  return power;
}

long parse_exponent(std::string_view exponent, std::string_view text) {
  if (!exponent.empty() && exponent.front() == '+') exponent.remove_prefix(1);
  long value = 0;
  const auto [end, status] =
      std::from_chars(exponent.data(), exponent.data() + exponent.size(), value);
  if (end != exponent.data() + exponent.size() || exponent.empty()) reject_number(text);
  // Compared from both sides: the least long has no absolute value.
  if (status != std::errc() || value < -kMaxDecimalExponent || value > kMaxDecimalExponent) {
    throw Error(ErrorCode::Malformed, "the exponent of '" + std::string(text) + "' is beyond +-" +
                                          std::to_string(kMaxDecimalExponent));
  }
  return value;
}

// digits [. digits] [e exponent], without a sign.
Rational parse_decimal(std::string_view body, std::string_view text) {
  long exponent = 0;
  if (const auto e = body.find_first_of("eE"); e != std::string_view::npos) {
    exponent = parse_exponent(body.substr(e + 1), text);
    body = body.substr(0, e);
  }
  std::string digits(body);
  if (const auto point = body.find('.'); point != std::string_view::npos) {
    digits.erase(point, 1);
    exponent -= static_cast<long>(body.size() - point - 1);
  }
  if (!is_digits(digits)) reject_number(text);
  const Integer mantissa = parse_digits(digits);
  const Integer power = power_of_ten(static_cast<unsigned long>(std::abs(exponent)));
  return exponent >= 0 ? Rational(Integer(mantissa * power)) : Rational(mantissa, power);
}

}  // namespace

Rational parse_rational(std::string_view text) {
  std::string_view body = text;
  const bool negative = !body.empty() && body.front() == '-';
  if (!body.empty() && (body.front() == '-' || body.front() == '+')) body.remove_prefix(1);
  Rational value;
  if (const auto slash = body.find('/'); slash != std::string_view::npos) {
    const std::string_view p = body.substr(0, slash), q = body.substr(slash + 1);
    if (!is_digits(p) || !is_digits(q) || parse_digits(q) == 0) reject_number(text);
    value = Rational(parse_digits(p), parse_digits(q));
  } else {
    value = parse_decimal(body, text);
  }
  return negative ? Rational(-value) : value;
}

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
// `text` is a decimal, so its form needs no second check.
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

// A decimal of any length and exponent, by exact arithmetic.
template <class Float>
Float round_exactly(std::string_view body, bool negative, std::string_view text) {
  // Every double is below 2e308, and everything below 1e-325 rounds to zero, in binary32 too.
  const long exponent = leading_exponent(body);
  Float magnitude = 0;
  if (exponent > 308) reject_as_infinite<Float>(text);
  if (exponent >= -325) magnitude = rounded<Float>(parse_rational(body));
  if (std::isinf(magnitude)) reject_as_infinite<Float>(text);
  return negative ? -magnitude : magnitude;
}

// A whole text as a number without sign. Decimals outside of the range of normal numbers, and
// perhaps others, are left to exact arithmetic: std::errc::result_out_of_range.
template <class Float>
std::errc read_unsigned(std::string_view text, Float& value) {
#ifdef __cpp_lib_to_chars
  // Those with up to 15 digits after "0." are short in any case; of longer ones, too few.
  constexpr std::size_t kLongest = 17;
  const bool is_read = text.size() <= kLongest && from_short_decimal(text, value) == std::errc();
  if (is_read && std::isfinite(value)) return {};
  const char* const last = text.data() + text.size();
  const auto [end, status] = std::from_chars(text.data(), last, value);
  return end == last ? status : std::errc::invalid_argument;
#else  // as in libc++ before 20, which reads integers only
  return from_short_decimal(text, value);
#endif
}

template <class Float>
Float nearest(std::string_view text) {
  std::string_view body = text;
  const bool negative = !body.empty() && body.front() == '-';
  if (!body.empty() && (body.front() == '-' || body.front() == '+')) body.remove_prefix(1);
  if (body.empty() || body.front() == '-') reject(text);
  Float value = 0;
  const std::errc status = read_unsigned(body, value);
  if (status == std::errc::invalid_argument) reject(text);
  if (status == std::errc::result_out_of_range) return round_exactly<Float>(body, negative, text);
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
