// SPDX-License-Identifier: MIT
// cheapest_removals.hpp - the cheapest removals, by the definition: the halfspaces are
// intersected from scratch without each candidate.
#pragma once
#include "convexact/point_set.hpp"
#include "halfspace_arrangement.hpp"

namespace definition {

/// The removals of least cost; none if every one is unbounded.
struct Cheapest {
  std::optional<Rational> cost;
  std::vector<HalfspaceId> tie;  // ascending
};

inline Cheapest cheapest_removals(const HalfspaceArrangement& arrangement, Subset left) {
  const Rational before = arrangement.volume(left).value();
  Cheapest best;
  for (std::size_t i = 0; i < arrangement.size(); ++i) {
    const Subset bit = Subset{1} << i;
    if ((left & bit) == 0) continue;
    const std::optional<Rational> after = arrangement.volume(left & ~bit);
    if (!after) continue;
    const Rational cost = *after - before;
    if (!best.cost || cost < *best.cost) best = {cost, {}};
    if (cost == *best.cost) best.tie.emplace_back(i);
  }
  return best;
}

}  // namespace definition
