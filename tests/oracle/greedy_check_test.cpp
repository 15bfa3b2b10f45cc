// SPDX-License-Identifier: MIT
// Runs doctored by hand on a cube with cut corners, followed to their ends: a cut of depth t costs
// t^3 / 6, independently of the other cuts.
#include <doctest/doctest.h>

#include "cut_box.hpp"
#include "lab/diff/diff.hpp"
#include "lab/diff/divergence.hpp"
#include "shapes/makers.hpp"

using namespace convexact;

namespace {

Run float_run(const DualHull& solid, const std::vector<Rational>& depths,
              StopReason stop = StopReason::AllUnbounded) {
  Run run;
  run.halfspaces = solid.halfspaces;
  run.stop = stop;
  for (std::size_t c = 0; c < depths.size(); ++c) {
    run.steps.push_back({id_of(solid, corner_cut(c, depths[c]))});
  }
  return run;
}

}  // namespace

TEST_CASE("greedy check: a run that always takes the cheapest has no divergence") {
  const std::vector<Rational> depths = {Rational(1, 2), Rational(1), Rational(3, 2)};
  const DualHull solid = cut_box(depths);
  CHECK(check_greedy(solid, kCutBoxCenter, float_run(solid, depths)).empty());
  const Run prefix = float_run(solid, {Rational(1, 2)}, StopReason::Reached);
  CHECK(check_greedy(solid, kCutBoxCenter, prefix).empty());
}

TEST_CASE("greedy check: later choices are judged in the state of the run") {
  // In the order of removal. The first is a tie if the second comes first in canonical order; the
  // third and fourth are swapped, which is one mistake and not two.
  const std::vector<Rational> depths = {Rational(1), Rational(1), Rational(3, 2), Rational(5, 4)};
  const DualHull solid = cut_box(depths);
  Run run = float_run(solid, depths);
  if (run.steps[0].removed < run.steps[1].removed) std::swap(run.steps[0], run.steps[1]);
  const std::vector<Divergence> found = check_greedy(solid, kCutBoxCenter, run);
  REQUIRE(found.size() == 2);
  CHECK(found[0].step == 0);
  CHECK(found[0].left == 10);
  CHECK(found[0].kind == DivergenceKind::Tie);
  CHECK(found[0].reference.removed == run.steps[1].removed);
  CHECK(found[0].other.removed == run.steps[0].removed);
  CHECK(found[0].reference.cost == Rational(1, 6));
  CHECK(found[0].other.cost == Rational(1, 6));
  CHECK(found[0].regret == Rational(0));
  CHECK(is_explained(found[0], Engine::Filtered, Engine::Float));
  CHECK(found[1].step == 2);
  CHECK(found[1].left == 8);
  CHECK(found[1].kind == DivergenceKind::WrongTopology);
  CHECK(found[1].reference.removed == run.steps[3].removed);
  CHECK(found[1].regret == Rational(27 * 8 - 125, 125));  // (3/2)^3 / (5/4)^3 - 1
  CHECK_FALSE(found[1].reference_at_fault);
  CHECK_FALSE(is_explained(found[1], Engine::Filtered, Engine::Float));
  CHECK(&worst_of(found) == &found[1]);
}

TEST_CASE("greedy check: an unbounded removal ends it; so does an end that is too early") {
  const std::vector<Rational> depths = {Rational(1), Rational(3, 2)};
  const DualHull solid = cut_box(depths);
  Run unbounded = float_run(solid, depths);
  unbounded.steps[0].removed = id_of(solid, cube_sides()[4]);  // z <= 4: no cut bounds that
  std::vector<Divergence> found = check_greedy(solid, kCutBoxCenter, unbounded);
  REQUIRE(found.size() == 1);
  CHECK(found[0].kind == DivergenceKind::WrongBoundedness);
  CHECK(found[0].step == 0);
  CHECK_FALSE(found[0].reference_at_fault);

  // Nothing but sides is left, and one of them goes.
  Run longer = float_run(solid, depths);
  longer.steps.push_back({id_of(solid, cube_sides()[0])});
  found = check_greedy(solid, kCutBoxCenter, longer);
  REQUIRE(found.size() == 1);
  CHECK(found[0].kind == DivergenceKind::WrongBoundedness);
  CHECK(found[0].step == 2);
  CHECK_FALSE(found[0].reference.removed.has_value());

  const Run shorter = float_run(solid, {depths[0]});
  found = check_greedy(solid, kCutBoxCenter, shorter);
  REQUIRE(found.size() == 1);
  CHECK(found[0].kind == DivergenceKind::WrongBoundedness);
  CHECK(found[0].step == 1);
  CHECK_FALSE(found[0].other.removed.has_value());
  CHECK(found[0].reference.cost == Rational(27, 48));
}

TEST_CASE("worst divergence: by kind, then by regret, the first of equals") {
  Divergence tie{3, 9, DivergenceKind::Tie, {}, {}, false, Rational(0), {}};
  Divergence small = tie, large = tie, infinite = tie;
  small.kind = large.kind = infinite.kind = DivergenceKind::BelowRounding;
  small.regret = Rational(1, 1000);
  large.regret = Rational(1, 10);
  infinite.regret.reset();
  const auto worst = [](std::vector<Divergence> list) { return worst_of(list); };
  CHECK(worst({tie, small, large}).regret == Rational(1, 10));
  CHECK_FALSE(worst({infinite, large}).regret.has_value());
  CHECK_FALSE(worst({large, infinite}).regret.has_value());
  Divergence later = tie;
  later.step = 5;
  CHECK(worst({tie, later}).step == 3);
}

TEST_CASE("diff: float runs on solids beyond doubles are explained") {
  // Planes a few roundings apart; coordinates from 2^-300 to 2^300, so costs up to 10^24 volumes.
  std::vector<std::vector<Point>> inputs;
  for (const std::uint64_t seed : {25u, 38u, 45u}) {
    inputs.push_back(shapes::nearly_coplanar(16, seed));
  }
  for (const std::uint64_t seed : {1u, 2u, 4u}) {
    inputs.push_back(shapes::wide_exponents(16, 300, seed));
  }
  for (const std::vector<Point>& points : inputs) {
    DiffRequest request;
    request.engines = {Engine::Filtered, Engine::Float};
    const DiffOutcome outcome = diff_engines(PointSet(points), request);
    CHECK(std::get<DiffReport>(outcome).holds());
  }
}

TEST_CASE("diff: a float run is judged to its end on either side of a comparison") {
  // All costs of a dodecahedron rounded to doubles are alike, few are equal.
  const Shape shape = PointSet(shapes::rounded_dodecahedron());
  for (const bool float_first : {false, true}) {
    CAPTURE(float_first);
    DiffRequest request;
    request.engines = {Engine::Exact, Engine::Float};
    if (float_first) std::swap(request.engines[0], request.engines[1]);
    const DiffOutcome outcome = diff_engines(shape, request);
    const Comparison& comparison = std::get<DiffReport>(outcome).comparisons.at(0);
    CHECK(comparison.explained);
    CHECK_FALSE(comparison.with_records);
    CHECK(comparison.judged ==
          std::get<DiffReport>(outcome).runs[float_first ? 0 : 1].steps.size());
    for (const Divergence& found : comparison.divergences) {
      CHECK(found.reference_at_fault == float_first);
      CHECK(found.regret.has_value());
    }
  }
}
