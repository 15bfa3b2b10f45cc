// SPDX-License-Identifier: MIT
// check_float_bound.hpp - compares the float engine's bounds on its errors with exact numbers.
#pragma once
#include <doctest/doctest.h>

#include <cmath>

#include "fast/filtered_loop.hpp"
#include "fast/float_engine.hpp"

namespace convexact {

// The filtered loop follows the float engine's removals and gives the exact cost of each and of the
// cheapest in each state; it is tested against the definition elsewhere.
inline void check_float_bound(const FastDual& dual, const FastResult& result,
                              CostMeasure measure = CostMeasure::Volume) {
  REQUIRE(result.bound.has_value());
  const FloatBound& bound = *result.bound;
  CHECK(bound.doubtful <= result.steps.size());
  const SimplifyOptions options{.cost = measure};
  FilteredLoop loop(dual, options);
  loop.evaluate_all();
  std::size_t worse = 0, wrong = 0;
  for (const FastStep& step : result.steps) {
    const auto best = loop.choose();
    REQUIRE(best.has_value());
    REQUIRE(loop.is_bounded(step.removed));
    constexpr long kBits = 200;  // volumes are exact to about this, too
    const Enclosure least = loop.cost(*best).enclose(kBits);
    const Enclosure cost = loop.cost(step.removed).enclose(kBits);
    worse += cost.low() > (1 + to_rational(bound.regret)) * least.high();
    const long exponent = -dual.cost_exponent(measure);
    const Rational low = scale_by_power_of_two(cost.low(), exponent);
    const Rational high = scale_by_power_of_two(cost.high(), exponent);
    const Rational share = to_rational(bound.cost);
    wrong += !std::isfinite(step.cost_lower) || to_rational(step.cost_lower) < (1 - share) * low ||
             to_rational(step.cost_lower) > (1 + share) * high;
    loop.remove(step.removed);
  }
  CHECK(worse <= bound.doubtful);
  CHECK(wrong <= bound.doubtful);
  if (const auto next = loop.choose()) {
    CHECK(std::isfinite(bound.least_next));
    const Rational cost = loop.cost(*next).enclose(200).high();
    CHECK(to_rational(bound.least_next) <=
          scale_by_power_of_two(cost, -dual.cost_exponent(measure)));
  }
  if (bound.is_end_proven && result.stop == StopReason::AllUnbounded) {
    CHECK_FALSE(loop.choose().has_value());
  }
}

}  // namespace convexact
