// SPDX-License-Identifier: MIT
// check_float_bound.hpp - compares the float engine's bounds on its own errors with exact numbers.
#pragma once
#include <doctest/doctest.h>

#include <cmath>

#include "fast/filtered_loop.hpp"
#include "fast/float_engine.hpp"

namespace convexact {

// The filtered loop, made to follow the float engine's removals, knows the exact cost of each and
// of the cheapest at each state: it is tested against the definition elsewhere.
inline void check_float_bound(const FastDual& dual, const FastResult& result) {
  REQUIRE(result.bound.has_value());
  const FloatBound& bound = *result.bound;
  CHECK(bound.doubtful <= result.steps.size());
  const SimplifyOptions options;
  FilteredLoop loop(dual, options);
  if (!result.steps.empty()) loop.evaluate_all();
  std::size_t worse = 0, wrong = 0;
  for (const FastStep& step : result.steps) {
    const auto best = loop.choose();
    REQUIRE(best.has_value());
    REQUIRE(loop.is_bounded(step.removed));
    const Rational least = loop.exact_cost(*best), cost = loop.exact_cost(step.removed);
    worse += cost > (1 + to_rational(bound.regret)) * least;
    const Rational scaled = scale_by_power_of_two(cost, -dual.volume_exponent());
    wrong +=
        !std::isfinite(step.cost_lower) ||
        abs(Rational(to_rational(step.cost_lower) - scaled)) > to_rational(bound.cost) * scaled;
    loop.remove(step.removed);
  }
  CHECK(worse <= bound.doubtful);
  CHECK(wrong <= bound.doubtful);
  if (bound.is_end_proven && result.stop == StopReason::AllUnbounded) {
    CHECK_FALSE(loop.choose().has_value());
  }
}

}  // namespace convexact
