// SPDX-License-Identifier: MIT
#include "decompose/merge_cost.hpp"

namespace convexact {
namespace {

bool is_zero(const RootSum& difference, const Watch& watch) {
  return difference.terms().empty() || difference.normalized(watch).terms().empty();
}

}  // namespace

Enclosure CostOrder::enclose(const MergeCost& cost, long precision, const Watch& watch) const {
  Enclosure sum = sqrt(Enclosure(cost.squared_concavity, precision));
  if (cost.doubled_area.terms().empty()) return sum;
  const Enclosure perimeter = cost.perimeter.enclose(precision, watch);
  Enclosure shape = perimeter * perimeter;
  shape /= Enclosure(Rational(20), precision) * Enclosure::pi(precision) *
           cost.doubled_area.enclose(precision, watch);
  return sum += sqrt(Enclosure(squared_weight_, precision)) * shape;
}

Ordering CostOrder::compare(const MergeCost& a, const MergeCost& b, const Watch& watch) const {
  for (long bits = 128; bits <= kMostBits; bits *= 2) {
    const Enclosure difference = enclose(a, bits, watch) - enclose(b, bits, watch);
    if (const auto sign = difference.sign(); sign && *sign != Sign::Zero) {
      return {*sign == Sign::Negative ? Order::Less : Order::Greater, std::nullopt, bits};
    }
    if (bits == 128 && a.squared_concavity == b.squared_concavity &&
        is_zero(a.perimeter - b.perimeter, watch) &&
        is_zero(a.doubled_area - b.doubled_area, watch)) {
      return {Order::Equal, TieProof::SquareClasses, bits};
    }
  }
  return {Order::Undecided, TieProof::Undecided, kMostBits};
}

}  // namespace convexact
