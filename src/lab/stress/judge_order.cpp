// SPDX-License-Identifier: MIT
// Removals, costs and ties of one run, judged step by step and by the definition.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "convexact/measure.hpp"
#include "lab/stress/judge.hpp"
#include "number/arithmetic.hpp"
#include "oracle/order/removal_cost.hpp"
#include "oracle/order/trace_claims.hpp"
#include "simplify/run_names.hpp"
#include "wire/trace_json.hpp"

namespace convexact {
namespace {

// Solids with at most this many halfspaces left are judged by the definition alone.
constexpr std::size_t kDefinition = 12;
// Solids of more halfspaces are large. For these, costs, minima and ties are computed again for the
// first `kSteps` removals only, and no solid of that size is intersected from scratch.
constexpr std::size_t kLarge = 2500, kSteps = 200;
// Bits of the enclosures of areas and mean widths.
constexpr long kCheckedBits = 256;

bool has_record(const EngineAnswer& answer) { return answer.engine != Engine::Float; }

// The cheapest of all removals from the present solid, by the definition: none if every one is
// unbounded.
struct Cheapest {
  std::optional<Cost> cost;
  std::vector<HalfspaceId> tie;
};

Cheapest cheapest_of(const CenteredDual& solid, const Run& run, std::size_t steps) {
  const std::vector<Halfspace>& all = solid.dual.halfspaces;
  const std::vector<Halfspace> left = left_after(run, steps);
  const RemovalOracle oracle(left, solid.center, run.measure);
  Cheapest found;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!std::binary_search(left.begin(), left.end(), all[i])) continue;
    const std::optional<Cost> cost = oracle.without(all[i]).cost;
    if (!cost) continue;
    const Order order = found.cost ? compare(*cost, *found.cost).order : Order::Less;
    if (order == Order::Greater) continue;
    if (order == Order::Less) {
      found.cost = cost;
      found.tie.clear();
    }
    found.tie.emplace_back(i);
  }
  return found;
}

void check_reported(const char* what, const Cost& value, const ReportedVolume& reported,
                    std::vector<std::string>& faults) {
  if (holds(reported, value)) return;
  faults.push_back(fmt::format("the reported {} of the {} does not hold the true one",
                               name_of(value.measure()), what));
}

// For a volume this is the number itself.
Enclosure bounds_of(const Cost& cost) { return cost.enclose(kCheckedBits); }

// Whether the sum of the costs is the growth of the measure: exactly for volumes.
bool add_up(const std::vector<Step>& steps, const Cost& first, const Cost& last) {
  if (first.measure() == CostMeasure::Volume) {
    std::vector<Rational> costs;
    for (const Step& step : steps) costs.push_back(step.cost.value().rational());
    return first.rational() + balanced_sum(std::move(costs)) == last.rational();
  }
  Enclosure sum = bounds_of(first);
  for (const Step& step : steps) sum += bounds_of(step.cost.value());
  const Enclosure expected = bounds_of(last);
  return expected.low() <= sum.high() && sum.low() <= expected.high();
}

// Without steps.
RemovalOrder order_about(const Run& run) {
  RemovalOrder order;
  order.measure = run.measure;
  for (const Halfspace& h : run.halfspaces) order.facets.emplace_back(h);
  return order;
}

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Whether the run ends with the claim that no removal is bounded although one is.
bool ends_early(const TraceVerdict& verdict) {
  return std::any_of(verdict.claims.begin(), verdict.claims.end(), [](const TraceClaim& claim) {
    return claim.code == TraceCode::Stop && claim.status == Status::Violated;
  });
}

// Whether the step is within the engine's bounds for its steps.
bool is_as_claimed(const StressClaim& claim, double cost_error, double regret) {
  return cost_error <= claim.cost && regret <= claim.regret;
}

}  // namespace

bool holds(const ReportedVolume& reported, const Cost& value) {
  const auto is_in = [&](const Rational& low, const Rational& high) {
    return (!reported.low || *reported.low <= high) && (!reported.high || low <= *reported.high);
  };
  if (value.measure() == CostMeasure::Volume) return is_in(value.rational(), value.rational());
  const Enclosure bounds = bounds_of(value);
  return is_in(bounds.low(), bounds.high());
}

