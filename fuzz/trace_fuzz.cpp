// SPDX-License-Identifier: MIT
// Property of trace: for any removal order and any claims about a small solid, the
// judge's verdict is the one by definition: the halfspaces are intersected from scratch without
// each candidate, at each step, in the state that the order has reached. Without the facets that
// the verdict names as never removed, the order has the rating that the verdict states.
#include <cstring>

#include "cheapest_removals.hpp"
#include "convexact/hull.hpp"
#include "convexact/verify_order.hpp"
#include "fuzz_check.hpp"
#include "fuzz_target.hpp"

using namespace convexact;

namespace {

// The rating of the order so far by the definition.
struct Expected {
  explicit Expected(const std::vector<Halfspace>& halfspaces)
      : arrangement(halfspaces), left(arrangement.all()) {}

  definition::HalfspaceArrangement arrangement;
  definition::Subset left;
  TraceRating rating = TraceRating::Greedy;
  std::optional<std::size_t> at;
  std::vector<std::optional<Rational>> costs;
  std::vector<definition::Cheapest> cheapest;
  std::size_t other_ties = 0;
  std::map<std::string, Status> statuses = {
      {"trace-readable", Status::Holds},        {"trace-plane-unknown", Status::Holds},
      {"trace-id-out-of-range", Status::Holds}, {"trace-removed-twice", Status::Holds},
      {"trace-bounded", Status::Holds},         {"trace-greedy", Status::Holds},
      {"trace-cost", Status::NotAsked},         {"trace-ties", Status::NotAsked},
      {"trace-left", Status::NotAsked},         {"trace-kept", Status::NotAsked},
      {"trace-stop", Status::NotAsked},         {"trace-moves", Status::NotAsked}};

  void violate(const char* code) { statuses[code] = Status::Violated; }
  void ask(const char* code, bool holds) {
    if (!holds) violate(code);
    if (statuses[code] == Status::NotAsked) statuses[code] = Status::Holds;
  }
  void lower(TraceRating to) {
    if (at) return;
    rating = to;
    at = costs.size();
  }
  bool has(std::size_t i) const { return (left >> i & 1) != 0; }
};

// Makes the next lines of an order, with the result of the definition for each.
class OrderMaker {
 public:
  OrderMaker(const std::vector<Halfspace>& halfspaces, const Rational& limit, FuzzInput& in)
      : expected_(halfspaces), limit_(limit), in_(in), count_(halfspaces.size()) {
    order_.facets.assign(halfspaces.begin(), halfspaces.end());
    order_.facets.emplace_back();  // a row with normal 0
  }

  void make() {
    for (std::size_t steps = in_.below(6); steps > 0; --steps) {
      if (!step()) return;
    }
    if (in_.below(2) == 0) return;
    order_.stop = StopReason::AllUnbounded;
    const auto missed = definition::cheapest_removals(expected_.arrangement, expected_.left);
    expected_.ask("trace-stop", !missed.cost.has_value());
  }
  const RemovalOrder& order() const { return order_; }
  const Expected& expected() const { return expected_; }

 private:
  bool step();
  bool name_nothing(const char* code) {
    expected_.violate(code);
    expected_.lower(TraceRating::Meaningless);
    return false;
  }
  void rate(HalfspaceId removed, const definition::Cheapest& best,
            const std::optional<Rational>& cost);
  void add_claims(const definition::Cheapest& best, const std::optional<Rational>& cost,
                  OrderedStep& ordered);

