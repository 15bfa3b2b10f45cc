// SPDX-License-Identifier: MIT
#include "simplify/exact_engine.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "convexact/dual.hpp"
#include "convexact/error.hpp"
#include "simplify/cap.hpp"
#include "simplify/growth_limit.hpp"
#include "simplify/ring_triangulation.hpp"
#include "simplify/step_verification.hpp"

namespace convexact {
namespace {

// What removing one halfspace would do.
struct Removal {
  std::vector<HalfspaceId> ring;
  RingTriangulation roof;        // T_i
  std::optional<Rational> cost;  // volume of the cap; none if it is unbounded
};

// The greedy loop. It is eager: `removals_` and `queue_` are right for every halfspace at any time.
class ExactEngine {
 public:
  ExactEngine(const DualHull& solid, const RationalPoint& center, const SimplifyOptions& options);

  void evaluate_all(const std::atomic<bool>* stop);
  std::size_t left() const { return left_; }
  bool every_removal_is_unbounded() const { return queue_.empty(); }
  Step cheapest() const;
  void remove(HalfspaceId i);
  std::vector<DualTriangle> triangles() const { return dual_.triangles(); }
  std::vector<Evaluation>& evaluations() { return evaluations_; }

 private:
  Removal removal_of(HalfspaceId i);
  void evaluate(HalfspaceId i);
  void forget(HalfspaceId i);

  std::vector<DualPoint> points_;
  AdjacencyMatrix dual_;
  Random random_;
  bool keep_evaluations_;
  std::vector<Evaluation> evaluations_;
  std::vector<Removal> removals_;
  std::set<std::pair<Rational, HalfspaceId>> queue_;  // bounded removals; ties in canonical order
  std::size_t left_;
};

ExactEngine::ExactEngine(const DualHull& solid, const RationalPoint& center,
                         const SimplifyOptions& options)
    : dual_(solid.halfspaces.size()),
      random_(options.seed),
      keep_evaluations_(options.keep_evaluations),
      removals_(solid.halfspaces.size()),
      left_(solid.halfspaces.size()) {
  for (const Halfspace& halfspace : solid.halfspaces) points_.push_back(polar(halfspace, center));
  for (const DualTriangle& triangle : solid.triangles) dual_.add(triangle);
}

void stop_if_asked(const std::atomic<bool>* stop) {
  if (stop != nullptr && *stop) throw Error(ErrorCode::Stopped, "interrupted");
}

void ExactEngine::evaluate_all(const std::atomic<bool>* stop) {
  for (std::size_t i = 0; i < removals_.size(); ++i) {
    stop_if_asked(stop);
    evaluate(HalfspaceId(i));
  }
}

// Steps as in docs/construction.md.
Removal ExactEngine::removal_of(HalfspaceId i) {
  Removal removal;
  // (1) The neighbours of the dual point, in order.
  removal.ring = dual_.one_ring(i);
  const std::vector<HalfspaceId>& ring = removal.ring;
  // (2) The dual hull without the point differs only inside the ring.
  removal.roof = triangulate_ring(points_, ring, random_);
  // (3) A new dual face without a vertex: the solid would reach to infinity.
  if (!removal.roof.is_bounded()) return removal;
  // (4) The cap lies between the old vertices on plane i and the new ones.
  const Cap cap = make_cap(points_, i, ring, removal.roof);
  // (5) Its volume is the price.
  removal.cost = volume(cap);
  return removal;
}

void ExactEngine::evaluate(HalfspaceId i) {
  forget(i);
  Removal& removal = removals_[i.index()] = removal_of(i);
  if (removal.cost) queue_.emplace(*removal.cost, i);
  if (keep_evaluations_) {
    evaluations_.push_back({removals_.size() - left_, i, removal.ring, removal.roof.triangles});
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
  Step step{i, cost, {}, removal.ring, removal.roof.triangles, left_ - 1};
  for (auto it = queue_.begin(); it != queue_.end() && it->first == cost; ++it) {
    step.tie.push_back(it->second);
  }
  return step;
}

void ExactEngine::remove(HalfspaceId i) {
  const Removal removal = removals_[i.index()];
  const std::vector<HalfspaceId>& ring = removal.ring;
  for (std::size_t t = 0; t < ring.size(); ++t) {
    dual_.remove({i, ring[t], ring[(t + 1) % ring.size()]});
  }
  for (const DualTriangle& triangle : removal.roof.triangles) dual_.add(triangle);
  forget(i);
  --left_;
  // Only a cap that plane i bounded can change.
  for (const HalfspaceId j : ring) evaluate(j);
}

}  // namespace

Simplification simplify_exact(const DualHull& solid, const RationalPoint& center,
                              const SimplifyOptions& options) {
  if (options.faces < 4) {
    throw Error(ErrorCode::InvalidArgument, "a solid needs at least 4 faces");
  }
  ExactEngine engine(solid, center, options);
  StepVerification verification(solid, options.verify, options.seed);
  std::optional<GrowthLimit> growth;
  if (options.max_growth) {
    growth.emplace(to_polytope(solid.halfspaces, solid.triangles), *options.max_growth);
  }
  Trace trace{solid.halfspaces, {}, StopReason::Reached};
  if (engine.left() > options.faces) engine.evaluate_all(options.stop);
  while (engine.left() > options.faces) {
    stop_if_asked(options.stop);
    if (engine.every_removal_is_unbounded()) {
      trace.stop = StopReason::AllUnbounded;
      break;
    }
    Step step = engine.cheapest();
    if (growth && !growth->allows(step.cost)) {
      trace.stop = StopReason::GrowthLimit;
      break;
    }
    verification.check(step);
    engine.remove(step.removed);
    trace.steps.push_back(std::move(step));
    if (options.progress) options.progress(engine.left());
  }
  verification.finish();
  return {std::move(trace), engine.triangles(), std::move(engine.evaluations())};
}

}  // namespace convexact
