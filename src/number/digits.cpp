// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "convexact/error.hpp"
#include "convexact/number.hpp"
#include "number/arithmetic.hpp"
#include "number/text.hpp"

namespace convexact {
namespace {

Rational power_of_ten(long exponent) {
  Integer power;
  mpz_ui_pow_ui(power.backend().data(), 10, static_cast<unsigned long>(std::abs(exponent)));
  return exponent >= 0 ? Rational(power) : Rational(Integer(1), power);
}

// floor(log10(x)) for x > 0: the exponent gives it up to one or two, and comparisons decide.
long floor_log10(const Rational& x) {
  const auto bits = static_cast<double>(exponent_of(x) - 1);
  auto exponent = static_cast<long>(std::floor(bits * std::log10(2.0)));
  while (power_of_ten(exponent) > x) --exponent;
  while (power_of_ten(exponent + 1) <= x) ++exponent;
  return exponent;
}

// mantissa * 10^(exponent - digits + 1), the mantissa having `digits` digits.
struct Rounded {
  Integer mantissa;
  long exponent;
  bool exact;
};

Rounded round_to_digits(const Rational& x, int digits) {
  long exponent = floor_log10(x);
  const Rational scaled = x * power_of_ten(digits - 1 - exponent);
  Integer whole = numerator(scaled) / denominator(scaled);
  const Rational rest = scaled - Rational(whole), half(1, 2);
  if (rest > half || (rest == half && whole % 2 != 0)) ++whole;
  if (Rational(whole) == power_of_ten(digits)) {
    whole /= 10;
    ++exponent;
  }
  return {whole, exponent, rest == 0};
}

constexpr long kLeastPlainExponent = -6;  // 0.00000123
constexpr long kMostPlainDigits = 21;     // for exact integers that end in zeros

std::string format(const Rounded& value) {
  std::string text = to_string(value.mantissa);
  if (value.exact) text.erase(text.find_last_not_of('0') + 1);
  const auto size = static_cast<long>(text.size());
  const long point = value.exponent + 1;  // digits before the point
  const bool plain = value.exponent >= kLeastPlainExponent &&
                     point <= (value.exact ? std::max(size, kMostPlainDigits) : size);
  if (!plain) {
    if (size > 1) text.insert(1, ".");
    return text + (value.exponent < 0 ? "e" : "e+") + std::to_string(value.exponent);
  }
  if (point <= 0) return "0." + std::string(static_cast<std::size_t>(-point), '0') + text;
  if (point >= size) return text + std::string(static_cast<std::size_t>(point - size), '0');
  return text.insert(static_cast<std::size_t>(point), ".");
}

void require_digits(int digits) {
  if (digits < 1) throw Error(ErrorCode::InvalidArgument, "a number has at least one digit");
}

}  // namespace

std::string hex_float(double x) {
  constexpr int kMantissaBits = 52, kBias = 1023;
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const std::uint64_t mantissa = bits & ((std::uint64_t{1} << kMantissaBits) - 1);
  const int exponent = static_cast<int>(bits >> kMantissaBits & 0x7ff);
  std::string digits = fmt::format(".{:013x}", mantissa);
  digits.erase(digits.find_last_not_of(mantissa == 0 ? ".0" : "0") + 1);
  const bool is_normal = exponent != 0;
  const int power = is_normal ? exponent - kBias : mantissa == 0 ? 0 : 1 - kBias;
  return fmt::format("{}0x{:d}{}p{:+d}", std::signbit(x) ? "-" : "", is_normal, digits, power);
}

std::string to_decimal(const Rational& x, int digits) {
  require_digits(digits);
  if (x == 0) return "0";
  return (x < 0 ? "-" : "") + format(round_to_digits(abs(x), digits));
}

std::optional<std::string> to_decimal(const Enclosure& x, int digits) {
  require_digits(digits);
  const std::optional<Sign> sign = x.sign();
  if (!sign) return std::nullopt;
  const Rational low = x.low(), high = x.high();
  if (low == high) return to_decimal(low, digits);
  const bool negative = sign == Sign::Negative;
  const Rational middle = abs(Rational((low + high) / 2));
  Rounded rounded = round_to_digits(middle, digits);
  const Rational unit = power_of_ten(rounded.exponent - digits + 1);
  const Rational printed = Rational(rounded.mantissa) * unit * (negative ? -1 : 1);
  if (low <= printed - unit || high >= printed + unit) return std::nullopt;
  rounded.exact = false;  // the middle may have few digits, but the number need not
  return (negative ? "-" : "") + format(rounded);
}

std::string escaped_markup(std::string_view text) {
  std::string markup;
  for (const char c : text) {
    switch (c) {
      case '<':
        markup += "&lt;";
        break;
      case '>':
        markup += "&gt;";
        break;
      case '&':
        markup += "&amp;";
        break;
      case '"':
        markup += "&quot;";
        break;
      default:
        markup += c;
    }
  }
  return markup;
}

std::string with_separators(std::uint64_t count) {
  std::string digits = std::to_string(count);
  for (std::size_t i = digits.size(); i > 3; i -= 3) digits.insert(i - 3, 1, ',');
  return digits;
}

std::string counted(std::uint64_t count, const char* one, const char* many) {
  return with_separators(count) + " " + (count == 1 ? one : many);
}

std::string summary_line(const char* label, const std::string& text) {
  return fmt::format("  {:<12}{}\n", label, text);
}

std::string in_sentence(const Rational& x) {
  constexpr std::size_t kLongest = 40;
  constexpr int kDigits = 6;
  const std::string exact = to_string(x);
  return exact.size() <= kLongest ? exact : "about " + to_decimal(x, kDigits);
}

}  // namespace convexact
