// SPDX-License-Identifier: MIT
// The largest distance that passes, and the largest error of a rounded number.
#include <cmath>
#include <limits>

#include "convexact/error.hpp"
#include "convexact/number.hpp"
#include "convexact/verify.hpp"
#include "number/arithmetic.hpp"
#include "number/precision.hpp"
#include "number/text.hpp"

namespace convexact {

Rational Tolerance::squared(const Rational& squared_diameter) const {
  const Rational square = value * value;
  return relative ? Rational(square * squared_diameter) : square;
}

bool Tolerance::allows(const Rational& squared_distance, const Rational& squared_diameter) const {
  return squared_distance <= squared(squared_diameter);
}

std::string describe(const Tolerance& tolerance) {
  return to_decimal(tolerance.value, 3) + (tolerance.relative ? " of the diameter" : "");
}

std::string decimal_of_root(const Rational& squared, int digits) {
  return to_decimal(sqrt(Enclosure(squared, kMeasureBits)), digits).value_or("?");
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
  // A power of ten at or below the root, by less than one or two factors of 10; then upwards.
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

std::string describe(const Slack& slack) {
  const std::string format = slack.precision == Precision::Binary64 ? "binary64" : "binary32";
  if (slack.ulps_of_largest == 0) {
    return "half a unit in the last place of each coordinate in " + format;
  }
  return std::to_string(slack.ulps_of_largest) +
         " units in the last place of the largest coordinate in " + format;
}

Precision precision_of(const PointSet& points) {
  constexpr int kFewBits = 16;
  if (!points.is_binary()) return Precision::Binary64;
  bool is_rounded = false;
  for (const Point& p : points.doubles()) {
    for (const double x : p) {
      if (std::abs(x) > std::numeric_limits<float>::max()) return Precision::Binary64;
      if (static_cast<double>(static_cast<float>(x)) != x) return Precision::Binary64;
      const double scaled = std::ldexp(x, kFewBits - exponent_of(x));
      is_rounded = is_rounded || scaled != std::trunc(scaled);
    }
  }
  return is_rounded ? Precision::Binary32 : Precision::Binary64;
}

Rational unit_in_last_place(Precision precision, const Rational& x) {
  const int least = precision == Precision::Binary64 ? -1074 : -149;
  const double near = to_double(abs(x), Rounding::Down);
  if (near == 0) return to_rational(std::ldexp(1.0, least));
  return to_rational(
      std::ldexp(1.0, std::max(exponent_of(near) - significand_bits(precision), least)));
}

}  // namespace convexact
