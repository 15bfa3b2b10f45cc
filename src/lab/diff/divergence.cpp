// SPDX-License-Identifier: MIT
#include "lab/diff/divergence.hpp"

#include <algorithm>

#include "convexact/error.hpp"
#include "fast/filtered_loop.hpp"
#include "number/precision.hpp"

namespace convexact {

// ---- Two runs

namespace {

// Whether both are missing, or nothing shows that they differ.
bool may_be_same(const std::optional<Cost>& a, const std::optional<Cost>& b,
                 const DivergenceOptions& options) {
  if (!a || !b) return a.has_value() == b.has_value();
  const Order order = compare(*a, *b, options.compare, options.watch).order;
  return order == Order::Equal || order == Order::Undecided;
}

// The first step at which the runs differ in anything, or where the shorter one ends.
std::size_t common_steps(const Run& a, const Run& b, const DivergenceOptions& options) {
  const bool with_records = have_records(a, b);
  const auto is_same = [&](const Step& x, const Step& y) {
    return x.removed == y.removed &&
           (!with_records || (x.tie == y.tie && may_be_same(x.cost, y.cost, options)));
  };
  const auto [end, other_end] =
      std::mismatch(a.steps.begin(), a.steps.end(), b.steps.begin(), b.steps.end(), is_same);
  return static_cast<std::size_t>(end - a.steps.begin());
}

std::optional<HalfspaceId> removal_at(const Run& run, std::size_t step) {
  if (step >= run.steps.size()) return std::nullopt;
  return run.steps[step].removed;
}

// The halfspaces that are left after some steps of a run, and the cost by the definition of each
// removal from them.
class CostsAt {
 public:
  CostsAt(const Run& run, const RationalPoint& center, std::size_t step, const Watch& watch)
      : halfspaces_(run.halfspaces), oracle_(left_after(run, step), center, run.measure, watch) {}

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
// it concerns the halfspaces that only one of them lists as tied.
void judge_record(Divergence& found, const Step& reference, const Step& other, const CostsAt& costs,
                  const DivergenceOptions& options) {
  found.kind = DivergenceKind::WrongRecord;
  found.reference.cost = reference.cost;
  found.other.cost = other.cost;
  std::vector<HalfspaceId> candidates;
  std::set_symmetric_difference(reference.tie.begin(), reference.tie.end(), other.tie.begin(),
                                other.tie.end(), std::back_inserter(candidates));
  const std::optional<Cost> cost = costs(reference.removed).cost;
  const std::vector<HalfspaceId>& listed = reference.tie;
  const bool is_true = cost && may_be_same(reference.cost, cost, options) &&
                       std::all_of(candidates.begin(), candidates.end(), [&](HalfspaceId id) {
                         const bool is_listed =
                             std::find(listed.begin(), listed.end(), id) != listed.end();
                         return is_listed == may_be_same(costs(id).cost, cost, options);
                       });
  found.reference_at_fault = !is_true;
}

// For a volume the number, for other measures a lower bound of 128 bits.
Rational number_of(const Cost& cost, const Watch& watch) {
  if (cost.measure() == CostMeasure::Volume) return cost.rational();
  return cost.enclose(kMeasureBits, watch).low();
}

// The same for a difference.
Rational gap_between(const Cost& lower, const Cost& higher, const Watch& watch) {
  return number_of(difference(higher, lower), watch);
}

// Two different bounded removals.
void judge_costs(Divergence& found, const RemovalCost& reference, const RemovalCost& other,
                 const DivergenceOptions& options) {
  const Cost &a = *reference.cost, &b = *other.cost;
  const Order order = compare(a, b, options.compare, options.watch).order;
  if (order == Order::Equal || order == Order::Undecided) {
    found.kind = DivergenceKind::Tie;
    found.reference_at_fault = *found.other.removed < *found.reference.removed;
    found.is_undecided = order == Order::Undecided;
    found.regret = relative_regret(a, b, options.compare, options.watch);
    return;
  }
  found.reference_at_fault = order == Order::Greater;
  const Cost &lower = found.reference_at_fault ? b : a, &higher = found.reference_at_fault ? a : b;
  std::optional<Rational> rounding;
  if (reference.rounding && other.rounding) rounding = *reference.rounding + *other.rounding;
  found.kind = !rounding || gap_between(lower, higher, options.watch) <= *rounding
                   ? DivergenceKind::BelowRounding
                   : DivergenceKind::WrongTopology;
  found.regret = relative_regret(higher, lower, options.compare, options.watch);
  if (!found.regret || !rounding) return;
  found.rounding = *rounding / number_of(lower, options.watch);
}

Divergence choices_at(std::size_t step, std::size_t halfspaces,
                      std::optional<HalfspaceId> reference, std::optional<HalfspaceId> other) {
  return {step, halfspaces - step, DivergenceKind::WrongRecord, {reference, {}}, {other, {}}};
}

}  // namespace

Divergence judge_choices(const Run& run, const RationalPoint& center, std::size_t step,
                         std::optional<HalfspaceId> reference, std::optional<HalfspaceId> other,
                         const DivergenceOptions& options) {
  Divergence found = choices_at(step, run.halfspaces.size(), reference, other);
  const CostsAt costs(run, center, step, options.watch);
  const RemovalCost first = costs(found.reference), second = costs(found.other);
  found.reference.cost = first.cost;
  found.other.cost = second.cost;
  if (first.cost && second.cost) {
    judge_costs(found, first, second, options);
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
                                          const Run& other, const DivergenceOptions& options) {
  if (reference.measure != other.measure) {
    throw Error(ErrorCode::InvalidArgument, "the runs are by different measures");
  }
  const std::size_t step = common_steps(reference, other, options);
  const auto first = removal_at(reference, step), second = removal_at(other, step);
  if (first != second) return judge_choices(reference, center, step, first, second, options);
  if (!first && reference.stop == other.stop) return std::nullopt;
  Divergence found = choices_at(step, reference.halfspaces.size(), first, second);
  if (first) {
    judge_record(found, reference.steps[step], other.steps[step],
                 {reference, center, step, options.watch}, options);
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
    return a.regret && (!b.regret || b.regret->is_above(*a.regret));
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

// Judges one step after another; `tell` receives each divergence and returns whether to go on.
template <class Tell>
void follow(const DualHull& dual, const RationalPoint& center, const Run& run,
            const DivergenceOptions& options, Tell&& tell) {
  const FastDual fast = FastDual::of(dual, center);
  const SimplifyOptions loop_options{
      .keep = run.kept, .cost = run.measure, .compare = options.compare, .watch = options.watch};
  FilteredLoop loop(fast, loop_options);
  loop.evaluate_all();
  for (std::size_t step = 0; step < run.steps.size(); ++step) {
    options.watch.ask();
    const HalfspaceId chosen = run.steps[step].removed;
    const std::optional<HalfspaceId> cheapest = loop.choose();
    if (cheapest != chosen) {
      const std::vector<HalfspaceId> tie = loop.tie();
      const bool is_tied = cheapest && std::find(tie.begin(), tie.end(), chosen) != tie.end();
      Divergence found = is_tied ? choices_at(step, dual.halfspaces.size(), cheapest, chosen)
                                 : judge_choices(run, center, step, cheapest, chosen, options);
      if (is_tied) {
        found.kind = DivergenceKind::Tie;
        found.reference.cost = found.other.cost = loop.cost(chosen);
        found.is_undecided = loop.tie_evidence().proof == TieProof::Undecided;
        found.regret = Rational(0);
        if (found.is_undecided) {
          found.reference.cost = loop.cost(*cheapest);
          found.regret = relative_regret(*found.other.cost, *found.reference.cost, options.compare,
                                         options.watch);
        }
      }
      if (!tell(std::move(found)) || !loop.is_bounded(chosen)) return;
    }
    loop.remove(chosen);
  }
  if (run.stop != loop_options.when_stuck()) return;
  if (const std::optional<HalfspaceId> missed = loop.choose()) {
    tell(judge_choices(run, center, run.steps.size(), missed, {}, options));
  }
}

}  // namespace

std::vector<Divergence> check_greedy(const DualHull& dual, const RationalPoint& center,
                                     const Run& run, const DivergenceOptions& options) {
  std::vector<Divergence> found;
  follow(dual, center, run, options, [&](Divergence divergence) {
    found.push_back(std::move(divergence));
    return true;
  });
  return found;
}

std::optional<Divergence> first_wrong_step(const DualHull& dual, const RationalPoint& center,
                                           const Run& run, const DivergenceOptions& options) {
  std::optional<Divergence> wrong;
  follow(dual, center, run, options, [&](Divergence divergence) {
    if (divergence.kind != DivergenceKind::Tie) wrong = std::move(divergence);
    return !wrong;
  });
  return wrong;
}

}  // namespace convexact
