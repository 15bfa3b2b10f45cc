// SPDX-License-Identifier: MIT
// Orders that never remove some cheap facet: on a cube with cut corners, where a cut of depth t
// costs t^3 / 6 independently of the others, and on small shapes by the definition.
#include <doctest/doctest.h>

#include <algorithm>

#include "cheapest_removals.hpp"
#include "convexact/error.hpp"
#include "number/random.hpp"
#include "removal_orders.hpp"
#include "shapes/makers.hpp"
#include "sweep.hpp"
#include "wire/trace_verdict.hpp"

using namespace convexact;

namespace {

using CutIds = std::vector<HalfspaceId>;

// Cuts of these depths; the order removes some of them, named by position in the list.
struct CutOrder {
  CutOrder(const std::vector<Rational>& depths, const std::vector<std::size_t>& removed)
      : solid(cut_box(depths)) {
    for (std::size_t c = 0; c < depths.size(); ++c) {
      cuts.push_back(id_of(solid, corner_cut(c, depths[c])));
    }
    std::vector<HalfspaceId> ids;
    for (const std::size_t c : removed) ids.push_back(cuts[c]);
    order = order_of(solid, ids);
  }
  TraceVerdict verdict(const std::vector<HalfspaceId>& left_out = {},
                       const Rational& limit = 0) const {
    JudgeOptions options;
    options.left_out = left_out;
    options.max_regret = limit;
    return judge_trace(solid, kCutBoxCenter, order, options);
  }

  DualHull solid;
  std::vector<HalfspaceId> cuts;
  RemovalOrder order;
};

using Costs = std::vector<std::optional<Rational>>;

// What each removal adds, by definition; none if it is unbounded or the halfspace is gone.
Costs costs_of(const definition::HalfspaceArrangement& arrangement, definition::Subset left) {
  const Rational before = arrangement.volume(left).value();
  Costs costs(arrangement.size());
  for (std::size_t i = 0; i < costs.size(); ++i) {
    const definition::Subset bit = definition::Subset{1} << i;
    if ((left & bit) == 0) continue;
    if (const auto after = arrangement.volume(left & ~bit)) costs[i] = *after - before;
  }
  return costs;
}

std::optional<std::size_t> cheapest_of(const Costs& costs) {
  std::optional<std::size_t> cheapest;
  for (std::size_t i = 0; i < costs.size(); ++i) {
    if (costs[i] && (!cheapest || *costs[i] < *costs[*cheapest])) cheapest = i;
  }
  return cheapest;
}

// At each step the cheapest facet goes that the order never removes, as long as it is cheaper than
// what is removed.
CutIds never_removed_by_definition(const std::vector<Halfspace>& halfspaces, const CutIds& ids) {
  const definition::HalfspaceArrangement arrangement(halfspaces);
  definition::Subset left = arrangement.all();
  CutIds found;
  for (const HalfspaceId id : ids) {
    for (;;) {
      const Costs costs = costs_of(arrangement, left);
      const auto cheapest = cheapest_of(costs);
      const auto& cost = costs[id.index()];
      const bool is_blamed = cheapest && (!cost || *costs[*cheapest] < *cost) &&
                             std::count(ids.begin(), ids.end(), HalfspaceId(*cheapest)) == 0;
      if (is_blamed) {
        found.emplace_back(*cheapest);
        left &= ~(definition::Subset{1} << *cheapest);
        continue;
      }
      if (!cost) return found;
      left &= ~(definition::Subset{1} << id.index());
      break;
    }
  }
  return found;
}

// Every number of a verdict on the solid without what is left out.
void check_left_out_by_definition(const TraceVerdict& verdict) {
  const definition::HalfspaceArrangement arrangement(verdict.halfspaces);
  definition::Subset left = arrangement.all();
  for (const HalfspaceId id : verdict.left_out) left &= ~(definition::Subset{1} << id.index());
  std::optional<std::size_t> first_wrong;
  for (std::size_t s = 0; s < verdict.steps.size(); ++s) {
    const JudgedStep& step = verdict.steps[s];
    const Costs costs = costs_of(arrangement, left);
    const auto cheapest = cheapest_of(costs);
    REQUIRE(step.cost == costs[step.removed.index()]);
    REQUIRE(step.minimum == (cheapest ? costs[*cheapest] : std::nullopt));
    if (!first_wrong && (!step.cost || *step.cost != *step.minimum)) first_wrong = s;
    left &= ~(definition::Subset{1} << step.removed.index());
  }
  CHECK(verdict.at == first_wrong);
}

}  // namespace

