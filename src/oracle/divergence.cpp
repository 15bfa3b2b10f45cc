// SPDX-License-Identifier: MIT
#include "oracle/divergence.hpp"

#include <algorithm>

namespace convexact {
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

// Whether a step's recorded cost and ties are what the definition says, as far as `candidates` (all
// that either run listed) go.
bool is_true_record(const Step& step, const Rational& cost,
                    const std::vector<HalfspaceId>& candidates,
                    std::span<const Halfspace> halfspaces, const RemovalOracle& oracle) {
  if (step.cost != cost) return false;
  const std::vector<HalfspaceId>& listed = step.tie;
  return std::all_of(candidates.begin(), candidates.end(), [&](HalfspaceId id) {
    const bool is_tied = oracle.without(halfspaces[id.index()]).cost == cost;
    return is_tied == (std::find(listed.begin(), listed.end(), id) != listed.end());
  });
}

// The same removal, recorded differently: the definition decides which record is wrong.
void judge_record(Divergence& found, const Step& reference, const Step& other,
                  std::span<const Halfspace> halfspaces, const RemovalOracle& oracle) {
  found.kind = DivergenceKind::WrongRecord;
  found.reference.cost = reference.cost;
  found.other.cost = other.cost;
  std::vector<HalfspaceId> candidates;  // those that only one of them listed
  std::set_symmetric_difference(reference.tie.begin(), reference.tie.end(), other.tie.begin(),
                                other.tie.end(), std::back_inserter(candidates));
  const auto cost = oracle.without(halfspaces[reference.removed.index()]).cost;
  found.reference_at_fault =
      !cost || !is_true_record(reference, *cost, candidates, halfspaces, oracle);
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

// The cost of a removal; an end has none.
RemovalCost cost_of(const Choice& choice, std::span<const Halfspace> halfspaces,
                    const RemovalOracle& oracle) {
  return choice.removed ? oracle.without(halfspaces[choice.removed->index()]) : RemovalCost{};
}

Divergence choices_at(std::size_t step, std::size_t halfspaces,
                      std::optional<HalfspaceId> reference, std::optional<HalfspaceId> other) {
  return {
      step, halfspaces - step, DivergenceKind::WrongRecord, {reference, {}}, {other, {}}, false, {},
      {}};
}

}  // namespace

Divergence judge_choices(const Run& run, const RationalPoint& center, std::size_t step,
                         std::optional<HalfspaceId> reference, std::optional<HalfspaceId> other) {
  const std::vector<Halfspace>& halfspaces = run.halfspaces;
  Divergence found = choices_at(step, halfspaces.size(), reference, other);
  const RemovalOracle oracle(left_after(run, step), center);
  const RemovalCost first = cost_of(found.reference, halfspaces, oracle);
  const RemovalCost second = cost_of(found.other, halfspaces, oracle);
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
    const RemovalOracle oracle(left_after(reference, step), center);
    judge_record(found, reference.steps[step], other.steps[step], reference.halfspaces, oracle);
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

}  // namespace convexact
