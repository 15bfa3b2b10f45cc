// SPDX-License-Identifier: MIT
#include "fast/engines.hpp"

#include "fast/filtered_loop.hpp"

namespace convexact {

FastResult simplify_filtered(const FastDual& dual, const SimplifyOptions& options) {
  return FilteredLoop(dual, options).run();
}

Run run_of(const FastResult& result, std::vector<Halfspace> halfspaces) {
  Run run;
  run.halfspaces = std::move(halfspaces);
  run.stop = result.stop;
  run.growth_bits = result.growth_bits;
  run.is_greedy = !result.bound;
  std::size_t left = run.halfspaces.size();
  for (const FastStep& fast : result.steps) {
    Step& step = run.steps.emplace_back();
    step.removed = fast.removed;
    step.left = --left;
  }
  return run;
}

Run simplify_filtered(const DualHull& dual_hull, const RationalPoint& center,
                      const SimplifyOptions& options) {
  RecordedLoop recorded(dual_hull, center, options);
  return recorded.finish(recorded.loop().run(recorded.steps()));
}

}  // namespace convexact
