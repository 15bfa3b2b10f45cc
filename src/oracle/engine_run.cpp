// SPDX-License-Identifier: MIT
#include "oracle/engine_run.hpp"

#include "fast/dual.hpp"
#include "fast/filtered_engine.hpp"
#include "fast/float_engine.hpp"
#include "simplify/exact_engine.hpp"

namespace convexact {
namespace {

EngineRun with_record(Engine engine, const Trace& trace) {
  EngineRun run{engine, {}, {}, {}, trace.stop};
  for (const Step& step : trace.steps) {
    run.removed.push_back(step.removed);
    run.costs.push_back(step.cost);
    run.ties.push_back(step.tie);
  }
  return run;
}

}  // namespace

EngineRun run_engine(Engine engine, const DualHull& solid, const RationalPoint& center,
                     const SimplifyOptions& options, bool record) {
  if (engine == Engine::Exact) {
    return with_record(engine, simplify_exact(solid, center, options).trace);
  }
  if (engine == Engine::Filtered && record) {
    return with_record(engine, simplify_filtered(solid, center, options).trace);
  }
  const FastDual dual = FastDual::of(solid, center);
  const FastResult result =
      engine == Engine::Float ? simplify_float(dual, options) : simplify_filtered(dual, options);
  EngineRun run{engine, {}, {}, {}, result.stop};
  for (const FastStep& step : result.steps) run.removed.push_back(step.removed);
  return run;
}

std::vector<Halfspace> left_after(std::span<const Halfspace> halfspaces, const EngineRun& run,
                                  std::size_t count) {
  std::vector<char> is_gone(halfspaces.size(), false);
  for (std::size_t s = 0; s < count; ++s) is_gone[run.removed[s].index()] = true;
  std::vector<Halfspace> left;
  for (std::size_t i = 0; i < halfspaces.size(); ++i) {
    if (!is_gone[i]) left.push_back(halfspaces[i]);
  }
  return left;
}

}  // namespace convexact
