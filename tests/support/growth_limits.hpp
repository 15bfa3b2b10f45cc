// SPDX-License-Identifier: MIT
// growth_limits.hpp - limits of growth that a run hits exactly, or misses by almost nothing.
#pragma once
#include <vector>

#include "convexact/measure.hpp"
#include "convexact/run.hpp"

/// A limit and, by its definition, how many steps of the run stay within it: the longest prefix
/// with V <= (1 + g) V0.
struct GrowthCase {
  convexact::Rational limit;
  std::size_t steps;
};

/// The growth by the first `count` steps exactly, that plus less than 2^-80 of it, and, for a count
/// above 0, that minus as little.
inline std::vector<GrowthCase> limits_after(const convexact::Run& trace,
                                            const convexact::Rational& volume, std::size_t count) {
  using namespace convexact;
  Rational grown = 0;
  for (std::size_t s = 0; s < count; ++s) grown += trace.steps[s].cost->rational();
  const Rational exactly = grown / volume, next_to_nothing = scale_by_power_of_two(exactly, -81);
  std::vector<GrowthCase> cases{{exactly, count}};
  if (count == 0) return cases;
  cases.push_back({exactly - next_to_nothing, count - 1});
  // At most half of the next step, in case that is tiny.
  Rational more = next_to_nothing;
  if (count < trace.steps.size()) {
    more = std::min(more, Rational(trace.steps[count].cost->rational() / volume / 2));
  }
  cases.push_back({exactly + more, count});
  return cases;
}
