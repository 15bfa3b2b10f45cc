// SPDX-License-Identifier: MIT
// Runs doctored by hand on a cube with cut corners: where they differ, and which is at fault. A cut
// of depth t costs t^3 / 6, which gives every regret in closed form.
#include "lab/diff/divergence.hpp"

#include <doctest/doctest.h>

#include "cut_box.hpp"
#include "lab/diff/diff.hpp"
#include "shapes/makers.hpp"

using namespace convexact;

namespace {

Run exact_run(const DualHull& solid) {
  return run_engine(Engine::Exact, solid, kCutBoxCenter, {}, true);
}

// A run without record.
// A run without costs and ties.
Run plain_run(const Run& like, const std::vector<HalfspaceId>& removed) {
  Run run;
  run.halfspaces = like.halfspaces;
  run.stop = like.stop;
  for (const HalfspaceId id : removed) run.steps.push_back({id});
  return run;
}
Run plain_run(const Run& like) { return plain_run(like, removed_in(like)); }

std::optional<Divergence> compare(const Run& a, const Run& b) {
  return find_divergence(kCutBoxCenter, a, b);
}

}  // namespace

TEST_CASE("divergence: the three engines agree on a cube with different cuts") {
  const DualHull solid = cut_box({Rational(1), Rational(1, 2), Rational(3, 2)});
  const Run exact = exact_run(solid);
  REQUIRE(exact.steps.size() == 3);
  CHECK(exact.stop == StopReason::AllUnbounded);
  for (const Engine engine : {Engine::Exact, Engine::Filtered, Engine::Float}) {
    CHECK_FALSE(compare(exact, run_engine(engine, solid, kCutBoxCenter, {}, true)));
  }
  CHECK(left_after(exact, 3).size() == 6);
}

TEST_CASE("divergence: two tied removals swapped are a tie, and the higher id is at fault") {
  const DualHull solid = cut_box({Rational(1), Rational(1), Rational(3, 2)});
  const Run exact = exact_run(solid);
  REQUIRE(exact.steps[0].tie.size() == 2);
  Run swapped = plain_run(exact);
  std::swap(swapped.steps[0], swapped.steps[1]);

  const auto found = compare(exact, swapped);
  REQUIRE(found);
  CHECK(found->kind == DivergenceKind::Tie);
  CHECK(found->step == 0);
  CHECK(found->left == 9);
  CHECK(found->regret == Rational(0));
  CHECK(found->reference.cost == Rational(1, 6));
  CHECK(found->other.cost == Rational(1, 6));
  CHECK_FALSE(found->reference_at_fault);
  CHECK(is_explained(*found, Engine::Exact, Engine::Float));
  CHECK_FALSE(is_explained(*found, Engine::Exact, Engine::Filtered));

  const auto mirrored = compare(swapped, exact);
  REQUIRE(mirrored);
  CHECK(mirrored->reference_at_fault);
  CHECK(is_explained(*mirrored, Engine::Float, Engine::Exact));
}

TEST_CASE("divergence: a costlier removal is wrong topology, with its regret") {
  const DualHull solid = cut_box({Rational(1, 2), Rational(1), Rational(3, 2)});
  const Run exact = exact_run(solid);
  Run doctored = plain_run(exact);
  std::swap(doctored.steps[1], doctored.steps[2]);
  const auto found = compare(exact, doctored);
  REQUIRE(found);
  CHECK(found->kind == DivergenceKind::WrongTopology);
  CHECK(found->step == 1);
  CHECK(found->left == 8);
  CHECK(found->reference.cost == Rational(1, 6));
  CHECK(found->other.cost == Rational(27, 48));
  CHECK(found->regret == Rational(19, 8));  // (3/2)^3 - 1
  CHECK_FALSE(is_explained(*found, Engine::Exact, Engine::Float));
}

TEST_CASE("divergence: whether a gap is below rounding depends on its size alone") {
  for (const long bits : {-30L, -60L}) {
    CAPTURE(bits);
    const Rational close = 1 + scale_by_power_of_two(Rational(1), bits);
    const DualHull solid = cut_box({Rational(1), close});
    const Run exact = exact_run(solid);
    REQUIRE(exact.steps[0].tie.size() == 1);
    Run doctored = plain_run(exact);
    std::swap(doctored.steps[0], doctored.steps[1]);
    const auto found = compare(exact, doctored);
    REQUIRE(found);
    CHECK(found->regret == Rational(close * close * close - 1));
    const bool is_tiny = bits == -60;
    CHECK(found->kind == (is_tiny ? DivergenceKind::BelowRounding : DivergenceKind::WrongTopology));
    CHECK(is_explained(*found, Engine::Exact, Engine::Float) == is_tiny);
    CHECK_FALSE(is_explained(*found, Engine::Exact, Engine::Filtered));
    REQUIRE(found->rounding);
    CHECK((found->regret->rational() <= *found->rounding) == is_tiny);
  }
}

