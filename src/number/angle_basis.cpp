// SPDX-License-Identifier: MIT
// Write an angle as the argument of alpha = x + y sqrt(-d), with integers x and y and d > 0.
// Twice that is the argument of alpha / conj(alpha). So a rational combination of such angles is a
// rational multiple of pi if and only if the product of the powers of these quotients is a root of
// unity (for a common denominator of the factors). Two facts make this decidable:
//
// - Quotients of different fields Q(sqrt(-d)) are independent of each other: the norm of one in the
//   other field is 1, as half of its conjugates are its inverse. So each field is considered
//   separately.
// - In one field, an algebraic number of absolute value 1 is a root of unity if and only if it
//   generates the unit ideal. A prime p that does not divide y splits into the prime ideals that
//   hold sqrt(-d) - s and sqrt(-d) + s, where s^2 = -d modulo p. If alpha has no rational divisor,
//   only one of them divides it, by s = -x/y or s = x/y modulo p, as often as p divides its norm
//   x^2 + d y^2; in the quotient, the other one has the opposite exponent. Primes that divide d
//   (once) are ramified: their ideals cancel.
//
// Where all norms are products of pairwise coprime factors, and all s agree up to sign modulo each
// factor, primes are not needed: exponents add up to 0 for each prime of a factor or for none.
#include "number/angle_basis.hpp"

#include <utility>
#include <vector>

#include "number/arithmetic.hpp"
#include "number/precision.hpp"
#include "number/square_classes.hpp"

