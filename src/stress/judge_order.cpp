// SPDX-License-Identifier: MIT
#include "stress/judge_order.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "convexact/measure.hpp"
#include "number/balanced_sum.hpp"
#include "oracle/removal_cost.hpp"

namespace convexact {
namespace {

std::vector<Halfspace> left_after(const std::vector<Halfspace>& halfspaces,
                                  std::span<const HalfspaceId> removed) {
  std::vector<char> is_gone(halfspaces.size(), false);
  for (const HalfspaceId id : removed) is_gone[id.index()] = true;
  std::vector<Halfspace> left;
  for (std::size_t i = 0; i < halfspaces.size(); ++i) {
    if (!is_gone[i]) left.push_back(halfspaces[i]);
  }
  return left;
}

bool has_record(const EngineAnswer& answer) { return answer.engine != Engine::Float; }

// All removals from what is left, by the definition: none if every one is unbounded.
struct Cheapest {
  std::optional<Rational> cost;
  std::vector<HalfspaceId> tie;
};

Cheapest cheapest_of(const JudgedSolid& solid, std::span<const HalfspaceId> removed) {
  const std::vector<Halfspace>& all = solid.dual.halfspaces;
  const std::vector<Halfspace> left = left_after(all, removed);
  const RemovalOracle oracle(left, solid.center);
  Cheapest found;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!std::binary_search(left.begin(), left.end(), all[i])) continue;
    const std::optional<Rational> cost = oracle.without(all[i]).cost;
    if (!cost || (found.cost && *found.cost < *cost)) continue;
    if (found.cost != cost) found.tie.clear();
    found.cost = cost;
    found.tie.emplace_back(i);
  }
  return found;
}

bool is_valid_order(const EngineAnswer& answer, std::size_t halfspaces) {
  std::vector<HalfspaceId> ids = answer.removed;
  std::sort(ids.begin(), ids.end());
  const bool is_unique = std::adjacent_find(ids.begin(), ids.end()) == ids.end();
  return is_unique && (ids.empty() || ids.back().index() < halfspaces) &&
         ids.size() + 4 <= halfspaces;
}

void check_range(const char* what, const Rational& value, const Range& range,
                 std::vector<std::string>& faults) {
  if (range.low <= value && value <= range.high) return;
  faults.push_back(fmt::format("the reported volume of the {} does not hold the true one", what));
}

}  // namespace

TraceVerdict follow(const JudgedSolid& solid, const EngineAnswer& answer,
                    const JudgeLimits& limits) {
  RemovalOrder order;
  for (const Halfspace& h : answer.halfspaces) order.facets.emplace_back(h);
  const bool is_large = answer.halfspaces.size() > limits.whole;
  const std::size_t all = answer.removed.size();
  const std::size_t count = is_large ? std::min(limits.steps, all) : all;
  for (std::size_t s = 0; s < count; ++s) {
    OrderedRemoval& removal = order.removals.emplace_back(OrderedRemoval{
        s, std::to_string(answer.removed[s].index()), answer.removed[s].index(), {}});
    if (!has_record(answer)) continue;
    removal.claim.cost = answer.costs[s];
    removal.claim.tie.emplace();
    for (const HalfspaceId id : answer.ties[s]) removal.claim.tie->push_back(id.index());
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
    faults.push_back(fmt::format("{} at step {}: {}, expected {}", claim.code,
                                 witness.step.value_or(0), witness.found, witness.expected));
  }
  if (verdict.other_ties != 0) {
    faults.push_back(
        fmt::format("{} steps break a tie against the canonical order", verdict.other_ties));
  }
  for (std::size_t s = 0; s < answer.ties.size(); ++s) {
    if (answer.ties[s].empty() || answer.ties[s].front() != answer.removed[s]) {
      faults.push_back(fmt::format("step {} does not remove the first of its tie", s));
      break;
    }
  }
  return faults;
}

std::vector<std::string> faults_by_definition(const JudgedSolid& solid, const EngineAnswer& answer,
                                              const JudgeLimits& limits) {
  const std::size_t size = solid.dual.halfspaces.size();
  if (!is_valid_order(answer, size)) return {"the removals are not different halfspaces"};
  const std::span<const HalfspaceId> removed = answer.removed;
  std::size_t step = size > limits.definition ? size - limits.definition : 0;
  for (; step < removed.size(); ++step) {
    const Cheapest cheapest = cheapest_of(solid, removed.first(step));
    if (cheapest.cost != answer.costs[step] || cheapest.tie != answer.ties[step] ||
        cheapest.tie.front() != removed[step]) {
      return {fmt::format("step {} is not what the definition says", step)};
    }
  }
  if (answer.end == StressEnd::AllUnbounded && size - removed.size() <= limits.definition &&
      cheapest_of(solid, removed).cost) {
    return {"it ends although a bounded removal is left, by the definition"};
  }
  return {};
}

std::vector<std::string> faults_of_volume(const JudgedSolid& solid, const EngineAnswer& answer,
                                          const JudgeLimits& limits) {
  if (!is_valid_order(answer, solid.dual.halfspaces.size())) {
    return {"the removals are not different halfspaces"};
  }
  std::vector<std::string> faults;
  if (left_after(solid.dual.halfspaces, answer.removed) != answer.left) {
    faults.push_back("what is left is not what the removals leave");
  }
  if (answer.left.size() > limits.whole) return faults;
  const auto after = intersect(answer.left, solid.center);
  if (!after) {
    faults.push_back("what is left is unbounded");
    return faults;
  }
  const Rational last = volume(*after);
  check_range("result", last, answer.output_volume, faults);
  if (answer.halfspaces.size() > limits.whole) return faults;
  const Rational first = volume(intersect(solid.dual.halfspaces, solid.center).value());
  check_range("input", first, answer.input_volume, faults);
  if (has_record(answer) && first + balanced_sum(answer.costs) != last) {
    faults.push_back("the costs do not add up to the growth of the volume");
  }
  return faults;
}

}  // namespace convexact