bool may_be_same(const std::optional<Cost>& a, const std::optional<Cost>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  const Order order = compare(*a, *b).order;
  return order == Order::Equal || order == Order::Undecided;
}

bool is_valid_order(const Run& run) {
  std::vector<HalfspaceId> ids = removed_in(run);
  std::sort(ids.begin(), ids.end());
  const bool is_unique = std::adjacent_find(ids.begin(), ids.end()) == ids.end();
  return is_unique && (ids.empty() || ids.back().index() < run.halfspaces.size()) &&
         ids.size() + 4 <= run.halfspaces.size();
}

TraceVerdict follow(const CenteredDual& solid, const EngineAnswer& answer) {
  RemovalOrder order = order_about(answer.run);
  const bool is_large = answer.run.halfspaces.size() > kLarge;
  const std::size_t all = answer.run.steps.size();
  const std::size_t count = is_large ? std::min(kSteps, all) : all;
  for (std::size_t s = 0; s < count; ++s) {
    const Step& step = answer.run.steps[s];
    OrderedStep& ordered = order.steps.emplace_back(
        OrderedStep{s, std::to_string(step.removed.index()), {step.removed}});
    if (!has_record(answer)) continue;
    ordered.step.cost = step.cost;
    ordered.step.tie = step.tie;
    ordered.claims_tie = true;
  }
  if (count == all && answer.end == StressEnd::AllUnbounded) {
    order.stop = StopReason::AllUnbounded;
  }
  JudgeOptions options;
  options.confirm = !is_large;
  return judge_trace(solid.dual, solid.center, order, options);
}

std::vector<std::string> faults_of_order(const EngineAnswer& answer, const TraceVerdict& verdict) {
  std::vector<std::string> faults;
  for (const TraceClaim& claim : verdict.claims) {
    if (claim.status != Status::Violated) continue;
    const TraceWitness& witness = *claim.witness;
    faults.push_back(fmt::format("{} at step {}: {}, expected {}", name_of(claim.code),
                                 witness.step.value_or(0), witness.found, witness.expected));
  }
  if (verdict.other_ties != 0) {
    faults.push_back(
        fmt::format("{} steps break a tie against the canonical order", verdict.other_ties));
  }
  for (std::size_t s = 0; s < answer.run.steps.size(); ++s) {
    const Step& step = answer.run.steps[s];
    if (step.tie.empty() || step.tie.front() != step.removed) {
      faults.push_back(fmt::format("step {} does not remove the first of its tie", s));
      break;
    }
  }
  return faults;
}

std::vector<std::string> faults_by_definition(const CenteredDual& solid,
                                              const EngineAnswer& answer) {
  const std::size_t size = solid.dual.halfspaces.size();
  if (!is_valid_order(answer.run)) return {"the removals are not different halfspaces"};
  const std::vector<Step>& steps = answer.run.steps;
  std::size_t s = size > kDefinition ? size - kDefinition : 0;
  for (; s < steps.size(); ++s) {
    const Cheapest cheapest = cheapest_of(solid, answer.run, s);
    if (!may_be_same(cheapest.cost, steps[s].cost) || cheapest.tie != steps[s].tie ||
        cheapest.tie.front() != steps[s].removed) {
      return {fmt::format("step {} is not what the definition says", s)};
    }
  }
  if (answer.end == StressEnd::AllUnbounded && size - steps.size() <= kDefinition &&
      cheapest_of(solid, answer.run, steps.size()).cost) {
    return {"it ends although a bounded removal is left, by the definition"};
  }
  return {};
}

