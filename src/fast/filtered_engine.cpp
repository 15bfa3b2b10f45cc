// SPDX-License-Identifier: MIT
#include "fast/filtered_engine.hpp"

#include "fast/filtered_loop.hpp"

namespace convexact {
namespace {

// Keeps which caps the loop evaluates.
class EvaluationRecorder : public NoAudit {
 public:
  /// @param steps  The record of the run: as long as the steps made so far.
  EvaluationRecorder(const std::vector<Step>& steps, std::vector<Evaluation>& evaluations)
      : steps_(steps), evaluations_(evaluations) {}

  void cap(HalfspaceId i, const OneRing& ring, const std::vector<RingTriangle>& triangles,
           const CapRange<double>&) {
    const auto& v = ring.vertices;
    Evaluation evaluation{steps_.size(), i, v, {}};
    for (const RingTriangle& t : triangles) {
      evaluation.triangles.push_back({v[t.low], v[t.middle], v[t.high]});
    }
    evaluations_.push_back(std::move(evaluation));
  }
  // The same cap once more.
  void cap(HalfspaceId, const OneRing&, const std::vector<RingTriangle>&,
           const CapRange<DoubleDouble>&) {}

 private:
  const std::vector<Step>& steps_;
  std::vector<Evaluation>& evaluations_;
};

template <class Audit>
void run_with_record(const FastDual& dual, const SimplifyOptions& options, Audit& audit,
                     Simplification& simplification) {
  FastResult result = FilteredLoop<Audit>(dual, options, audit).run(&simplification.trace.steps);
  simplification.trace.stop = result.stop;
  simplification.triangles = std::move(result.triangles);
}

}  // namespace

FastResult simplify_filtered(const FastDual& dual, const SimplifyOptions& options) {
  NoAudit audit;
  return FilteredLoop<>(dual, options, audit).run();
}

Simplification simplify_filtered(const DualHull& solid, const RationalPoint& center,
                                 const SimplifyOptions& options) {
  const FastDual dual = FastDual::of(solid, center);
  Simplification simplification;
  simplification.trace.halfspaces = solid.halfspaces;
  if (options.keep_evaluations) {
    EvaluationRecorder recorder(simplification.trace.steps, simplification.evaluations);
    run_with_record(dual, options, recorder, simplification);
  } else {
    NoAudit audit;
    run_with_record(dual, options, audit, simplification);
  }
  return simplification;
}

}  // namespace convexact