TEST_CASE("left out: one facet that is never removed is named once, not in every step (#13)") {
  const CutOrder cuts({Rational(1, 2), Rational(1), Rational(3, 2)}, {1, 2});
  const TraceVerdict verdict = cuts.verdict();
  CHECK(verdict.rating == TraceRating::NotGreedy);
  CHECK(verdict.at == 0);
  CHECK(violated(verdict) == Codes{"trace-greedy"});
  REQUIRE(verdict.never_removed.has_value());
  CHECK(verdict.never_removed->facets == CutIds{cuts.cuts[0]});
  CHECK(verdict.never_removed->steps == 2);
  CHECK(verdict.never_removed->unlisted == 0);
  CHECK(verdict.never_removed->rating == TraceRating::Greedy);
  CHECK_FALSE(verdict.never_removed->worst.has_value());
  const std::string id = std::to_string(cuts.cuts[0].index());
  CHECK(sentence(*verdict.never_removed, verdict) ==
        "facet " + id +
            " is the cheapest in every step and never removed: was it left out on "
            "purpose? Without it the order is greedy; --left-out " +
            id + " makes that the verdict.");

  const TraceVerdict without = cuts.verdict({cuts.cuts[0]});
  CHECK(without.holds());
  CHECK(without.rating == TraceRating::Greedy);
  CHECK(without.left_out == CutIds{cuts.cuts[0]});
  CHECK_FALSE(without.never_removed.has_value());
  CHECK(without.steps[0].minimum == Rational(1, 6));
  CHECK(without.steps[1].minimum == Rational(27, 48));
  CHECK(verdict_line(without) == "greedy without facet " + id);
}

TEST_CASE("left out: what is wrong apart from it stays wrong (#13)") {
  const CutOrder cuts({Rational(1, 2), Rational(1), Rational(3, 2)}, {2, 1});
  const TraceVerdict verdict = cuts.verdict();
  CHECK(verdict.worst == 0);
  CHECK(verdict.steps[0].regret == Rational(27 - 1));  // (3/2)^3 / (1/2)^3 - 1
  REQUIRE(verdict.never_removed.has_value());
  CHECK(verdict.never_removed->facets == CutIds{cuts.cuts[0]});
  CHECK(verdict.never_removed->rating == TraceRating::NotGreedy);
  CHECK(verdict.never_removed->at == 0);
  CHECK(verdict.never_removed->worst_regret == Rational(27 - 8, 8));
  const TraceVerdict without = cuts.verdict({cuts.cuts[0]});
  CHECK(violated(without) == Codes{"trace-greedy"});
  CHECK(without.steps[0].regret == Rational(27 - 8, 8));
}

TEST_CASE("left out: several facets, each named once (#13)") {
  const CutOrder cuts({Rational(1, 4), Rational(1, 2), Rational(1), Rational(3, 2)}, {2, 3});
  const TraceVerdict verdict = cuts.verdict();
  REQUIRE(verdict.never_removed.has_value());
  CutIds both = {cuts.cuts[0], cuts.cuts[1]};
  std::sort(both.begin(), both.end());
  CHECK(verdict.never_removed->facets == both);
  CHECK(verdict.never_removed->steps == 2);
  CHECK(verdict.never_removed->rating == TraceRating::Greedy);
  CHECK(cuts.verdict(both).holds());
  CHECK(violated(cuts.verdict({cuts.cuts[0]})) == Codes{"trace-greedy"});
}

TEST_CASE("left out: survivors that are dearer or level are not to blame (#13)") {
  CHECK_FALSE(CutOrder({Rational(1), Rational(3, 2)}, {0}).verdict().never_removed.has_value());
  CHECK_FALSE(CutOrder({Rational(1), Rational(1)}, {1}).verdict().never_removed.has_value());
  // 3/2 before 1, which goes later: wrong, and no facet is to blame.
  const TraceVerdict swapped = CutOrder({Rational(1), Rational(3, 2)}, {1, 0}).verdict();
  CHECK(violated(swapped) == Codes{"trace-greedy"});
  CHECK_FALSE(swapped.never_removed.has_value());
  // Level with one that goes later: setting it aside would change nothing.
  const TraceVerdict level = CutOrder({Rational(1), Rational(1), Rational(3, 2)}, {2, 0}).verdict();
  CHECK(violated(level) == Codes{"trace-greedy"});
  if (level.never_removed) CHECK(level.never_removed->rating == TraceRating::NotGreedy);
}

TEST_CASE("left out: only what is too dear by more than the limit asks for it (#13)") {
  const CutOrder cuts({Rational(1), Rational(5, 4)}, {1});
  const Rational regret(125 - 64, 64);
  CHECK_FALSE(cuts.verdict({}, regret).never_removed.has_value());
  CHECK(cuts.verdict({}, regret).holds());
  CHECK(cuts.verdict({}, regret - Rational(1, 1000)).never_removed.has_value());
}