std::vector<std::string> faults_of_volume(const CenteredDual& solid, const EngineAnswer& answer) {
  if (!is_valid_order(answer.run)) {
    return {"the removals are not different halfspaces"};
  }
  std::vector<std::string> faults;
  if (left_after(answer.run, answer.run.steps.size()) != answer.left) {
    faults.push_back("what is left is not what the removals leave");
  }
  if (answer.left.size() > kLarge) return faults;
  const auto after = intersect(answer.left, solid.center);
  if (!after) {
    faults.push_back("what is left is unbounded");
    return faults;
  }
  check_reported("result", volume(*after), answer.output_volume, faults);
  if (answer.run.halfspaces.size() > kLarge) return faults;
  const Polytope before = intersect(solid.dual.halfspaces, solid.center).value();
  check_reported("input", volume(before), answer.input_volume, faults);
  const CostMeasure measure = answer.run.measure;
  if (measure == CostMeasure::Volume && !has_record(answer)) return faults;
  const Cost first = exact_measure(before, measure), last = exact_measure(*after, measure);
  if (measure != CostMeasure::Volume) {
    if (!answer.measure) {
      faults.push_back(fmt::format("it reports no {}", name_of(measure)));
    } else {
      check_reported("input", first, (*answer.measure)[0], faults);
      check_reported("result", last, (*answer.measure)[1], faults);
    }
  }
  if (has_record(answer) && !add_up(answer.run.steps, first, last)) {
    faults.push_back(
        fmt::format("the costs do not add up to the growth of the {}", name_of(measure)));
  }
  return faults;
}

std::vector<std::string> faults_of_search(const CenteredDual& solid, const EngineAnswer& answer) {
  if (!is_valid_order(answer.run)) return {"the removals are not different halfspaces"};
  const std::vector<Halfspace>& all = solid.dual.halfspaces;
  const SearchAnswer& search = answer.search.value();
  RemovalOrder order = order_about(answer.run);
  order.moves = search.moves;
  std::vector<bool> is_there(all.size(), true);
  for (const HalfspaceId i : removed_in(answer.run)) is_there[i.index()] = false;
  // (1) Each move.
  const auto fault = find_move_fault(order, NamedFacets(solid.dual, order, JudgeOptions().unit),
                                     all, is_there, solid.center, {});
  if (fault && !fault->is_open) {
    return {fmt::format("move {}: {}, expected {}", fault->row, fault->found, fault->expected)};
  }
  // (2) The end.
  for (const Move& move : search.moves) {
    for (const HalfspaceId i : move.removed) is_there[i.index()] = false;
    for (const HalfspaceId i : move.inserted) is_there[i.index()] = true;
  }
  std::vector<Halfspace> left;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (is_there[i]) left.push_back(all[i]);
  }
  if (left != search.left) return {"the result of the search is not where its moves lead"};
  return {};
}

double error_of_cost(const ReportedVolume& reported, const Cost& cost) {
  if (!reported.low || !reported.high) return kInfinity;
  const bool is_volume = cost.measure() == CostMeasure::Volume;
  const Enclosure bounds = bounds_of(cost);
  const Rational least = is_volume ? cost.rational() : bounds.low(),
                 most = is_volume ? cost.rational() : bounds.high();
  const Rational error =
      std::max({abs(Rational(*reported.low - least)), abs(Rational(*reported.low - most)),
                abs(Rational(*reported.high - least)), abs(Rational(*reported.high - most))});
  if (error == 0) return 0;
  return least <= 0 ? kInfinity : to_double(Rational(error / least), Rounding::Up);
}

void judge_float(const EngineAnswer& answer, const TraceVerdict& verdict, StressRun& run) {
  std::size_t beyond_claim = 0;
  double cost_error = 0, regret = 0;
  for (std::size_t s = 0; s < verdict.steps.size(); ++s) {
    const JudgedStep& step = verdict.steps[s];
    if (!step.cost) {
      run.faults.push_back(fmt::format("step {} leaves an unbounded solid", s));
      return;
    }
    if (!run.first_difference && step.is_dearer()) run.first_difference = s;
    const double step_error = error_of_cost(answer.lean[s].cost, *step.cost);
    const double step_regret = step.regret ? step.regret->high_double() : kInfinity;
    cost_error = std::max(cost_error, step_error);
    regret = std::max(regret, step_regret);
    if (answer.claim) beyond_claim += !is_as_claimed(*answer.claim, step_error, step_regret);
  }
  run.other_ties = verdict.other_ties;
  run.undecided = verdict.undecided;
  run.cost_error = cost_error;
  run.regret = regret;
  if (!answer.claim) return;
  if (beyond_claim > answer.claim->doubtful) {
    run.faults.push_back(fmt::format("{} steps exceed its stated bounds; {} doubtful", beyond_claim,
                                     answer.claim->doubtful));
  }
  if (ends_early(verdict) && answer.claim->end_proven) {
    run.faults.push_back("it ends although a bounded removal is left, and vouches for the end");
  }
}

}  // namespace convexact
