// SPDX-License-Identifier: MIT
// The oracle decides twice, in ways that share no predicate. Here the two receive different data,
// so the second way must disagree.
#include <doctest/doctest.h>

#include "convexact/error.hpp"
#include "cut_box.hpp"
#include "expect_error.hpp"
#include "oracle/order/removal_cost.hpp"
#include "oracle/solid/judge.hpp"
#include "polytope_by_definition.hpp"
#include "shapes/makers.hpp"
#include "simplify_points.hpp"
#include "solid/stage_log.hpp"

using namespace convexact;

namespace {

// The steps of the exact engine from a cube with three corners cut off, as a judge lists them.
std::vector<JudgedStep> true_steps(const DualHull& solid) {
  std::vector<JudgedStep> steps;
  for (const Step& step : simplify_exact(solid, kCutBoxCenter).steps) {
    steps.push_back({steps.size(), step.removed, step.cost, step.cost, step.tie, Rational(0)});
  }
  return steps;
}

TraceVerdict verdict_of(const DualHull& solid, const std::vector<JudgedStep>& steps) {
  TraceVerdict verdict;
  verdict.halfspaces = solid.halfspaces;
  verdict.steps = steps;
  return verdict;
}

}  // namespace

TEST_CASE("confirm_costs: what a step says of its cost is computed again, by the definition") {
  const DualHull solid = cut_box({Rational(1), Rational(1, 3), Rational(3, 2)});
  const std::vector<JudgedStep> steps = true_steps(solid);
  REQUIRE(steps.size() == 3);
  for (std::size_t s = 0; s < steps.size(); ++s) {
    CAPTURE(s);
    CHECK_NOTHROW(confirm_step(verdict_of(solid, steps), kCutBoxCenter, s));
    const auto check_refused = [&](const std::vector<JudgedStep>& wrong) {
      CHECK_THROWS_AS(confirm_step(verdict_of(solid, wrong), kCutBoxCenter, s), Error);
    };
    const Rational tiny = scale_by_power_of_two(Rational(1), -300);
    std::vector<JudgedStep> wrong = steps;
    wrong[s].cost = wrong[s].cost->rational() + tiny;
    check_refused(wrong);
    wrong = steps;
    wrong[s].cost.reset();
    check_refused(wrong);
    wrong = steps;
    wrong[s].minimum = wrong[s].minimum->rational() - tiny;
    check_refused(wrong);
  }
  CHECK_NOTHROW(confirm_sum(verdict_of(solid, steps), kCutBoxCenter));
  for (std::size_t s = 0; s < steps.size(); ++s) {
    std::vector<JudgedStep> wrong = steps;
    wrong[s].cost = wrong[s].cost->rational() + scale_by_power_of_two(Rational(1), -300);
    CHECK_THROWS_AS(confirm_sum(verdict_of(solid, wrong), kCutBoxCenter), Error);
  }
}

// The points reach to 2, and a hull that is said to be theirs to 1 only.
TEST_CASE("judge_containment: the second way is asked, and must come to the same result") {
  const auto cube = [](double half) { return PointSet(shapes::box({half, half, half})); };
  const auto hull_of = [](const PointSet& points) {
    return to_polytope(std::get<Hull>(convex_hull(points)), points);
  };
  const auto judge = [&](double points, double hull, double half, bool is_mesh) {
    const PointSet input = cube(points);
    const HullOutcome outcome = convex_hull(input);
    const oracle::Input what{input, std::get<Hull>(outcome).vertices, hull_of(cube(hull)), 12};
    Mesh mesh;
    mesh.points = cube(half);
    HalfspaceList list;
    list.halfspaces = hull_of(mesh.points).planes;
    for (std::size_t i = 0; i < list.halfspaces.size(); ++i) list.rows.push_back(i);
    const Candidate candidate = is_mesh ? Candidate(mesh) : Candidate(list);
    const VerifyRequest request;
    StageLog log;
    oracle::Trial trial(what, candidate, request, log);
    trial.set.planes = list.halfspaces;
    if (is_mesh) trial.set.hull = std::get<Hull>(convex_hull(mesh.points));
    oracle::judge_containment(trial);
    return trial.verdict.outside->points;
  };
  for (const bool is_mesh : {false, true}) {
    CHECK(judge(1, 1, 1, is_mesh) == 0);
    CHECK(judge(2, 2, 1, is_mesh) == 8);
    CHECK_THROWS_AS((void)judge(2, 1, 1, is_mesh), Error);
    CHECK_THROWS_AS((void)judge(1, 2, 1, is_mesh), Error);
  }
}
