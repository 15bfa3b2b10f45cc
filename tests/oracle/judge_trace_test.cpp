// SPDX-License-Identifier: MIT
// Removal orders judged: on a cube with cut corners, where a cut of depth t costs t^3 / 6
// independently of the others, and on small shapes by the definition.
#include <doctest/doctest.h>

#include <algorithm>

#include "convexact/error.hpp"
#include "convexact/verify_order.hpp"
#include "definitional_greedy.hpp"
#include "fast/engines.hpp"
#include "lab/diff/diff.hpp"
#include "number/random.hpp"
#include "removal_orders.hpp"
#include "shapes/makers.hpp"
#include "simplify_points.hpp"
#include "sweep.hpp"

using namespace convexact;

namespace {

// Every number of a verdict, from volumes of intersections.
void check_against_definition(const TraceVerdict& verdict) {
  const definition::HalfspaceArrangement arrangement(verdict.halfspaces);
  definition::Subset left = arrangement.all();
  for (const JudgedStep& step : verdict.steps) {
    const definition::Cheapest expected = definition::cheapest_removals(arrangement, left);
    REQUIRE(step.minimum == expected.cost);
    REQUIRE(step.tie == expected.tie);
    const Rational before = arrangement.volume(left).value();
    left &= ~(definition::Subset{1} << step.removed.index());
    const std::optional<Rational> after = arrangement.volume(left);
    REQUIRE(step.cost.has_value() == after.has_value());
    REQUIRE(step.regret.has_value() == after.has_value());
    if (!after) continue;
    REQUIRE(*step.cost == *after - before);
    REQUIRE(step.regret->rational() * expected.cost->rational() ==
            step.cost->rational() - expected.cost->rational());
  }
}

std::vector<HalfspaceId> shuffled(std::size_t count, std::uint64_t seed) {
  std::vector<HalfspaceId> ids;
  for (std::size_t i = 0; i < count; ++i) ids.emplace_back(i);
  Random random(seed);
  shuffle(std::span(ids), random);
  return ids;
}

}  // namespace

TEST_CASE("relative regret: infinite against a minimum of 0, unless the cost is 0 too") {
  const Cost none = Rational(0), one = Rational(1), two = Rational(2), three = Rational(3);
  CHECK(relative_regret(three, two) == Rational(1, 2));
  CHECK(relative_regret(two, two) == Rational(0));
  CHECK(relative_regret(none, none) == Rational(0));
  CHECK_FALSE(relative_regret(one, none).has_value());
}

TEST_CASE("judge trace: the cheapest first is greedy, at the closed form's costs") {
  const std::vector<Rational> depths = {Rational(1, 2), Rational(1), Rational(3, 2)};
  const DualHull solid = cut_box(depths);
  const TraceVerdict verdict = judge(solid, cuts_in_order(solid, depths));
  CHECK(verdict.rating == TraceRating::Greedy);
  CHECK(verdict.holds());
  CHECK_FALSE(verdict.worst.has_value());
  REQUIRE(verdict.steps.size() == 3);
  for (std::size_t s = 0; s < 3; ++s) {
    CHECK(verdict.steps[s].cost == Rational(depths[s] * depths[s] * depths[s] / 6));
    CHECK(verdict.steps[s].minimum == verdict.steps[s].cost);
    CHECK(verdict.steps[s].tie == std::vector{verdict.steps[s].removed});
    CHECK(verdict.steps[s].regret == Rational(0));
  }
  CHECK(status(verdict, "trace-greedy") == Status::Holds);
  CHECK(status(verdict, "trace-cost") == Status::NotAsked);
}

TEST_CASE("judge trace: a tie broken otherwise is greedy, and noted") {
  const std::vector<Rational> depths = {Rational(1), Rational(1), Rational(3, 2)};
  const DualHull solid = cut_box(depths);
  RemovalOrder order = cuts_in_order(solid, depths);
  if (order.steps[0].step.removed < order.steps[1].step.removed) {
    std::swap(order.steps[0], order.steps[1]);
  }
  const TraceVerdict verdict = judge(solid, order);
  CHECK(verdict.rating == TraceRating::Greedy);
  CHECK(verdict.holds());
  CHECK(verdict.other_ties == 1);
  CHECK(verdict.steps[0].is_other_tie());
  CHECK(verdict.steps[0].tie.size() == 2);
  CHECK_FALSE(verdict.steps[1].is_other_tie());
}

