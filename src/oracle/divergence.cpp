// SPDX-License-Identifier: MIT
#include "oracle/divergence.hpp"

#include <algorithm>

#include "convexact/error.hpp"
#include "convexact/watch.hpp"
#include "fast/filtered_loop.hpp"

namespace convexact {

// ---- Two runs

namespace {

// The first step at which the runs differ in anything, or where the shorter one ends.
std::size_t common_steps(const Run& a, const Run& b) {
  const bool with_records = have_records(a, b);
  const auto is_same = [&](const Step& x, const Step& y) {
    return x.removed == y.removed && (!with_records || (x.cost == y.cost && x.tie == y.tie));
  };
  const auto [end, other_end] =
      std::mismatch(a.steps.begin(), a.steps.end(), b.steps.begin(), b.steps.end(), is_same);
  return static_cast<std::size_t>(end - a.steps.begin());
}

std::optional<HalfspaceId> removal_at(const Run& run, std::size_t step) {
  if (step >= run.steps.size()) return std::nullopt;
  return run.steps[step].removed;
}

// What is left after some steps of a run, and the cost of each removal from it by the definition.
class CostsAt {
 public:
  CostsAt(const Run& run, const RationalPoint& center, std::size_t step)
      : halfspaces_(run.halfspaces), oracle_(left_after(run, step), center) {}

  RemovalCost operator()(HalfspaceId id) const { return oracle_.without(halfspaces_[id.index()]); }
  // An end has no cost.
  RemovalCost operator()(const Choice& choice) const {
    return choice.removed ? (*this)(*choice.removed) : RemovalCost{};
  }

