// SPDX-License-Identifier: MIT
#include "simplify/exact_engine.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "convexact/error.hpp"
#include "convexact/measure.hpp"
#include "simplify/growth_limit.hpp"

namespace convexact {
namespace {}  // namespace

// The greedy loop. It is eager: `removals_` and `queue_` are right for every halfspace at any time.
class ExactEngine {
 public:
  ExactEngine(const DualHull& dual, const RationalPoint& center, const SimplifyOptions& options,
              RunObserver* observer)
      : options_(options),
        observer_(observer),
        surface_(dual.halfspaces, dual.triangles, center, options.seed, options.cost),
        removals_(surface_.size()),
        place_(surface_.size()),
        is_kept_(surface_.size(), false) {
    for (const HalfspaceId i : options.keep) is_kept_.at(i.index()) = true;
  }

  void evaluate_all();
  std::size_t left() const { return surface_.left(); }
  bool every_removal_is_unbounded() const { return queue_.empty(); }
  Step cheapest() const;
  // Of a bounded removal, in any measure.
  Cost added_by(HalfspaceId i, CostMeasure measure) {
    return surface_.added_by(removals_[i.index()], measure);
  }
  void remove(HalfspaceId i);
  std::vector<DualTriangle> triangles() const { return surface_.triangles(); }
  std::vector<Evaluation>& evaluations() { return evaluations_; }

 private:
  // A bounded removal, known by bounds of its cost; those of a volume are the volume itself.
  struct Entry {
    Rational low;
    HalfspaceId halfspace;
    Rational high;
    friend bool operator<(const Entry& a, const Entry& b) {
      const int order = a.low.compare(b.low);
      return order != 0 ? order < 0 : a.halfspace < b.halfspace;
    }
  };

  void evaluate(HalfspaceId i);
  void forget(HalfspaceId i);
  static Entry entry_of(HalfspaceId i, const Cost& cost);
  std::vector<HalfspaceId> candidates() const;
  const Cost& cost(HalfspaceId i) const { return *removals_[i.index()].cost; }

  const SimplifyOptions& options_;
  RunObserver* observer_;
  DualSurface surface_;
  std::vector<Evaluation> evaluations_;
  std::vector<Removal> removals_;
  std::set<Entry> queue_;
  std::vector<std::set<Entry>::iterator> place_;  // of bounded removals
  std::vector<bool> is_kept_;
};

void ExactEngine::evaluate_all() {
  for (std::size_t i = 0; i < removals_.size(); ++i) {
    options_.watch.ask();
    evaluate(HalfspaceId(i));
  }
}

ExactEngine::Entry ExactEngine::entry_of(HalfspaceId i, const Cost& cost) {
  if (cost.measure() == CostMeasure::Volume) return {cost.rational(), i, cost.rational()};
  const Enclosure bounds = cost.bounds();
  return {bounds.low(), i, bounds.high()};
}

void ExactEngine::evaluate(HalfspaceId i) {
  if (is_kept_[i.index()]) return;
  forget(i);
  Removal& removal = removals_[i.index()] = surface_.removal_of(i, observer_);
  if (observer_ != nullptr) observer_->evaluated(surface_.size() - left(), removal);
  if (removal.cost) place_[i.index()] = queue_.insert(entry_of(i, *removal.cost)).first;
  if (options_.keep_evaluations) {
    evaluations_.push_back({surface_.size() - left(), i, removal.ring, removal.roof.triangles});
  }
}

void ExactEngine::forget(HalfspaceId i) {
  Removal& removal = removals_[i.index()];
  if (removal.cost) queue_.erase(place_[i.index()]);
  removal = {};
}

// All that bounds cannot distinguish from the cheapest, ascending.
std::vector<HalfspaceId> ExactEngine::candidates() const {
  const Rational* least = &queue_.begin()->high;
  std::vector<HalfspaceId> ids;
  auto entry = queue_.begin();
  for (; entry != queue_.end() && entry->low <= *least; ++entry) {
    if (entry->high < *least) least = &entry->high;
  }
  for (auto each = queue_.begin(); each != entry; ++each) {
    if (each->low <= *least) ids.push_back(each->halfspace);
  }
  std::sort(ids.begin(), ids.end());
  return ids;
}

// A cost that is not proven to differ from the least one counts as a tie.
Step ExactEngine::cheapest() const {
  const std::vector<HalfspaceId> ids = candidates();
  const auto compared = [&](HalfspaceId i, HalfspaceId j) {
    return compare(cost(i), cost(j), options_.compare, options_.watch);
  };
  HalfspaceId least = ids.front();
  for (const HalfspaceId i : ids) {
    if (i != least && compared(i, least).order == Order::Less) least = i;
  }
  Step step;
  for (const HalfspaceId i : ids) {
    if (i != least) {
      const Ordering comparison = compared(i, least);
      if (comparison.order == Order::Greater) continue;
      step.tie_evidence.add({comparison.tie_proof, comparison.bits});
    }
    step.tie.push_back(i);
  }
  const Removal& removal = removals_[step.tie.front().index()];
  step.removed = step.tie.front();
  step.cost = removal.cost;
  step.ring = removal.ring;
  step.triangles = removal.roof.triangles;
  step.left = left() - 1;
  return step;
}

void ExactEngine::remove(HalfspaceId i) {
  const Removal removal = removals_[i.index()];
  surface_.apply(removal);
  forget(i);
  // Only a cap that plane i bounded can change.
  for (const HalfspaceId j : removal.ring) evaluate(j);
}

struct ExactRun::State {
  State(const DualHull& dual, const RationalPoint& center, const SimplifyOptions& asked,
        RunObserver* watching)
      : options(asked),
        observer(watching),
        engine(dual, center, options, observer),
        verification(dual, options.verify, options.seed, options.cost, observer) {
    run.halfspaces = dual.halfspaces;
    run.kept = options.keep;
    run.measure = options.cost;
  }