TEST_CASE("left out: an unbounded removal stays one (#13)") {
  CutOrder cuts({Rational(1)}, {0});
  cuts.order.steps[0].step.removed = id_of(cuts.solid, cube_sides()[4]);
  const TraceVerdict verdict = cuts.verdict();
  CHECK(violated(verdict) == Codes{"trace-bounded"});
  REQUIRE(verdict.never_removed.has_value());
  CHECK(verdict.never_removed->rating == TraceRating::Unbounded);
  CHECK(violated(cuts.verdict({cuts.cuts[0]})) == Codes{"trace-bounded"});
}

TEST_CASE("left out: ties and the end are those among the others (#13)") {
  CutOrder cuts({Rational(1, 2), Rational(1), Rational(1)}, {1, 2});
  cuts.order.steps[0].step.tie = {cuts.cuts[1], cuts.cuts[2]};
  cuts.order.steps[0].claims_tie = true;
  CHECK(violated(cuts.verdict()) == Codes{"trace-greedy", "trace-ties"});
  CHECK(cuts.verdict({cuts.cuts[0]}).holds());
  cuts.order.stop = StopReason::AllUnbounded;
  cuts.order.steps[1].step.left = 6;  // the sides
  cuts.order.steps[1].claims_left = true;
  CHECK(violated(cuts.verdict()) ==
        Codes{"trace-greedy", "trace-ties", "trace-left", "trace-stop"});
  CHECK(cuts.verdict({cuts.cuts[0]}).holds());
}

TEST_CASE("left out: what is removed, is no facet or leaves no solid is wrong usage (#13)") {
  const CutOrder cuts({Rational(1, 2), Rational(1)}, {1});
  CHECK_THROWS_AS((void)cuts.verdict({cuts.cuts[1]}), Error);
  CHECK_THROWS_AS((void)cuts.verdict({HalfspaceId(8)}), Error);
  CHECK_THROWS_AS((void)cuts.verdict({id_of(cuts.solid, cube_sides()[4])}), Error);  // unbounded
  CHECK(cuts.verdict({cuts.cuts[0], cuts.cuts[0]}).left_out == CutIds{cuts.cuts[0]});
}

TEST_CASE("left out: facets and rating by the definition, on random orders (#13)" * sweep) {
  std::size_t named = 0;
  for (const std::vector<Point>& points :
       {shapes::cut_cube(4, 0.25), shapes::on_sphere(9, 5), shapes::octahedron()}) {
    const DualHull solid = dual_of_doubles(points);
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
      CAPTURE(seed);
      std::vector<HalfspaceId> ids;
      for (std::size_t i = 0; i < solid.halfspaces.size(); ++i) ids.emplace_back(i);
      Random random(seed);
      shuffle(std::span(ids), random);
      ids.resize(1 + seed % 5);
      CutIds expected = never_removed_by_definition(solid.halfspaces, ids);
      std::sort(expected.begin(), expected.end());
      const TraceVerdict verdict = judge(solid, order_of(solid, ids));
      REQUIRE(verdict.never_removed.has_value() == !expected.empty());
      if (!verdict.never_removed) continue;
      ++named;
      CHECK(verdict.never_removed->facets == expected);
      JudgeOptions options;
      options.left_out = expected;
      const TraceVerdict without =
          judge_trace(solid, center_of(solid), order_of(solid, ids), options);
      check_left_out_by_definition(without);
      CHECK(without.rating == verdict.never_removed->rating);
      CHECK(without.at == verdict.never_removed->at);
    }
  }
  CHECK(named > 10);
}

TEST_CASE("left out: with a limit too, --left-out gives the rating that the note names (#13)") {
  const DualHull solid = dual_of_doubles(shapes::on_sphere(12, 8));
  std::size_t named = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    CAPTURE(seed);
    std::vector<HalfspaceId> ids;
    for (std::size_t i = 0; i < solid.halfspaces.size(); ++i) ids.emplace_back(i);
    Random random(seed);
    shuffle(std::span(ids), random);
    ids.resize(6);
    JudgeOptions options;
    options.max_regret = Rational(1 + seed % 4, 2);
    const RemovalOrder order = order_of(solid, ids);
    const TraceVerdict verdict = judge_trace(solid, center_of(solid), order, options);
    if (!verdict.never_removed) continue;
    ++named;
    options.left_out = verdict.never_removed->facets;
    const TraceVerdict without = judge_trace(solid, center_of(solid), order, options);
    CHECK(without.rating == verdict.never_removed->rating);
    CHECK(without.at == verdict.never_removed->at);
    CHECK(without.worst == verdict.never_removed->worst);
  }
  CHECK(named > 3);
}
