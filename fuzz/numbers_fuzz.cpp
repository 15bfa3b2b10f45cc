// SPDX-License-Identifier: MIT
// Property of expansions: sums, products and multiples of expansions are exact and strongly
// nonoverlapping, an estimate is within its bound, and operations on double-doubles are within
// theirs. Property of rounding: a rational in binary64 or binary32, rounded in a named direction,
// is the format's number that the definition names. Property of decimals: a text is refused, or
// read as the double or the binary32 number nearest to the rational that it spells; printed with
// any number of digits, that rational is within half a unit of the last one.
#include <limits>

#include "convexact/number.hpp"
#include "fuzz_target.hpp"
#include "number/double_double.hpp"
#include "number/expansion.hpp"
#include "number/text.hpp"
#include "unless_refused.hpp"

using namespace convexact;

namespace {

// A double with any number of bits, but of a size at which no product of four leaves the range of
// doubles.
double moderate(FuzzInput& in) {
  const double x = in.finite_double();
  int exponent = 0;
  const double mantissa = std::frexp(x, &exponent);
  return std::ldexp(mantissa, exponent % 60);
}

template <std::size_t N>
Rational value_of(const Expansion<N>& e) {
  Rational sum = 0;
  for (std::size_t k = 0; k < e.size; ++k) sum += to_rational(e.terms[k]);
  return sum;
}

int lowest_bit(double x) {
  int exponent = 0;
  const double mantissa = std::ldexp(std::frexp(std::abs(x), &exponent), 53);
  return exponent - 53 + std::countr_zero(static_cast<std::uint64_t>(mantissa));
}

// No term is zero, and each is below the lowest bit of the next.
template <std::size_t N>
void check_expansion(const Expansion<N>& e, const Rational& truth) {
  FUZZ_CHECK(value_of(e) == truth);
  FUZZ_CHECK(e.sign() == sign_of(truth));
  for (std::size_t k = 0; k < e.size; ++k) {
    FUZZ_CHECK(e.terms[k] != 0);
    if (k == 0) continue;
    FUZZ_CHECK(std::ilogb(e.terms[k - 1]) < lowest_bit(e.terms[k]));
  }
  const Rational off = abs(Rational(to_rational(e.estimate()) - truth));
  FUZZ_CHECK(off <= abs(truth) * 16 / (Integer(1) << 53));
}

void check_double_double(const DoubleDouble& found, const Rational& truth) {
  const Rational off = abs(Rational(to_rational(found.hi()) + to_rational(found.lo()) - truth));
  FUZZ_CHECK(off <= abs(truth) * to_rational(DoubleDouble::kUnit));
}

void hold_expansions(FuzzInput& in) {
  const double a = moderate(in), b = moderate(in), c = moderate(in), d = moderate(in);
  const Rational ra = to_rational(a), rb = to_rational(b), rc = to_rational(c), rd = to_rational(d);
  const Expansion<2> x = difference(a, b), y = to_expansion(two_product(c, d));
  check_expansion(x, ra - rb);
  check_expansion(y, rc * rd);
  const Rational rx = ra - rb, ry = rc * rd;
  check_expansion(sum(x, y), rx + ry);
  check_expansion(sum(x, -y), rx - ry);
  check_expansion(scale(x, c), rx * rc);
  check_expansion(product(x, y), rx * ry);
  check_expansion(product(sum(x, y), x), (rx + ry) * rx);

  const DoubleDouble p = DoubleDouble::difference(a, b), q = DoubleDouble::product(c, d);
  check_double_double(p + q, rx + ry);
  check_double_double(p - q, rx - ry);
  check_double_double(p * q, rx * ry);
  if (q.hi() != 0) check_double_double(p / q, rx / ry);
}

template <class Float>
void check_rounded(const Rational& x, Float (*rounded)(const Rational&, Rounding)) {
  constexpr Float kInfinity = std::numeric_limits<Float>::infinity();
  constexpr Float kLargest = std::numeric_limits<Float>::max();
  const Float down = rounded(x, Rounding::Down), up = rounded(x, Rounding::Up),
              nearest = rounded(x, Rounding::Nearest);
  const auto exact = [](Float f) { return to_rational(static_cast<double>(f)); };
  FUZZ_CHECK(down == -kInfinity ? x < exact(-kLargest) : exact(down) <= x);
  FUZZ_CHECK(up == kInfinity ? x > exact(kLargest) : exact(up) >= x);
  // No number of the format lies between them, and only a number of the format is both.
  FUZZ_CHECK(down == up ? exact(down) == x : std::nextafter(down, kInfinity) == up);
  FUZZ_CHECK(nearest == down || nearest == up);
  if (!std::isfinite(down) || !std::isfinite(up) || down == up) return;
  const Rational below = x - exact(down), above = exact(up) - x;
  if (below < above) FUZZ_CHECK(nearest == down);
  if (above < below) FUZZ_CHECK(nearest == up);
  if (below == above) FUZZ_CHECK(std::fmod(nearest / (up - down), Float(2)) == 0);
}

void hold_rounding(FuzzInput& in) {
  Integer p = 0, q = 0;
  for (std::size_t count = in.below(20); count > 0; --count) p = (p << 8) + in.byte();
  for (std::size_t count = in.below(4); count > 0; --count) q = (q << 8) + in.byte();
  if (in.below(2) == 1) p = -p;
  const long exponent = static_cast<long>(in.below(2400)) - 1200;
  const Rational x = scale_by_power_of_two(Rational(p, q + 1), exponent);
  check_rounded<double>(x, to_double);
  check_rounded<float>(x, to_float);
}

// Fuzzers find the grammar by themselves, but they waste attempts on letters.
std::string numeric_text(FuzzInput& in) {
  constexpr std::string_view kLetters = "0123456789.+-eE/xpXPaf 15";
  const bool is_raw = in.below(8) == 0;
  if (is_raw) return std::string(in.rest());
  std::string text;
  while (!in.empty() && text.size() < 64) text += kLetters[in.below(kLetters.size())];
  return text;
}

void check_printed(const Rational& x, int digits) {
  const std::string text = to_decimal(x, digits);
  const Rational back = parse_rational(text);
  const Rational larger = std::max(abs(x), abs(back));
  Integer power = 1;
  for (int k = 1; k < digits; ++k) power *= 10;
  FUZZ_CHECK(abs(Rational(x - back)) * 2 * Rational(power) <= larger);
}

void hold_decimals(FuzzInput& in) {
  const int digits = 1 + static_cast<int>(in.below(40));
  const std::string text = numeric_text(in);
  const auto hexadecimal = unless_refused([&] { return parse_hex_float(text); });
  if (hexadecimal) FUZZ_CHECK(is_hex_float(text));
  const auto nearest = unless_refused([&] { return nearest_double(text); });
  const auto nearest32 = unless_refused([&] { return nearest_float(text); });
  const auto exact = unless_refused([&] { return parse_number(text, Decimal::Exact); });
  const auto rounded = unless_refused([&] { return parse_number(text, Decimal::Nearest); });
  if (nearest) FUZZ_CHECK(rounded.has_value());
  if (!exact) return;
  FUZZ_CHECK(*exact == parse_rational(text));
  FUZZ_CHECK(parse_rational(to_string(*exact)) == *exact);
  if (nearest) FUZZ_CHECK(*nearest == to_double(*exact, Rounding::Nearest));
  if (nearest32) FUZZ_CHECK(*nearest32 == to_float(*exact, Rounding::Nearest));
  const std::size_t bits = bit_length(numerator(*exact)) + bit_length(denominator(*exact));
  if (bits < 2000) check_printed(*exact, digits);
}

const FuzzTarget kExpansions("expansions", hold_expansions);
const FuzzTarget kRounding("rounding", hold_rounding);
const FuzzTarget kDecimals("decimals", hold_decimals);

}  // namespace