TEST_CASE("judge trace: the limit on regret is exact and inclusive") {
  // 3/2 before 5/4: one removal too dear, by (3/2)^3 / (5/4)^3 - 1.
  const std::vector<Rational> depths = {Rational(1), Rational(3, 2), Rational(5, 4)};
  const DualHull solid = cut_box(depths);
  const RemovalOrder order = cuts_in_order(solid, depths);
  const Rational regret(27 * 8 - 125, 125);

  TraceVerdict verdict = judge(solid, order);
  CHECK(verdict.rating == TraceRating::NotGreedy);
  CHECK(verdict.at == 1);
  CHECK(verdict.worst == 1);
  CHECK(verdict.steps[1].regret == regret);
  CHECK(verdict.steps[2].regret == Rational(0));  // judged by what was left then
  CHECK(violated(verdict) == Codes{"trace-greedy"});
  CHECK(witness(verdict, "trace-greedy").step == 1);
  CHECK(witness(verdict, "trace-greedy").row == 2);

  verdict = judge(solid, order, regret);
  CHECK(verdict.rating == TraceRating::UpToRegret);
  CHECK(verdict.holds());
  CHECK_FALSE(verdict.at.has_value());
  CHECK(verdict.worst == 1);

  verdict = judge(solid, order, regret - Rational(1, 1000000000));
  CHECK(verdict.rating == TraceRating::NotGreedy);
  CHECK_THROWS_AS((void)judge(solid, order, Rational(-1)), Error);
}

TEST_CASE("judge trace: 'from' is the first step above the limit, 'worst' the largest regret") {
  const std::vector<Rational> depths = {Rational(5, 4), Rational(1), Rational(7, 4),
                                        Rational(3, 2)};
  const DualHull solid = cut_box(depths);
  // Regrets: (125 - 64)/64 = 0.953, 0, (343 - 216)/216 = 0.588, 0.
  const TraceVerdict verdict = judge(solid, cuts_in_order(solid, depths), Rational(3, 5));
  CHECK(verdict.rating == TraceRating::NotGreedy);
  CHECK(verdict.at == 0);
  CHECK(verdict.worst == 0);
  const std::vector<Rational> other = {Rational(7, 4), Rational(3, 2), Rational(5, 4), Rational(1)};
  // In descending order, the cheapest is 1 at first, so 343/64 - 1 is the worst.
  const DualHull descending = cut_box(other);
  const TraceVerdict far = judge(descending, cuts_in_order(descending, other), Rational(1));
  CHECK(far.at == 0);
  CHECK(far.worst == 0);
  CHECK(far.steps[0].regret == Rational(343 - 64, 64));
  CHECK(far.steps[1].regret == Rational(216 - 64, 64));
  CHECK(far.steps[2].regret == Rational(125 - 64, 64));
  const std::vector<Rational> late = {Rational(9, 8), Rational(1), Rational(7, 4), Rational(5, 4)};
  const DualHull rising = cut_box(late);
  const TraceVerdict second = judge(rising, cuts_in_order(rising, late));
  CHECK(second.at == 0);
  CHECK(second.worst == 2);
}

TEST_CASE("judge trace: an unbounded removal ends the judgement, whatever was cheapest") {
  const std::vector<Rational> depths = {Rational(1), Rational(3, 2)};
  const DualHull solid = cut_box(depths);
  RemovalOrder order = cuts_in_order(solid, depths);
  order.steps[0].step.removed = id_of(solid, cube_sides()[4]);  // z <= 4: no cut bounds that
  TraceVerdict verdict = judge(solid, order);
  CHECK(verdict.rating == TraceRating::Unbounded);
  CHECK(verdict.at == 0);
  REQUIRE(verdict.steps.size() == 1);
  CHECK_FALSE(verdict.steps[0].cost.has_value());
  CHECK_FALSE(verdict.steps[0].regret.has_value());
  CHECK(verdict.steps[0].minimum == Rational(1, 6));
  CHECK(violated(verdict) == Codes{"trace-bounded"});

  // Only sides are left, and one of them goes: nothing bounded was left to remove.
  RemovalOrder longer = cuts_in_order(solid, depths);
  longer.steps.push_back({3, "side", {id_of(solid, cube_sides()[0])}});
  verdict = judge(solid, longer, Rational(1000));
  CHECK(verdict.rating == TraceRating::Unbounded);
  CHECK(verdict.at == 2);
  CHECK_FALSE(verdict.steps[2].minimum.has_value());
  CHECK(verdict.steps[2].tie.empty());
}