 private:
  const std::vector<Halfspace>& halfspaces_;
  RemovalOracle oracle_;
};

// The same removal, recorded differently: the definition decides which record is wrong, as far as
// the halfspaces that only one of them listed as tied go.
void judge_record(Divergence& found, const Step& reference, const Step& other,
                  const CostsAt& costs) {
  found.kind = DivergenceKind::WrongRecord;
  found.reference.cost = reference.cost;
  found.other.cost = other.cost;
  std::vector<HalfspaceId> candidates;
  std::set_symmetric_difference(reference.tie.begin(), reference.tie.end(), other.tie.begin(),
                                other.tie.end(), std::back_inserter(candidates));
  const std::optional<Rational> cost = costs(reference.removed).cost;
  const std::vector<HalfspaceId>& listed = reference.tie;
  const bool is_true = cost && reference.cost == *cost &&
                       std::all_of(candidates.begin(), candidates.end(), [&](HalfspaceId id) {
                         const bool is_listed =
                             std::find(listed.begin(), listed.end(), id) != listed.end();
                         return is_listed == (costs(id).cost == cost);
                       });
  found.reference_at_fault = !is_true;
}

// Two different bounded removals.
void judge_costs(Divergence& found, const RemovalCost& reference, const RemovalCost& other) {
  const Rational &a = *reference.cost, &b = *other.cost;
  if (a == b) {
    found.kind = DivergenceKind::Tie;
    found.reference_at_fault = *found.other.removed < *found.reference.removed;
    found.regret = Rational(0);
    return;
  }
  found.reference_at_fault = b < a;
  const Rational lower = std::min(a, b), gap = std::max(a, b) - lower;
  std::optional<Rational> rounding;
  if (reference.rounding && other.rounding) rounding = *reference.rounding + *other.rounding;
  found.kind =
      !rounding || gap <= *rounding ? DivergenceKind::BelowRounding : DivergenceKind::WrongTopology;
  if (lower == 0) return;
  found.regret = gap / lower;
  if (rounding) found.rounding = *rounding / lower;
}

Divergence choices_at(std::size_t step, std::size_t halfspaces,
                      std::optional<HalfspaceId> reference, std::optional<HalfspaceId> other) {
  return {step, halfspaces - step, DivergenceKind::WrongRecord, {reference, {}}, {other, {}}};
}

}  // namespace

Divergence judge_choices(const Run& run, const RationalPoint& center, std::size_t step,
                         std::optional<HalfspaceId> reference, std::optional<HalfspaceId> other) {
  Divergence found = choices_at(step, run.halfspaces.size(), reference, other);
  const CostsAt costs(run, center, step);
  const RemovalCost first = costs(found.reference), second = costs(found.other);
  found.reference.cost = first.cost;
  found.other.cost = second.cost;
  if (first.cost && second.cost) {
    judge_costs(found, first, second);
  } else {
    // A run without a cost ended, or removed a halfspace that it must not. If both have none, the
    // one that removed something is wrong; if both did, both are wrong. Rounding explains an end if
    // the remaining removal would be unbounded for planes a little off.
    const bool has_ended = !found.reference.removed || !found.other.removed;
    const RemovalCost& left = first.cost ? first : second;
    found.kind = has_ended && left.cost && !left.rounding ? DivergenceKind::BelowRounding
                                                          : DivergenceKind::WrongBoundedness;
    found.reference_at_fault = !first.cost && (second.cost || found.reference.removed);
  }
  return found;
}

std::optional<Divergence> find_divergence(const RationalPoint& center, const Run& reference,
                                          const Run& other) {
  const std::size_t step = common_steps(reference, other);
  const auto first = removal_at(reference, step), second = removal_at(other, step);
  if (first != second) return judge_choices(reference, center, step, first, second);
  if (!first && reference.stop == other.stop) return std::nullopt;
  Divergence found = choices_at(step, reference.halfspaces.size(), first, second);
  if (first) {
    judge_record(found, reference.steps[step], other.steps[step], {reference, center, step});
  }
  return found;
}

bool have_records(const Run& a, const Run& b) {
  const auto has_cost = [](const Step& step) { return step.cost.has_value(); };
  return std::all_of(a.steps.begin(), a.steps.end(), has_cost) &&
         std::all_of(b.steps.begin(), b.steps.end(), has_cost);
}

const Divergence& worst_of(std::span<const Divergence> divergences) {
  const auto is_better = [](const Divergence& a, const Divergence& b) {
    if (a.kind != b.kind) return a.kind < b.kind;
    return a.regret && (!b.regret || *a.regret < *b.regret);
  };
  return *std::max_element(divergences.begin(), divergences.end(), is_better);
}

bool is_explained(const Divergence& divergence, Engine reference, Engine other) {
  const Engine at_fault = divergence.reference_at_fault ? reference : other;
  return at_fault == Engine::Float && (divergence.kind == DivergenceKind::Tie ||
                                       divergence.kind == DivergenceKind::BelowRounding);
}

// ---- One run, step by step

namespace {

// Judges one step after another; `tell` gets each divergence and says whether to go on.
template <class Tell>
void follow(const DualHull& dual, const RationalPoint& center, const Run& run,
            const std::atomic<bool>* stop, Tell&& tell) {
  const FastDual fast = FastDual::of(dual, center);
  const SimplifyOptions options;
  FilteredLoop loop(fast, options);
  loop.evaluate_all();
  for (std::size_t step = 0; step < run.steps.size(); ++step) {
    Watch(stop).ask();
    const HalfspaceId chosen = run.steps[step].removed;
    const std::optional<HalfspaceId> cheapest = loop.choose();
    if (cheapest != chosen) {
      const std::vector<HalfspaceId>& tie = loop.tie();
      const bool is_tied = cheapest && std::find(tie.begin(), tie.end(), chosen) != tie.end();
      Divergence found = is_tied ? choices_at(step, dual.halfspaces.size(), cheapest, chosen)
                                 : judge_choices(run, center, step, cheapest, chosen);
      if (is_tied) {
        found.kind = DivergenceKind::Tie;
        found.reference.cost = found.other.cost = loop.exact_cost(chosen);
        found.regret = Rational(0);
      }
      if (!tell(std::move(found)) || !loop.is_bounded(chosen)) return;
    }
    loop.remove(chosen);
  }
  if (run.stop != StopReason::AllUnbounded) return;
  if (const std::optional<HalfspaceId> missed = loop.choose()) {
    tell(judge_choices(run, center, run.steps.size(), missed, {}));
  }
}

}  // namespace

std::vector<Divergence> check_greedy(const DualHull& dual, const RationalPoint& center,
                                     const Run& run, const std::atomic<bool>* stop) {
  std::vector<Divergence> found;
  follow(dual, center, run, stop, [&](Divergence divergence) {
    found.push_back(std::move(divergence));
    return true;
  });
  return found;
}

std::optional<Divergence> first_wrong_step(const DualHull& dual, const RationalPoint& center,
                                           const Run& run, const std::atomic<bool>* stop) {
  std::optional<Divergence> wrong;
  follow(dual, center, run, stop, [&](Divergence divergence) {
    if (divergence.kind != DivergenceKind::Tie) wrong = std::move(divergence);
    return !wrong;
  });
  return wrong;
}

}  // namespace convexact
