// SPDX-License-Identifier: MIT
#include "fast/filtered_engine.hpp"

#include "fast/filtered_loop.hpp"

namespace convexact {
namespace {

// Keeps which caps the loop evaluates. Their bounds in DoubleDouble are of the same caps once more.
class EvaluationRecorder : public CostObserver {
 public:
  /// @param steps  The record of the run: as long as the steps made so far.
  EvaluationRecorder(const std::vector<Step>& steps, std::vector<Evaluation>& evaluations)
      : steps_(steps), evaluations_(evaluations) {}

  void in_doubles(HalfspaceId i, const OneRing& ring, const std::vector<RingTriangle>& triangles,
                  const CostBounds<double>&) override {
    const auto& v = ring.vertices;
    Evaluation evaluation{steps_.size(), i, v, {}};
    for (const RingTriangle& t : triangles) {
      evaluation.triangles.push_back({v[t.low], v[t.middle], v[t.high]});
    }
    evaluations_.push_back(std::move(evaluation));
  }

 private:
  const std::vector<Step>& steps_;
  std::vector<Evaluation>& evaluations_;
};

}  // namespace

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
  const FastDual dual = FastDual::of(dual_hull, center);
  Run run;
  run.halfspaces = dual_hull.halfspaces;
  run.kept = options.keep;
  run.measure = options.cost;
  EvaluationRecorder recorder(run.steps, run.evaluations);
  FastResult result =
      FilteredLoop(dual, options, options.keep_evaluations ? &recorder : nullptr).run(&run.steps);
  run.stop = result.stop;
  run.growth_bits = result.growth_bits;
  run.triangles = std::move(result.triangles);
  return run;
}

}  // namespace convexact