TEST_CASE("divergence: an unbounded removal, or an early end, is wrong boundedness") {
  const DualHull solid = cut_box({Rational(1), Rational(3, 2)});
  const Run exact = exact_run(solid);
  const HalfspaceId side = id_of(solid, cube_sides()[4]);  // z <= 4: no cut bounds that

  Run unbounded = plain_run(exact);
  unbounded.steps[1].removed = side;
  auto found = compare(exact, unbounded);
  REQUIRE(found);
  CHECK(found->kind == DivergenceKind::WrongBoundedness);
  CHECK(found->step == 1);
  CHECK_FALSE(found->other.cost.has_value());
  CHECK_FALSE(found->regret.has_value());
  CHECK_FALSE(found->reference_at_fault);
  CHECK_FALSE(is_explained(*found, Engine::Exact, Engine::Float));

  // One goes on, unbounded, where the reference ends.
  Run longer = plain_run(exact);
  longer.steps.push_back({side});
  found = compare(exact, longer);
  REQUIRE(found);
  CHECK(found->kind == DivergenceKind::WrongBoundedness);
  CHECK_FALSE(found->reference.removed.has_value());
  CHECK_FALSE(found->reference_at_fault);

  // One ends where the reference goes on; and the reference itself may be the one that ends.
  const Run shorter = plain_run(exact, {exact.steps[0].removed});
  found = compare(exact, shorter);
  REQUIRE(found);
  CHECK(found->kind == DivergenceKind::WrongBoundedness);
  CHECK_FALSE(found->reference_at_fault);
  CHECK(found->reference.cost == Rational(27, 48));
  found = compare(shorter, exact);
  REQUIRE(found);
  CHECK(found->reference_at_fault);
}

TEST_CASE("divergence: to end is explained where rounded planes may not bound the cap") {
  // Without the roof, the walls meet far above: for a slope of s at a height of about 2 / s.
  for (const long bits : {-20L, -60L}) {
    CAPTURE(bits);
    const Rational slope = scale_by_power_of_two(Rational(1), bits);
    std::vector<Halfspace> planes = cube_sides();
    planes.erase(planes.begin());  // x <= 4, and below instead x + s z <= 4
    planes.insert(planes.begin(), Halfspace(RationalVector3(1, 0, slope), -4));
    const DualHull solid = dual_of(planes, kCutBoxCenter).dual;
    const Run exact = exact_run(solid);
    REQUIRE(exact.steps.size() == 1);
    const auto found = compare(exact, plain_run(exact, {}));
    REQUIRE(found);
    const bool is_tiny = bits == -60;
    CHECK(found->kind ==
          (is_tiny ? DivergenceKind::BelowRounding : DivergenceKind::WrongBoundedness));
    CHECK(is_explained(*found, Engine::Exact, Engine::Float) == is_tiny);
    CHECK_FALSE(is_explained(*found, Engine::Exact, Engine::Filtered));
  }
}

TEST_CASE("divergence: records are compared, and the definition says which one is wrong") {
  const DualHull solid = cut_box({Rational(1), Rational(1), Rational(3, 2)});
  const Run exact = exact_run(solid);
  Run missing_tie = exact, other_cost = exact, other_stop = exact;
  missing_tie.steps[0].tie.pop_back();
  other_cost.steps[2].cost = other_cost.steps[2].cost->rational() + 1;
  other_stop.stop = StopReason::Reached;

  for (const bool swap : {false, true}) {
    CAPTURE(swap);
    const auto judge = [&](const Run& doctored) {
      return swap ? compare(doctored, exact) : compare(exact, doctored);
    };
    auto found = judge(missing_tie);
    REQUIRE(found);
    CHECK(found->kind == DivergenceKind::WrongRecord);
    CHECK(found->step == 0);
    CHECK(found->reference_at_fault == swap);
    found = judge(other_cost);
    REQUIRE(found);
    CHECK(found->kind == DivergenceKind::WrongRecord);
    CHECK(found->step == 2);
    CHECK(found->reference_at_fault == swap);
    CHECK_FALSE(is_explained(*found, Engine::Exact, Engine::Filtered));
  }
  const auto found = compare(exact, other_stop);
  REQUIRE(found);
  CHECK(found->kind == DivergenceKind::WrongRecord);
  CHECK(found->step == 3);
}

TEST_CASE("diff: engines agree on random points; a request must make sense") {
  const Shape shape = PointSet(shapes::in_ball(60, 3));
  const DiffOutcome outcome = diff_engines(shape, {});
  const auto* report = std::get_if<DiffReport>(&outcome);
  REQUIRE(report != nullptr);
  CHECK(report->holds());
  REQUIRE(report->runs.size() == 3);
  REQUIRE(report->comparisons.size() == 2);
  CHECK(report->comparisons[0].divergences.empty());
  CHECK(report->comparisons[0].with_records);
  CHECK(report->comparisons[0].judged == report->runs[0].steps.size());
  CHECK_FALSE(report->comparisons[1].with_records);
  CHECK(report->comparisons[0].volume_ratio->contains(Rational(1)));

  DiffRequest request;
  request.faces = 3;
  CHECK_THROWS((void)diff_engines(shape, request));
  request = {};
  request.engines = {Engine::Exact};
  CHECK_THROWS((void)diff_engines(shape, request));
  request.engines = {Engine::Exact, Engine::Exact};
  CHECK_THROWS((void)diff_engines(shape, request));
}