  const SimplifyOptions& options;
  RunObserver* observer;
  ExactEngine engine;
  StepVerification verification;
  bool is_evaluated = false;
  std::optional<Step> next;
  Run run;
};

ExactRun::ExactRun(const DualHull& dual, const RationalPoint& center,
                   const SimplifyOptions& options, RunObserver* observer) {
  if (options.faces < 4) {
    throw Error(ErrorCode::InvalidArgument, "a solid needs at least 4 faces");
  }
  state_ = std::make_unique<State>(dual, center, options, observer);
}

ExactRun::~ExactRun() = default;

std::size_t ExactRun::left() const { return state_->engine.left(); }

const Step* ExactRun::next() {
  State& state = *state_;
  state.options.watch.ask();
  if (!state.is_evaluated) state.engine.evaluate_all();
  state.is_evaluated = true;
  if (!state.next && !state.engine.every_removal_is_unbounded()) {
    state.next = state.engine.cheapest();
  }
  return state.next ? &*state.next : nullptr;
}

Cost ExactRun::added(CostMeasure measure) {
  return state_->engine.added_by(state_->next.value().removed, measure);
}

Cost ExactRun::measure(CostMeasure kind) const {
  return exact_measure(to_polytope(state_->run.halfspaces, state_->engine.triangles()), kind);
}

void ExactRun::make() {
  State& state = *state_;
  Step step = std::move(state.next.value());
  state.next.reset();
  if (state.observer != nullptr) state.observer->chosen(step);
  state.verification.check(step);
  state.engine.remove(step.removed);
  state.run.steps.push_back(std::move(step));
}

Run ExactRun::finish(StopReason stop) {
  State& state = *state_;
  state.verification.finish();
  state.run.stop = stop;
  state.run.triangles = state.engine.triangles();
  state.run.evaluations = std::move(state.engine.evaluations());
  return std::move(state.run);
}

Run simplify_exact(const DualHull& dual, const RationalPoint& center,
                   const SimplifyOptions& options, RunObserver* observer) {
  ExactRun run(dual, center, options, observer);
  std::optional<GrowthLimit> growth;
  if (options.max_growth) {
    growth.emplace(to_polytope(dual.halfspaces, dual.triangles), options);
  }
  const std::size_t at_start = run.left();
  StopReason stop = StopReason::Reached;
  while (run.left() > options.faces) {
    if (run.next() == nullptr) {
      stop = options.when_stuck();
      break;
    }
    if (growth && !growth->allows(run.added(options.growth_measure()))) {
      stop = StopReason::GrowthLimit;
      break;
    }
    run.make();
    options.watch.report(at_start - run.left(), at_start - options.faces);
  }
  Run record = run.finish(stop);
  if (stop == StopReason::GrowthLimit) record.growth_bits = growth->undecided_bits();
  return record;
}

Run simplify_exact(const DualHull& dual, const RationalPoint& center,
                   const SimplifyOptions& options) {
  return simplify_exact(dual, center, options, nullptr);
}

}  // namespace convexact
