// SPDX-License-Identifier: MIT
#include <algorithm>
#include <tuple>
#include <utility>

#include "convexact/cost.hpp"
#include "convexact/error.hpp"
#include "number/angle_basis.hpp"
#include "number/normal_form.hpp"
#include "number/ordering.hpp"
#include "number/precision.hpp"

namespace convexact {
namespace {

auto key_of(const AngleTerm& term) {
  return std::tie(term.squared_length, term.squared_cross, term.dot);
}

bool is_zero(const AngleTerm& term) {
  return term.factor == 0 || term.squared_length == 0 || (term.squared_cross == 0 && term.dot > 0);
}

// Sorted by everything but the factor, each once, without zeros.
std::vector<AngleTerm> collected_angles(std::vector<AngleTerm> terms) {
  std::sort(terms.begin(), terms.end(),
            [](const AngleTerm& a, const AngleTerm& b) { return key_of(a) < key_of(b); });
  std::vector<AngleTerm> result;
  for (AngleTerm& term : terms) {
    if (!result.empty() && key_of(result.back()) == key_of(term)) {
      result.back().factor += term.factor;
    } else {
      result.push_back(std::move(term));
    }
  }
  std::erase_if(result, is_zero);
  return result;
}

}  // namespace

AngleSum::AngleSum(std::vector<AngleTerm> terms) {
  for (const AngleTerm& term : terms) {
    if (term.squared_length < 0 || term.squared_cross < 0) {
      throw Error(ErrorCode::InvalidArgument, "a square is negative");
    }
    if (term.squared_cross == 0 && term.dot == 0) {
      throw Error(ErrorCode::InvalidArgument, "an angle of the zero vector");
    }
  }
  terms_ = collected_angles(std::move(terms));
}

AngleSum AngleSum::pi(const Rational& factor) { return AngleSum({{factor, 1, 0, -1}}); }

AngleSum& AngleSum::operator+=(const AngleSum& other) {
  std::vector<AngleTerm> all = std::move(terms_);
  all.insert(all.end(), other.terms_.begin(), other.terms_.end());
  terms_ = collected_angles(std::move(all));
  return *this;
}

AngleSum& AngleSum::operator*=(const Rational& factor) {
  if (factor == 0) terms_.clear();
  for (AngleTerm& term : terms_) term.factor *= factor;
  return *this;
}

AngleSum AngleSum::operator-() const {
  AngleSum result = *this;
  for (AngleTerm& term : result.terms_) term.factor = -term.factor;
  return result;
}

Enclosure AngleSum::enclose(long precision, const Watch& watch) const {
  Enclosure sum(precision);
  for (const AngleTerm& term : terms_) {
    watch.ask();
    const Enclosure angle =
        atan2(sqrt(Enclosure(term.squared_cross, precision)), Enclosure(term.dot, precision));
    sum +=
        Enclosure(term.factor, precision) * sqrt(Enclosure(term.squared_length, precision)) * angle;
  }
  return sum;
}

namespace {

// Steps (3) to (5) of compare(): the order of a difference in normal form to 0.
Ordering compare_to_zero(const std::vector<ReducedAngles>& form, const CompareLimits& limits,
                         const Watch& watch) {
  const AngleSum difference = to_angle_sum(form);
  bool is_different = false;  // proven
  long bits = std::min(2 * kMeasureBits, limits.bits);
  for (bool is_first = true;; is_first = false) {
    if (const std::optional<Order> order = order_to_zero(difference.enclose(bits, watch))) {
      return {*order, {}, bits};
    }
    if (is_first && limits.angle_basis) {
      const std::optional<bool> vanishes = vanishes_in_angle_basis(form, watch);
      if (vanishes.value_or(false)) return {Order::Equal, TieProof::AngleBasis, bits};
      is_different = vanishes.has_value();
    }
    if (bits >= limits.bits && !is_different) break;
    bits = is_different ? 2 * bits : std::min(2 * bits, limits.bits);
  }
  return {Order::Undecided, TieProof::Undecided, bits};
}

}  // namespace

Ordering compare(const AngleSum& a, const AngleSum& b, const CompareLimits& limits,
                 const Watch& watch) {
  if (limits.bits < 1) throw Error(ErrorCode::InvalidArgument, "a limit is at least one bit");
  const AngleSum difference = a - b;
  if (difference.terms().empty()) return {Order::Equal, TieProof::NormalForm, 0};
  // (1) As many bits as every ordinary comparison needs.
  const long first = std::min(kMeasureBits, limits.bits);
  if (const std::optional<Order> order = order_to_zero(difference.enclose(first, watch))) {
    return {*order, {}, first};
  }
  // (2) The normal form.
  const std::vector<ReducedAngles> form = normal_form(difference, watch);
  if (form.empty()) return {Order::Equal, TieProof::NormalForm, first};
  return compare_to_zero(form, limits, watch);
}

}  // namespace convexact
