// SPDX-License-Identifier: MIT
// definitional_greedy.hpp - judges a trace by the definition: at each step the halfspaces are
// intersected from scratch without each candidate, and the cheapest ones are compared.
#pragma once
#include <doctest/doctest.h>

#include "cheapest_removals.hpp"
#include "convexact/run.hpp"

namespace definition {

/// Every step must be the cheapest one of those that are not kept, with exactly the true ties; a
/// run that ends for want of bounded removals must have none left.
inline void check_against_definition(const Run& trace, CostMeasure measure = CostMeasure::Volume) {
  const HalfspaceArrangement arrangement(trace.halfspaces);
  Subset left = arrangement.all(), kept = 0;
  for (const HalfspaceId i : trace.kept) kept |= Subset{1} << i.index();
  for (const Step& step : trace.steps) {
    CAPTURE(step.left);
    const Cheapest expected = cheapest_removals(arrangement, left, measure, kept);
    REQUIRE(expected.cost.has_value());
    REQUIRE(in_order(step.cost.value(), *expected.cost) == 0);
    REQUIRE(step.tie == expected.tie);
    REQUIRE(step.removed == expected.tie.front());
    left &= ~(Subset{1} << step.removed.index());
  }
  if (trace.stop == StopReason::AllUnbounded || trace.stop == StopReason::AllKeptOrUnbounded) {
    REQUIRE((trace.stop == StopReason::AllUnbounded) == trace.kept.empty());
    REQUIRE_FALSE(cheapest_removals(arrangement, left, measure, kept).cost.has_value());
  }
}

}  // namespace definition