  Expected expected_;
  const Rational limit_;
  FuzzInput& in_;
  std::size_t count_;
  RemovalOrder order_;
};

// Whether the order can be followed beyond the step.
bool OrderMaker::step() {
  const definition::Cheapest best =
      definition::cheapest_removals(expected_.arrangement, expected_.left);
  std::size_t facet = in_.below(count_ + 2);
  if (in_.below(2) == 0 && !best.tie.empty()) facet = best.tie[facet % best.tie.size()].index();
  order_.steps.push_back({order_.steps.size() + 1, "a facet", {HalfspaceId(facet)}});
  if (facet == count_) return name_nothing("trace-plane-unknown");
  if (facet > count_) return name_nothing("trace-id-out-of-range");
  if (!expected_.has(facet)) return name_nothing("trace-removed-twice");

  const Rational before = expected_.arrangement.volume(expected_.left).value();
  expected_.left &= ~(definition::Subset{1} << facet);
  const std::optional<Rational> after = expected_.arrangement.volume(expected_.left);
  const auto cost = after ? std::optional<Rational>(*after - before) : std::nullopt;
  rate(HalfspaceId(facet), best, cost);
  add_claims(best, cost, order_.steps.back());
  expected_.costs.push_back(cost);
  expected_.cheapest.push_back(best);
  return cost.has_value();
}

void OrderMaker::rate(HalfspaceId removed, const definition::Cheapest& best,
                      const std::optional<Rational>& cost) {
  if (!cost) {
    expected_.violate("trace-bounded");
    expected_.lower(TraceRating::Unbounded);
    return;
  }
  if (*cost == best.cost->rational()) {
    expected_.other_ties += removed != best.tie.front() ? 1 : 0;
    return;
  }
  const Rational& least = best.cost->rational();
  if (*cost - least <= limit_ * least) return;
  expected_.violate("trace-greedy");
  expected_.lower(TraceRating::NotGreedy);
}

// Of each kind of claim none, the right one or another one.
void OrderMaker::add_claims(const definition::Cheapest& best, const std::optional<Rational>& cost,
                            OrderedStep& ordered) {
  Step& claim = ordered.step;
  if (const std::size_t kind = in_.below(4); kind < 2) {
    claim.cost = kind == 0 && cost ? *cost : Rational(in_.below(8)) / 6;
    expected_.ask("trace-cost", claim.cost == cost);
  }
  if (const std::size_t kind = in_.below(4); kind < 2) {
    ordered.claims_tie = true;
    claim.tie.assign(best.tie.rbegin(), best.tie.rend());
    if (kind == 1) claim.tie.emplace_back(in_.below(count_ + 2));
    std::vector<HalfspaceId> sorted = claim.tie;
    std::sort(sorted.begin(), sorted.end());
    expected_.ask("trace-ties", sorted == best.tie);
  }
  if (const std::size_t kind = in_.below(4); kind < 2) {
    ordered.claims_left = true;
    const std::size_t left = count_ - expected_.costs.size() - 1;
    claim.left = kind == 0 ? left : in_.below(16);
    expected_.ask("trace-left", claim.left == left);
  }
}

void check_steps(const TraceVerdict& verdict, const Expected& expected) {
  FUZZ_CHECK(verdict.steps.size() == expected.costs.size());
  std::optional<std::size_t> worst;
  for (std::size_t s = 0; s < verdict.steps.size(); ++s) {
    const JudgedStep& step = verdict.steps[s];
    FUZZ_CHECK(step.cost == expected.costs[s]);
    FUZZ_CHECK(step.minimum == expected.cheapest[s].cost);
    FUZZ_CHECK(step.tie == expected.cheapest[s].tie);
    FUZZ_CHECK(step.regret.has_value() == step.cost.has_value());
    if (!step.regret) continue;
    const Rational &paid = step.cost->rational(), &least = step.minimum->rational();
    FUZZ_CHECK(step.regret->rational() * least == paid - least);
    const bool is_worse = worst && step.regret->is_above(*verdict.steps[*worst].regret);
    if (step.regret->is_positive() && (!worst || is_worse)) worst = s;
  }
  FUZZ_CHECK(verdict.worst == worst);
  FUZZ_CHECK(verdict.other_ties == expected.other_ties);
}

// Without the facets that are to blame, the order has the rating in the note.
void check_left_out(const DualHull& solid, const RationalPoint& center, const RemovalOrder& order,
                    JudgeOptions options, const TraceVerdict& verdict) {
  if (!verdict.never_removed) return;
  const LeftOut& left_out = *verdict.never_removed;
  FUZZ_CHECK(!left_out.facets.empty() && left_out.steps > 0 && !verdict.holds());
  for (const OrderedStep& removal : order.steps) {
    FUZZ_CHECK(
        !std::binary_search(left_out.facets.begin(), left_out.facets.end(), removal.step.removed));
  }
  options.left_out = left_out.facets;
  const TraceVerdict without = judge_trace(solid, center, order, options);
  FUZZ_CHECK(without.rating == left_out.rating && without.at == left_out.at);
  FUZZ_CHECK(without.worst == left_out.worst);
}

void hold_trace(FuzzInput& in) {
  const PointSet points(in.grid_points(in.rarely() ? 9 : 6, 2));
  const HullOutcome outcome = convex_hull(points);
  const Hull* hull = std::get_if<Hull>(&outcome);
  if (hull == nullptr) return;
  const DualHull solid = dual_of(*hull, points);
  RationalPoint center = RationalPoint::Zero();
  for (const RationalPoint& v : solid.vertices) center += v / Rational(solid.vertices.size());

  JudgeOptions options;
  options.max_regret = Rational(in.below(8)) / 4;
  OrderMaker maker(solid.halfspaces, options.max_regret, in);
  maker.make();
  const Expected& expected = maker.expected();
  const TraceVerdict verdict = judge_trace(solid, center, maker.order(), options);
  check_steps(verdict, expected);
  const TraceRating rating =
      !expected.at && verdict.worst ? TraceRating::UpToRegret : expected.rating;
  FUZZ_CHECK(verdict.rating == rating && verdict.at == expected.at);
  FUZZ_CHECK(verdict.claims.size() == expected.statuses.size());
  for (const TraceClaim& claim : verdict.claims) {
    FUZZ_CHECK(expected.statuses.at(name_of(claim.code)) == claim.status);
    FUZZ_CHECK(claim.witness.has_value() == (claim.status == Status::Violated));
  }
  check_left_out(solid, center, maker.order(), options, verdict);
}

const FuzzTarget kTrace("trace", hold_trace);

}  // namespace
