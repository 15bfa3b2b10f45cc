// SPDX-License-Identifier: MIT
#include "simplify/exact_engine.hpp"

#include <set>
#include <utility>

#include "convexact/error.hpp"
#include "simplify/dual_surface.hpp"
#include "simplify/growth_limit.hpp"
#include "simplify/step_verification.hpp"

namespace convexact {
namespace {

// The greedy loop. It is eager: `removals_` and `queue_` are right for every halfspace at any time.
class ExactEngine {
 public:
  ExactEngine(const DualHull& dual, const RationalPoint& center, const SimplifyOptions& options)
      : surface_(dual.halfspaces, dual.triangles, center, options.seed),
        keep_evaluations_(options.keep_evaluations),
        removals_(surface_.size()) {}

  void evaluate_all(const std::atomic<bool>* stop);
  std::size_t left() const { return surface_.left(); }
  bool every_removal_is_unbounded() const { return queue_.empty(); }
  Step cheapest() const;
  void remove(HalfspaceId i);
  std::vector<DualTriangle> triangles() const { return surface_.triangles(); }
  std::vector<Evaluation>& evaluations() { return evaluations_; }

 private:
  void evaluate(HalfspaceId i);
  void forget(HalfspaceId i);

  DualSurface surface_;
  bool keep_evaluations_;
  std::vector<Evaluation> evaluations_;
  std::vector<Removal> removals_;
  std::set<std::pair<Cost, HalfspaceId>> queue_;  // bounded removals; ties in canonical order
};

void stop_if_asked(const std::atomic<bool>* stop) {
  if (stop != nullptr && *stop) throw Error(ErrorCode::Stopped, "interrupted");
}

void ExactEngine::evaluate_all(const std::atomic<bool>* stop) {
  for (std::size_t i = 0; i < removals_.size(); ++i) {
    stop_if_asked(stop);
    evaluate(HalfspaceId(i));
  }
}

void ExactEngine::evaluate(HalfspaceId i) {
  forget(i);
  Removal& removal = removals_[i.index()] = surface_.removal_of(i);
  if (removal.cost) queue_.emplace(*removal.cost, i);
  if (keep_evaluations_) {
    evaluations_.push_back({surface_.size() - left(), i, removal.ring, removal.roof.triangles});
  }
}

void ExactEngine::forget(HalfspaceId i) {
  Removal& removal = removals_[i.index()];
  if (removal.cost) queue_.erase({*removal.cost, i});
  removal = {};
}

Step ExactEngine::cheapest() const {
  const auto& [cost, i] = *queue_.begin();
  const Removal& removal = removals_[i.index()];
  Step step{i, cost, {}, removal.ring, removal.roof.triangles, left() - 1};
  for (auto it = queue_.begin(); it != queue_.end() && it->first == cost; ++it) {
    step.tie.push_back(it->second);
  }
  return step;
}

void ExactEngine::remove(HalfspaceId i) {
  const Removal removal = removals_[i.index()];
  surface_.apply(removal);
  forget(i);
  // Only a cap that plane i bounded can change.
  for (const HalfspaceId j : removal.ring) evaluate(j);
}

}  // namespace

Run simplify_exact(const DualHull& dual, const RationalPoint& center,
                   const SimplifyOptions& options) {
  if (options.faces < 4) {
    throw Error(ErrorCode::InvalidArgument, "a solid needs at least 4 faces");
  }
  ExactEngine engine(dual, center, options);
  StepVerification verification(dual, options.verify, options.seed);
  std::optional<GrowthLimit> growth;
  if (options.max_growth) {
    growth.emplace(to_polytope(dual.halfspaces, dual.triangles), *options.max_growth);
  }
  Run run;
  run.halfspaces = dual.halfspaces;
  if (engine.left() > options.faces) engine.evaluate_all(options.stop);
  while (engine.left() > options.faces) {
    stop_if_asked(options.stop);
    if (engine.every_removal_is_unbounded()) {
      run.stop = StopReason::AllUnbounded;
      break;
    }
    Step step = engine.cheapest();
    if (growth && !growth->allows(step.cost->rational())) {
      run.stop = StopReason::GrowthLimit;
      break;
    }
    verification.check(step);
    engine.remove(step.removed);
    run.steps.push_back(std::move(step));
    if (options.progress) options.progress(engine.left());
  }
  verification.finish();
  run.triangles = engine.triangles();
  run.evaluations = std::move(engine.evaluations());
  return run;
}

}  // namespace convexact