TEST_CASE("judge trace: a prefix is greedy; an end that claims that nothing is bounded is judged") {
  const std::vector<Rational> depths = {Rational(1), Rational(3, 2)};
  const DualHull solid = cut_box(depths);
  RemovalOrder order = cuts_in_order(solid, depths);
  order.stop = StopReason::AllUnbounded;
  CHECK(judge(solid, order).holds());
  CHECK(status(judge(solid, order), "trace-stop") == Status::Holds);
  order.steps.pop_back();
  const TraceVerdict verdict = judge(solid, order);
  CHECK(verdict.rating == TraceRating::Greedy);
  CHECK(violated(verdict) == Codes{"trace-stop"});
  CHECK(witness(verdict, "trace-stop").step == 1);
  order.stop.reset();
  CHECK(judge(solid, order).holds());
  order.steps.clear();
  CHECK(judge(solid, order).steps.empty());
  CHECK(judge(solid, order).holds());
}

TEST_CASE("judge trace: what names no facet ends it, with the row and its own code") {
  const std::vector<Rational> depths = {Rational(1), Rational(3, 2)};
  const DualHull solid = cut_box(depths);
  const RemovalOrder good = cuts_in_order(solid, depths);

  RemovalOrder order = good;
  order.steps[1].step.removed = HalfspaceId(8);
  TraceVerdict verdict = judge(solid, order);
  CHECK(verdict.rating == TraceRating::Meaningless);
  CHECK(verdict.at == 1);
  CHECK(verdict.steps.size() == 1);
  CHECK(verdict.removals == 2);
  CHECK(violated(verdict) == Codes{"trace-id-out-of-range"});
  CHECK(witness(verdict, "trace-id-out-of-range").row == 2);
  order.steps[1].step.removed = kNoFacet;
  CHECK(violated(judge(solid, order)) == Codes{"trace-id-out-of-range"});

  order = good;
  order.steps[1].step.removed = order.steps[0].step.removed;
  CHECK(violated(judge(solid, order)) == Codes{"trace-removed-twice"});

  // A plane that is off by more than rounding explains, a normal of 0; then the same facet under
  // two ids.
  order = good;
  order.facets.push_back(corner_cut(1, Rational(3, 2) + Rational(1, Integer(1) << 40)));
  order.facets.emplace_back();
  order.facets.push_back(corner_cut(0, depths[0]));
  order.steps[1].step.removed = HalfspaceId(8);
  CHECK(violated(judge(solid, order)) == Codes{"trace-plane-unknown"});
  order.steps[1].step.removed = HalfspaceId(9);
  CHECK(violated(judge(solid, order)) == Codes{"trace-plane-unknown"});
  order.steps[1].step.removed = HalfspaceId(10);
  CHECK(violated(judge(solid, order)) == Codes{"trace-removed-twice"});

  // The first trouble decides, and the later one is still told.
  order = cuts_in_order(solid, depths);
  std::swap(order.steps[0], order.steps[1]);
  order.steps.push_back(order.steps[0]);
  verdict = judge(solid, order);
  CHECK(verdict.rating == TraceRating::NotGreedy);
  CHECK(verdict.at == 0);
  CHECK(violated(verdict) == Codes{"trace-removed-twice", "trace-greedy"});
}

TEST_CASE("judge trace: planes may come in any order and at any scale") {
  const std::vector<Rational> depths = {Rational(1), Rational(3, 2)};
  const DualHull solid = cut_box(depths);
  RemovalOrder order;
  for (std::size_t c = 0; c < 2; ++c) {
    const Halfspace cut = corner_cut(c, depths[c]);
    const RationalVector3 normal = cut.normal().cast<Rational>() * Rational(7, 3);
    order.facets.emplace_back(Halfspace(normal, Rational(cut.offset()) * Rational(7, 3)));
    order.steps.push_back({c + 1, "", {HalfspaceId(c)}});
  }
  CHECK(judge(solid, order).rating == TraceRating::Greedy);
  CHECK(judge(solid, order).steps.size() == 2);
}

