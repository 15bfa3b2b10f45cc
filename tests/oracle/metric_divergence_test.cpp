// SPDX-License-Identifier: MIT
// Runs by area and by mean width that differ, on a cube with cut corners: a cut of depth t costs a
// multiple of t^2 of area and of t of mean width.
#include <doctest/doctest.h>

#include "convexact/error.hpp"
#include "cut_box.hpp"
#include "expect_error.hpp"
#include "fast/engines.hpp"
#include "lab/diff/diff.hpp"
#include "lab/diff/divergence.hpp"
#include "shapes/makers.hpp"
#include "simplify/exact_engine.hpp"

using namespace convexact;

namespace {

constexpr CostMeasure kComparedMeasures[] = {CostMeasure::Area, CostMeasure::MeanWidth};

// Removes the cuts of those corners, without a record.
Run run_of_cuts(const DualHull& solid, CostMeasure measure, const std::vector<Rational>& depths,
                const std::vector<std::size_t>& corners) {
  Run run;
  run.halfspaces = solid.halfspaces;
  run.measure = measure;
  run.stop = StopReason::AllUnbounded;
  for (const std::size_t c : corners) {
    run.steps.push_back({id_of(solid, corner_cut(c, depths[c]))});
  }
  return run;
}

}  // namespace

TEST_CASE("divergence: a dearer removal by area or mean width is wrong topology") {
  const std::vector<Rational> depths = {Rational(1), Rational(3, 2)};
  const DualHull solid = cut_box(depths);
  for (const CostMeasure measure : {CostMeasure::Area, CostMeasure::MeanWidth}) {
    const Rational regret = measure == CostMeasure::Area ? Rational(5, 4) : Rational(1, 2);
    CAPTURE(static_cast<int>(measure));
    const Run right = run_of_cuts(solid, measure, depths, {0, 1});
    const Run wrong = run_of_cuts(solid, measure, depths, {1, 0});
    CHECK_FALSE(find_divergence(kCutBoxCenter, right, right).has_value());
    CHECK(check_greedy(solid, kCutBoxCenter, right).empty());
    const auto found = find_divergence(kCutBoxCenter, right, wrong);
    REQUIRE(found.has_value());
    CHECK(found->kind == DivergenceKind::WrongTopology);
    CHECK(found->step == 0);
    CHECK_FALSE(found->reference_at_fault);
    CHECK_FALSE(found->is_undecided);
    REQUIRE((found->regret && found->rounding));
    CHECK(found->regret->bounds().contains(regret));
    CHECK(*found->rounding < Rational(1, 1000000));
    CHECK(found->reference.cost->measure() == measure);
    const auto judged = first_wrong_step(solid, kCutBoxCenter, wrong);
    REQUIRE(judged.has_value());
    CHECK(judged->step == 0);
    CHECK(judged->reference.removed == right.steps[0].removed);
  }
}

TEST_CASE("divergence: equal cuts tie, and nearly equal ones are below rounding") {
  for (const CostMeasure measure : kComparedMeasures) {
    CAPTURE(static_cast<int>(measure));
    for (const int power : {0, 60, 20}) {
      CAPTURE(power);
      const Rational more = power == 0 ? Rational(0) : scale_by_power_of_two(Rational(1), -power);
      const std::vector<Rational> depths = {Rational(1), 1 + more};
      const DualHull solid = cut_box(depths);
      const Run first = run_of_cuts(solid, measure, depths, {0, 1});
      const Run second = run_of_cuts(solid, measure, depths, {1, 0});
      const auto found = find_divergence(kCutBoxCenter, first, second);
      REQUIRE(found.has_value());
      CHECK(found->kind == (power == 0    ? DivergenceKind::Tie
                            : power == 60 ? DivergenceKind::BelowRounding
                                          : DivergenceKind::WrongTopology));
      if (power == 0) CHECK(found->regret == Rational(0));
      if (power != 0) CHECK_FALSE(found->reference_at_fault);
    }
  }
}

TEST_CASE("divergence: records by area and mean width are compared, and the wrong one is named") {
  const std::vector<Rational> depths = {Rational(1), Rational(1), Rational(3, 2)};
  const DualHull solid = cut_box(depths);
  for (const CostMeasure measure : kComparedMeasures) {
    CAPTURE(static_cast<int>(measure));
    const Run exact = simplify_exact(solid, kCutBoxCenter, {.cost = measure});
    REQUIRE(exact.steps.size() == 3);
    Run other = simplify_filtered(solid, kCutBoxCenter, {.cost = measure});
    CHECK_FALSE(find_divergence(kCutBoxCenter, exact, other).has_value());
    *other.steps[2].cost *= 1 + scale_by_power_of_two(Rational(1), -200);
    auto found = find_divergence(kCutBoxCenter, exact, other);
    REQUIRE(found.has_value());
    CHECK(found->kind == DivergenceKind::WrongRecord);
    CHECK(found->step == 2);
    CHECK_FALSE(found->reference_at_fault);
    other = exact;
    other.steps[0].tie.pop_back();
    found = find_divergence(kCutBoxCenter, other, exact);
    REQUIRE(found.has_value());
    CHECK(found->step == 0);
    CHECK(found->reference_at_fault);
    Run by_volume = exact;
    by_volume.measure = CostMeasure::Volume;
    CHECK(error_of([&] { return find_divergence(kCutBoxCenter, exact, by_volume); }).code() ==
          ErrorCode::InvalidArgument);
  }
}

TEST_CASE("diff: exact and filtered agree by area and by mean width") {
  for (const CostMeasure measure : kComparedMeasures) {
    CAPTURE(static_cast<int>(measure));
    for (const auto& points : {shapes::cut_cube(8, 0.3), shapes::in_ball(40, 2)}) {
      const DiffOutcome outcome = diff_engines(
          PointSet(points), {.engines = {Engine::Exact, Engine::Filtered}, .cost = measure});
      const auto* report = std::get_if<DiffReport>(&outcome);
      REQUIRE(report != nullptr);
      CHECK(report->cost == measure);
      CHECK(report->holds());
      REQUIRE(report->comparisons.size() == 1);
      const Comparison& comparison = report->comparisons[0];
      CHECK(comparison.divergences.empty());
      CHECK(comparison.with_records);
      CHECK(comparison.measure_ratio->contains(1));
    }
  }
}
