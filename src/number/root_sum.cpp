// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <utility>

#include "convexact/cost.hpp"
#include "convexact/error.hpp"
#include "number/arithmetic.hpp"
#include "number/ordering.hpp"
#include "number/precision.hpp"
#include "number/roundoff.hpp"
#include "number/square_classes.hpp"

namespace convexact {
namespace {

bool by_radicand(const RootTerm& a, const RootTerm& b) { return a.radicand < b.radicand; }

// Sorted by radicand, each once, without zeros.
std::vector<RootTerm> collected(std::vector<RootTerm> terms) {
  std::sort(terms.begin(), terms.end(), by_radicand);
  std::vector<RootTerm> result;
  for (RootTerm& term : terms) {
    if (!result.empty() && result.back().radicand == term.radicand) {
      result.back().factor += term.factor;
    } else {
      result.push_back(std::move(term));
    }
  }
  std::erase_if(result, [](const RootTerm& term) { return term.factor == 0; });
  return result;
}

}  // namespace

RootSum::RootSum(const Rational& x) { add(x, Rational(1)); }

RootSum::RootSum(std::vector<RootTerm> terms) {
  for (const RootTerm& term : terms) {
    if (term.radicand <= 0) throw Error(ErrorCode::InvalidArgument, "a radicand is not positive");
  }
  terms_ = collected(std::move(terms));
}

void RootSum::add(const Rational& factor, const Rational& radicand) {
  if (radicand < 0) throw Error(ErrorCode::InvalidArgument, "a radicand is negative");
  if (factor == 0 || radicand == 0) return;
  const Integer below = denominator(radicand);
  RootTerm term{factor / Rational(below), numerator(radicand) * below};
  const auto place = std::lower_bound(terms_.begin(), terms_.end(), term, by_radicand);
  if (place == terms_.end() || place->radicand != term.radicand) {
    terms_.insert(place, std::move(term));
  } else {
    place->factor += term.factor;
    if (place->factor == 0) terms_.erase(place);
  }
}

RootSum& RootSum::operator+=(const RootSum& other) {
  std::vector<RootTerm> all = std::move(terms_);
  all.insert(all.end(), other.terms_.begin(), other.terms_.end());
  terms_ = collected(std::move(all));
  return *this;
}

RootSum& RootSum::operator*=(const Rational& factor) {
  if (factor == 0) terms_.clear();
  for (RootTerm& term : terms_) term.factor *= factor;
  return *this;
}

RootSum RootSum::operator-() const {
  RootSum result = *this;
  for (RootTerm& term : result.terms_) term.factor = -term.factor;
  return result;
}

RootSum RootSum::normalized(const Watch& watch) const {
  std::vector<Integer> radicands;
  for (const RootTerm& term : terms_) radicands.push_back(term.radicand);
  const SquareClasses classes = square_classes(radicands, watch);
  std::vector<RootTerm> result;
  for (std::size_t i = 0; i < terms_.size(); ++i) {
    const auto& [index, multiple] = classes.members[i];
    result.push_back({terms_[i].factor * Rational(multiple), classes.representatives[index]});
  }
  return RootSum(std::move(result));
}

Enclosure RootSum::enclose(long precision, const Watch& watch) const {
  Enclosure sum(precision);
  for (const RootTerm& term : terms_) {
    watch.ask();
    sum += Enclosure(term.factor, precision) * sqrt(Enclosure(term.radicand, precision));
  }
  return sum;
}

namespace {

// The sign of a sum in doubles; nothing if rounding may have changed it.
//
// Let u be kUnitRoundoff. A factor and a radicand are off by 2u, relatively, as GMP cuts them off.
// So a root is off by u + u, and a product, with its own rounding, by 5u. The sum of n terms adds
// at most (n - 1) u times the sum of their sizes, and that sum itself, in doubles, is too small by
// no more than that share. The terms of higher order are less than the other half of (2n + 10) u,
// as n < 2^20.
std::optional<Sign> sign_in_doubles(const std::vector<RootTerm>& terms) {
  constexpr std::size_t kMostTerms = 1 << 20;
  constexpr long kMostBits = 500;  // so that no number here is subnormal or overflows
  if (terms.size() >= kMostTerms) return std::nullopt;
  double sum = 0, sizes = 0;
  for (const RootTerm& term : terms) {
    if (std::abs(exponent_of(term.factor)) > kMostBits || bit_length(term.radicand) > kMostBits) {
      return std::nullopt;
    }
    const double factor = mpq_get_d(term.factor.backend().data());
    const double value = factor * std::sqrt(mpz_get_d(raw(term.radicand)));
    sum += value;
    sizes += std::abs(value);
  }
  const double error = (2 * static_cast<double>(terms.size()) + 10) * kUnitRoundoff * sizes;
  if (!(std::abs(sum) > error)) return std::nullopt;
  return sign_of(sum);
}

bool is_rational(const RootSum& x) {
  return std::all_of(x.terms().begin(), x.terms().end(), [](const RootTerm& term) {
    return mpz_perfect_square_p(raw(term.radicand)) != 0;
  });
}

}  // namespace

Ordering compare(const RootSum& a, const RootSum& b, const Watch& watch) {
  const RootSum difference = a - b;
  const TieProof proof =
      is_rational(a) && is_rational(b) ? TieProof::EqualRationals : TieProof::SquareClasses;
  if (difference.terms().empty()) return {Order::Equal, proof, 0};
  // (1) Doubles.
  if (const std::optional<Sign> sign = sign_in_doubles(difference.terms())) {
    return {order_of(*sign), {}, kDoubleBits};
  }
  // (2) As many bits as every ordinary comparison needs.
  if (const std::optional<Order> order = order_to_zero(difference.enclose(kMeasureBits, watch))) {
    return {*order, {}, kMeasureBits};
  }
  // (3) Roots of different square classes are independent, so only zero has no terms left.
  const RootSum normalized = difference.normalized(watch);
  if (normalized.terms().empty()) return {Order::Equal, proof, kMeasureBits};
  // (4) Not zero, so some precision shows the sign.
  for (long bits = 2 * kMeasureBits;; bits *= 2) {
    if (const std::optional<Order> order = order_to_zero(normalized.enclose(bits, watch))) {
      return {*order, {}, bits};
    }
  }
}

std::string to_decimal(const RootSum& x, int digits, const Watch& watch) {
  const RootSum normalized = x.normalized(watch);
  const std::vector<RootTerm>& terms = normalized.terms();
  if (terms.empty()) return "0";
  if (terms.size() == 1 && terms[0].radicand == 1) return to_decimal(terms[0].factor, digits);
  // The sum is irrational, so it lies between two decimals, and some precision shows which ones.
  for (long bits = kMeasureBits;; bits *= 2) {
    if (const auto text = to_decimal(normalized.enclose(bits, watch), digits)) return *text;
  }
}

}  // namespace convexact
