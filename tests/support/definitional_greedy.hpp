// SPDX-License-Identifier: MIT
// definitional_greedy.hpp - judges a trace by the definition: at each step the halfspaces are
// intersected from scratch without each candidate, and the cheapest ones are compared.
#pragma once
#include <doctest/doctest.h>

#include "convexact/simplify/trace.hpp"
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

/// Every step is the cheapest one, with exactly the ties that there are; a run that says so has
/// really nothing bounded left to remove.
inline void check_against_definition(const Trace& trace) {
  const HalfspaceArrangement arrangement(trace.halfspaces);
  Subset left = arrangement.all();
  for (const Step& step : trace.steps) {
    CAPTURE(step.left);
    const Cheapest expected = cheapest_removals(arrangement, left);
    REQUIRE(expected.cost.has_value());
    REQUIRE(step.cost == *expected.cost);
    REQUIRE(step.tie == expected.tie);
    REQUIRE(step.removed == expected.tie.front());
    left &= ~(Subset{1} << step.removed.index());
  }
  if (trace.stop == StopReason::AllUnbounded) {
    REQUIRE_FALSE(cheapest_removals(arrangement, left).cost.has_value());
  }
}

}  // namespace definition
