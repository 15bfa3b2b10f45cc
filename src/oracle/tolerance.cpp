// SPDX-License-Identifier: MIT
#include <cmath>

#include "convexact/error.hpp"
#include "convexact/number.hpp"
#include "convexact/verify.hpp"
#include "number/precision.hpp"
#include "number/text.hpp"

namespace convexact {

bool Tolerance::allows(const Rational& squared_distance, const Rational& squared_diameter) const {
  const Rational squared = value * value;
  return squared_distance <= (relative ? Rational(squared * squared_diameter) : squared);
}

std::string describe(const Tolerance& tolerance) {
  return to_decimal(tolerance.value, 3) + (tolerance.relative ? " of the diameter" : "");
}

std::string decimal_of_root(const Rational& squared) {
  return to_decimal(sqrt(Enclosure(squared, kMeasureBits)), 3).value_or("?");
}

Tolerance parse_tolerance(std::string_view text) {
  Tolerance tolerance;
  tolerance.relative = text.ends_with('d');
  const std::string_view number = text.substr(0, text.size() - (tolerance.relative ? 1 : 0));
  try {
    tolerance.value = parse_rational(number);
  } catch (const Error&) {
    throw Error(ErrorCode::InvalidArgument,
                "expected a distance such as 1e-6, or 1e-9d for a part of the diameter, found " +
                    in_quotes(text));
  }
  if (tolerance.value < 0) {
    throw Error(ErrorCode::InvalidArgument, "a tolerance cannot be negative");
  }
  return tolerance;
}

std::string least_tolerance(const Rational& squared) {
  const auto bits = [](const Integer& x) { return static_cast<long>(bit_length(x)); };
  // A power of ten at or below the root, less than a factor 10 away or two; then upwards.
  const long halves = bits(numerator(squared)) - bits(denominator(squared)) - 1;
  long exponent = static_cast<long>(std::floor(static_cast<double>(halves) / 2 * 0.30103)) - 3;
  for (;; ++exponent) {
    const Rational unit = parse_rational("1e" + std::to_string(exponent));
    const Rational target = squared / (unit * unit);
    Integer digits = sqrt(Integer(numerator(target) / denominator(target)));
    if (Rational(digits * digits) < target) ++digits;
    if (digits > 999) continue;
    std::string text = to_string(digits);
    const long leading = exponent + static_cast<long>(text.size()) - 1;
    text.erase(text.find_last_not_of('0') + 1);
    if (text.size() > 1) text.insert(1, ".");
    return text + "e" + std::to_string(leading);
  }
}

}  // namespace convexact