TEST_CASE("judge trace: traces of our engines are greedy and every claim in them holds") {
  for (const std::vector<Point>& points :
       {shapes::cut_cube(5, 0.25), shapes::octahedron(), shapes::on_sphere(24, 3)}) {
    const DualHull solid = dual_of_doubles(points);
    const RationalPoint center = center_of(solid);
    for (const Run& trace : {simplify_exact(solid, center), simplify_filtered(solid, center)}) {
      const TraceVerdict verdict = judge(solid, order_of(trace));
      CHECK(verdict.rating == TraceRating::Greedy);
      CHECK(verdict.holds());
      CHECK(verdict.other_ties == 0);
      CHECK(verdict.steps.size() == trace.steps.size());
      for (const char* code : {"trace-cost", "trace-ties", "trace-left"}) {
        CHECK((trace.steps.empty() || status(verdict, code) == Status::Holds));
      }
    }
    // Doubles may break ties otherwise; these shapes have no costs closer than that.
    const Run run = run_engine(Engine::Float, solid, center, {}, false);
    CHECK(judge(solid, order_of(solid, removed_in(run)), Rational(1, 1000000000)).holds());
  }
}

TEST_CASE("judge trace: wrong claims are found where they stand, and nowhere else") {
  const std::vector<Rational> depths = {Rational(1), Rational(1), Rational(3, 2)};
  const DualHull solid = cut_box(depths);
  const RemovalOrder good = order_of(simplify_exact(solid, kCutBoxCenter));
  REQUIRE(judge(solid, good).holds());

  RemovalOrder order = good;
  order.steps[2].step.cost = Rational(27, 48) + Rational(1, Integer(1) << 200);
  TraceVerdict verdict = judge(solid, order);
  CHECK(verdict.rating == TraceRating::Greedy);
  CHECK(violated(verdict) == Codes{"trace-cost"});
  CHECK(witness(verdict, "trace-cost").step == 2);
  CHECK(witness(verdict, "trace-cost").expected == "9/16");

  order = good;
  order.steps[0].step.tie.pop_back();
  verdict = judge(solid, order);
  CHECK(violated(verdict) == Codes{"trace-ties"});
  CHECK(witness(verdict, "trace-ties").step == 0);
  order = good;
  order.steps[0].step.tie.push_back(order.steps[2].step.removed);
  CHECK(violated(judge(solid, order)) == Codes{"trace-ties"});
  order = good;
  order.steps[0].step.tie.push_back(order.steps[0].step.removed);  // twice
  CHECK(violated(judge(solid, order)) == Codes{"trace-ties"});
  order = good;
  order.steps[1].step.tie.emplace_back(99);
  CHECK(violated(judge(solid, order)) == Codes{"trace-ties"});
  order = good;
  std::reverse(order.steps[0].step.tie.begin(), order.steps[0].step.tie.end());
  CHECK(judge(solid, order).holds());  // a set

  order = good;
  order.steps[1].step.left = 8;
  verdict = judge(solid, order);
  CHECK(violated(verdict) == Codes{"trace-left"});
  CHECK(witness(verdict, "trace-left").expected == "7");

  // A claim of a cost for a removal that is unbounded: z <= 4, over which no cut leans.
  const DualHull low = cut_box({Rational(1), Rational(3, 2)});
  order = order_of(simplify_exact(low, kCutBoxCenter));
  order.steps[0].step.removed = id_of(low, cube_sides()[4]);
  CHECK(violated(judge(low, order)) == Codes{"trace-bounded", "trace-cost"});
}

TEST_CASE("judge trace: random orders, every number by the definition" * sweep) {
  for (const std::vector<Point>& points :
       {shapes::cut_cube(4, 0.25), shapes::on_sphere(9, 5), shapes::octahedron()}) {
    const DualHull solid = dual_of_doubles(points);
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
      CAPTURE(seed);
      const RemovalOrder order = order_of(solid, shuffled(solid.halfspaces.size(), seed));
      const TraceVerdict verdict = judge(solid, order);
      check_against_definition(verdict);
      REQUIRE_FALSE(verdict.steps.empty());
      CHECK_FALSE(verdict.steps.back().cost.has_value());  // a bounded solid is never all gone
      CHECK(status(verdict, "trace-bounded") == Status::Violated);
      const bool starts_greedy = verdict.steps[0].is_greedy();
      CHECK((verdict.at == 0) == !starts_greedy);
    }
  }
}

TEST_CASE("judge trace: a file that says nothing is a verdict, and the rest is not asked") {
  const DualHull solid = cut_box({Rational(1)});
  const TraceVerdict verdict = unreadable_trace(solid, "expected JSON", 3);
  CHECK(verdict.rating == TraceRating::Meaningless);
  CHECK_FALSE(verdict.at.has_value());
  CHECK(violated(verdict) == Codes{"trace-readable"});
  CHECK(witness(verdict, "trace-readable").row == 3);
  CHECK(status(verdict, "trace-greedy") == Status::NotAsked);
}