namespace convexact {
namespace {

// alpha = x + y sqrt(-d), and the factor of its argument in the sum.
struct Argument {
  Integer x, y;
  Rational factor;
  Integer norm = 1;  // without 2, and without primes that divide d
};

// Primes below 2^16.
const std::vector<unsigned long>& small_primes() {
  static const std::vector<unsigned long> primes = [] {
    constexpr std::size_t kLimit = 1 << 16;
    std::vector<bool> is_composite(kLimit, false);
    std::vector<unsigned long> found;
    for (std::size_t p = 2; p < kLimit; ++p) {
      if (is_composite[p]) continue;
      found.push_back(p);
      for (std::size_t multiple = p * p; multiple < kLimit; multiple += p) {
        is_composite[multiple] = true;
      }
    }
    return found;
  }();
  return primes;
}

// Divides d by the squares of small primes. Returns the root of their product, and in `rest` the
// part of d without small primes.
Integer take_small_squares(Integer& d, Integer& rest) {
  Integer root = 1;
  rest = d;
  for (const unsigned long p : small_primes()) {
    if (mpz_divisible_ui_p(raw(rest), p) == 0) continue;
    const Integer prime(p);
    const mp_bitcnt_t times = mpz_remove(raw(rest), raw(rest), raw(prime));
    for (mp_bitcnt_t k = 0; k + 1 < times; k += 2) {
      root *= prime;
      d /= prime * prime;
    }
  }
  return root;
}

// Whether no p with p^2 | d divides x, d having no squares of small primes. `rest` as above.
bool has_no_common_square(const Integer& x, const Integer& rest) {
  const Integer common = gcd(x, rest);
  // Without a divisor below 2^16, a number below 2^32 is 1 or a prime.
  return bit_length(common) <= 32 && gcd(common, rest / common) == 1;
}

// alpha without rational divisors, and its norm without 2 and the primes that divide d.
void remove_divisors(Argument& alpha, const Integer& d) {
  const Integer common = gcd(alpha.x, alpha.y), two = 2;
  alpha.x /= common;
  alpha.y /= common;
  alpha.norm = alpha.x * alpha.x + d * alpha.y * alpha.y;
  mpz_remove(raw(alpha.norm), raw(alpha.norm), raw(two));
  alpha.norm /= gcd(alpha.norm, d);
}

// The exponent of 2 in all quotients is 0. 2 splits if d = 7 modulo 8, and divides a norm if x and
// y are odd. Let s = 1 modulo 4 be a root of -d in the 2-adic integers. One of x + s y and x - s y
// has a single factor 2, the other one all others of the norm, as their sum is 2 x; integers of the
// field may be halves, so that one 2 of each cancels.
bool balances_at_two(const std::vector<Argument>& arguments, const Integer& d) {
  if (mpz_fdiv_ui(raw(d), 8) != 7) return true;
  Rational sum = 0;
  for (const Argument& alpha : arguments) {
    if (alpha.x % 2 == 0 || alpha.y % 2 == 0) continue;
    const Integer norm = alpha.x * alpha.x + d * alpha.y * alpha.y, turned = alpha.x + alpha.y;
    const auto exponent = static_cast<long>(mpz_scan1(raw(norm), 0)) - 2;
    sum += alpha.factor * Rational(mpz_divisible_ui_p(raw(turned), 4) != 0 ? exponent : -exponent);
  }
  return sum == 0;
}

// Pairwise coprime numbers > 1 of which all norms are products. [BachDriscollShallit1993]
std::vector<Integer> coprime_factors(const std::vector<Argument>& arguments, const Watch& watch) {
  std::vector<Integer> base, pending;
  for (const Argument& alpha : arguments) pending.push_back(alpha.norm);
  while (!pending.empty()) {
    watch.ask();
    const Integer m = std::move(pending.back());
    pending.pop_back();
    if (m == 1) continue;
    std::size_t k = 0;
    while (k < base.size() && gcd(base[k], m) == 1) ++k;
    if (k == base.size()) {
      base.push_back(m);
      continue;
    }
    const Integer b = base[k], common = gcd(b, m);  // the product of all falls in each round
    base.erase(base.begin() + static_cast<std::ptrdiff_t>(k));
    for (const Integer& part : {common, Integer(b / common), Integer(m / common)}) {
      pending.push_back(part);
    }
  }
  return base;
}

// The s with alpha in the ideal of m and sqrt(-d) - s: -x / y modulo m, a divisor of the norm.
Integer root_modulo(const Integer& m, const Argument& alpha) {
  Integer inverse;
  mpz_invert(raw(inverse), raw(alpha.y), raw(m));
  Integer root = -alpha.x * inverse;
  mpz_mod(raw(root), raw(root), raw(m));
  return root;
}

// The exponents of the ideals of m in all quotients are 0. Where roots agree up to sign modulo a
// part of m only, the parts are considered one after another; they are coprime, as m is odd and
// coprime to s.
bool balances_at(const Integer& factor, const std::vector<Argument>& arguments) {
  std::vector<Integer> pending{factor};
  while (!pending.empty()) {
    const Integer m = std::move(pending.back());
    pending.pop_back();
    std::optional<Integer> reference, agreeing;
    Rational sum = 0;
    for (const Argument& alpha : arguments) {
      Integer rest;
      const mp_bitcnt_t times = mpz_remove(raw(rest), raw(alpha.norm), raw(m));
      if (times == 0) continue;
      const Integer root = root_modulo(m, alpha);
      if (!reference) reference = root;
      agreeing = gcd(m, Integer(root - *reference));
      if (*agreeing != 1 && *agreeing != m) break;
      const Rational exponent(static_cast<unsigned long>(times));
      sum += alpha.factor * (*agreeing == m ? exponent : Rational(-exponent));
    }
    if (agreeing && *agreeing != 1 && *agreeing != m) {
      pending.push_back(*agreeing);
      pending.push_back(m / *agreeing);
    } else if (sum != 0) {
      return false;
    }
  }
  return true;
}

// Whether the arguments of numbers of Q(sqrt(-d)) add up to a rational multiple of pi.
std::optional<bool> is_multiple_of_pi(std::vector<Argument> arguments, Integer d,
                                      const Watch& watch) {
  Integer rest;
  const Integer root = take_small_squares(d, rest);
  for (Argument& alpha : arguments) {
    alpha.y *= root;
    remove_divisors(alpha, d);
    if (!has_no_common_square(alpha.x, rest)) return std::nullopt;
  }
  if (!balances_at_two(arguments, d)) return false;
  for (const Integer& m : coprime_factors(arguments, watch)) {
    watch.ask();
    if (!balances_at(m, arguments)) return false;
  }
  return true;
}

// x + sqrt(-radicand) with the argument of dot + sqrt(-squared_cross), dot > 0. Common divisors
// that are due to dot are taken out: what x and the radicand still share is f below, mostly 1.
struct QuadraticNumber {
  Integer x, radicand;
};

// tan^2 = a / b in lowest terms, and b = f s^2: then sqrt(b) + sqrt(-a) times sqrt(f) is
// f s + sqrt(-a f).
QuadraticNumber with_few_divisors(const Integer& dot, const Integer& squared_cross) {
  const Integer squared_dot = dot * dot, common = gcd(squared_dot, squared_cross);
  const Integer a = squared_cross / common, b = squared_dot / common;
  // With u = gcd(dot, common) and common = u v, v divides u, as gcd(dot / u, v) = 1, and f = u / v.
  const Integer s = dot / gcd(dot, common), f = b / (s * s);
  if (mpz_perfect_square_p(raw(f)) != 0) return {sqrt(f) * s, a};
  return {f * s, a * f};
}

// The arguments of one field.
struct Field {
  Integer d;
  std::vector<Argument> arguments;
};

// Up to multiples of pi / 2, atan(sqrt(t)) is the argument of dot + sqrt(-squared_cross) if its
// tan^2 is t, and the opposite if that is 1 / t.
std::vector<Field> by_field(const ReducedAngles& sum, const Watch& watch) {
  std::vector<Argument> arguments;
  std::vector<Integer> radicands;
  for (const auto& [t, angle] : sum.angles) {
    const Integer dot = abs(angle.dot);
    QuadraticNumber alpha = with_few_divisors(dot, angle.squared_cross);
    const bool is_complement = angle.squared_cross > dot * dot;
    const Rational factor = is_complement ? Rational(-angle.factor) : angle.factor;
    arguments.push_back({std::move(alpha.x), 1, factor});
    radicands.push_back(std::move(alpha.radicand));
  }
  const SquareClasses classes = square_classes(radicands, watch);
  std::vector<Field> fields;
  for (const Integer& d : classes.representatives) fields.push_back({d, {}});
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const auto& [index, multiple] = classes.members[i];
    arguments[i].y = multiple;
    fields[index].arguments.push_back(std::move(arguments[i]));
  }
  return fields;
}

// Whether a sum that is known to be a rational multiple of pi is zero. Roots of unity of imaginary
// quadratic fields have orders that divide 4 or 6. So 12 q times the sum is an integer times pi,
// with the common denominator q of the factors: an enclosure closer to 0 than pi / (12 q) decides.
bool is_zero_multiple(const ReducedAngles& angles, const Watch& watch) {
  Integer q = denominator(angles.turns);
  for (const auto& entry : angles.angles) q = lcm(q, denominator(entry.second.factor));
  const Rational step = 3 / Rational(12 * q);  // below pi / (12 q)
  ReducedAngles unscaled = angles;
  unscaled.radicand = 1;
  const AngleSum sum = to_angle_sum(std::span(&unscaled, 1));
  for (long bits = kMeasureBits;; bits *= 2) {
    const Enclosure value = sum.enclose(bits, watch);
    if (value.sign().value_or(Sign::Zero) != Sign::Zero) return false;
    if (-step < value.low() && value.high() < step) return true;
  }
}

// Whether the angles of one square class of lengths add up to zero.
std::optional<bool> vanishes(const ReducedAngles& angles, const Watch& watch) {
  bool is_known = true;
  for (Field& field : by_field(angles, watch)) {
    const std::optional<bool> is_multiple =
        is_multiple_of_pi(std::move(field.arguments), field.d, watch);
    if (is_multiple == false) return false;
    is_known = is_known && is_multiple.has_value();
  }
  if (!is_known) return std::nullopt;
  return is_zero_multiple(angles, watch);
}

}  // namespace

std::optional<bool> vanishes_in_angle_basis(std::span<const ReducedAngles> form,
                                            const Watch& watch) {
  bool is_known = true;
  for (const ReducedAngles& angles : form) {
    const std::optional<bool> is_zero = vanishes(angles, watch);
    if (is_zero == false) return false;
    is_known = is_known && is_zero.has_value();
  }
  if (!is_known) return std::nullopt;
  return true;
}

}  // namespace convexact
