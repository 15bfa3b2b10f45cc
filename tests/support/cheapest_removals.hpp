// SPDX-License-Identifier: MIT
// cheapest_removals.hpp - the cheapest removals, by the definition: the halfspaces are
// intersected from scratch without each candidate.
#pragma once
#include <array>

#include "convexact/error.hpp"
#include "convexact/geometry.hpp"
#include "halfspace_arrangement.hpp"

namespace definition {

/// The removals of least cost; none if every one is unbounded.
struct Cheapest {
  std::optional<Cost> cost;
  std::vector<HalfspaceId> tie;  // ascending
};

/// The order of two costs of one measure. Costs that cannot be told apart fail the calling test.
inline std::strong_ordering in_order(const Cost& a, const Cost& b) {
  switch (compare(a, b).order) {
    case Order::Less:
      return std::strong_ordering::less;
    case Order::Greater:
      return std::strong_ordering::greater;
    case Order::Equal:
      return std::strong_ordering::equal;
    case Order::Undecided:
      break;
  }
  throw Error(ErrorCode::Internal, "undecided");
}

/// @param kept  Halfspaces that must stay, whatever their cost.
inline Cheapest cheapest_removals(const HalfspaceArrangement& arrangement, Subset left,
                                  CostMeasure measure = CostMeasure::Volume, Subset kept = 0) {
  Cost before = arrangement.measure(left, measure).value();
  before *= -1;
  Cheapest best;
  for (std::size_t i = 0; i < arrangement.size(); ++i) {
    const Subset bit = Subset{1} << i;
    if ((left & ~kept & bit) == 0) continue;
    const std::optional<Cost> after = arrangement.measure(left & ~bit, measure);
    if (!after) continue;
    const std::array<Cost, 2> parts{*after, before};
    const Cost cost = sum_of(parts);
    if (!best.cost || in_order(cost, *best.cost) < 0) best = {cost, {}};
    if (in_order(cost, *best.cost) == 0) best.tie.emplace_back(i);
  }
  return best;
}

}  // namespace definition
