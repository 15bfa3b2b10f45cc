// SPDX-License-Identifier: MIT
#include <charconv>
#include <cmath>

#include "convexact/error.hpp"
#include "convexact/number.hpp"

namespace convexact {

Rational to_rational(double x) {
  // GMP would end the process by a signal, so the door is here.
  if (!std::isfinite(x)) throw Error(ErrorCode::NotFinite, "a number is NaN or infinite");
  Rational q;
  mpq_set_d(q.backend().data(), x);
  return q;
}

RationalVector3 to_rational(const Vector3<double>& v) {
  return {to_rational(v.x()), to_rational(v.y()), to_rational(v.z())};
}

namespace {

constexpr long kMaxDecimalExponent = 100000;

[[noreturn]] void reject_number(std::string_view text) {
  throw Error(ErrorCode::Malformed, "expected a number, found '" + std::string(text) + "'");
}

bool is_digits(std::string_view text) {
  for (const char c : text) {
    if (c < '0' || c > '9') return false;
  }
  return !text.empty();
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

std::string to_string(const Rational& x) { return x.str(); }
std::string to_string(const Integer& x) { return x.str(); }

std::size_t bit_length(const Integer& x) {
  return x == 0 ? 0 : mpz_sizeinbase(x.backend().data(), 2);
}

Integer gcd(const Integer& a, const Integer& b) {
  Integer g;
  mpz_gcd(g.backend().data(), a.backend().data(), b.backend().data());
  return g;
}

void make_primitive(IntegerVector3& x, Integer& d) {
  // One after another, not in pairs: the first divisor is mostly short, and the rest cheap then.
  Integer divisor = gcd(d, x[0]);
  for (int k = 1; k < 3 && divisor != 1; ++k) divisor = gcd(divisor, x[k]);
  if (divisor == 1) return;
  for (Integer* z : {&x[0], &x[1], &x[2], &d}) {
    mpz_divexact(z->backend().data(), z->backend().data(), divisor.backend().data());
  }
}

Rational scale_by_power_of_two(const Rational& x, long k) {
  Rational y;
  if (k >= 0) {
    mpq_mul_2exp(y.backend().data(), x.backend().data(), static_cast<unsigned long>(k));
  } else {
    mpq_div_2exp(y.backend().data(), x.backend().data(), static_cast<unsigned long>(-k));
  }
  return y;
}

}  // namespace convexact
