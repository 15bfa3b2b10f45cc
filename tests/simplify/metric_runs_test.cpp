// SPDX-License-Identifier: MIT
// Runs by area and by mean width: against the definition, closed forms, and inputs in which a cost
// falls when another halfspace goes. Expected numbers are closed forms, or decimals with 11 digits
// of 50-digit arithmetic on the definition.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "convexact/measure.hpp"
#include "definitional_greedy.hpp"
#include "shapes/makers.hpp"
#include "simplify/dual_surface.hpp"
#include "simplify_points.hpp"

using namespace convexact;

namespace {

constexpr CostMeasure kMetrics[] = {CostMeasure::Area, CostMeasure::MeanWidth};

// Down to the end, with everything verified.
void check_metrics(const std::vector<Point>& points) {
  for (const CostMeasure measure : kMetrics) {
    CAPTURE(static_cast<int>(measure));
    const Run run = simplify_points(points, {.cost = measure, .verify = VerifyLevel::Full});
    definition::check_against_definition(run, measure);
    for (const Step& step : run.steps) {
      CHECK(step.tie_evidence.proof.has_value() == (step.tie.size() > 1));
      CHECK(step.tie_evidence.proof != TieProof::Undecided);
    }
  }
}

HalfspaceId id_of(const DualHull& dual, const Halfspace& plane) {
  for (std::size_t i = 0; i < dual.halfspaces.size(); ++i) {
    if (dual.halfspaces[i] == plane) return HalfspaceId(i);
  }
  FAIL("no such halfspace");
  return HalfspaceId(0);
}

Halfspace row(int x, int y, int z, int d) { return {IntegerVector3(x, y, z), Integer(d)}; }

double near(const Cost& cost) { return cost.enclose(64).low().convert_to<double>(); }

// The cost of one halfspace before and after another one has gone.
std::array<double, 2> costs_around(const std::vector<Halfspace>& halfspaces, const Halfspace& of,
                                   const Halfspace& gone, CostMeasure measure) {
  const DualHull dual = dual_of(halfspaces, RationalPoint::Zero()).dual;
  REQUIRE(dual.halfspaces.size() == halfspaces.size());
  DualSurface surface(dual.halfspaces, dual.triangles, RationalPoint::Zero(), 1, measure);
  const double before = near(surface.removal_of(id_of(dual, of)).cost.value());
  surface.apply(surface.removal_of(id_of(dual, gone)));
  return {before, near(surface.removal_of(id_of(dual, of)).cost.value())};
}

}  // namespace

TEST_CASE("metric runs: regular solids in doubles") {
  check_metrics(shapes::cube());
  check_metrics(shapes::octahedron());
  check_metrics(shapes::dodecahedron());
  check_metrics(shapes::icosahedron());
}

TEST_CASE("metric runs: cubes with cut corners tie exactly") {
  for (const std::uint32_t corners : {1u, 3u, 8u}) {
    for (const double depth : {0.3, 0.5}) check_metrics(shapes::cut_cube(corners, depth));
  }
}

TEST_CASE("metric runs: boxes, prisms, pyramids and bipyramids") {
  check_metrics(shapes::chamfered_box({1, 2, 3}, 0.1));
  for (const std::uint32_t k : {5u, 8u}) {
    check_metrics(shapes::prism(k));
    check_metrics(shapes::pyramid(k));
    check_metrics(shapes::bipyramid(k));
  }
}

TEST_CASE("metric runs: random lattice points, and symmetric ones") {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    CAPTURE(seed);
    check_metrics(shapes::lattice(8 + static_cast<std::uint32_t>(seed % 5), 1 + seed % 3, seed));
  }
  for (std::uint64_t seed = 1; seed <= 3; ++seed)
    check_metrics(shapes::centrally_symmetric(4, seed));
}

// docs/construction.md has these numbers. The corner is (3 - sqrt 3) / 8 in closed form; the others
// are from 50-digit arithmetic on the definition.
TEST_CASE("metric runs: the unit cube without a corner") {
  const std::vector<Halfspace> cut = {row(1, 0, 0, -1), row(0, 1, 0, -1), row(0, 0, 1, -1),
                                      row(-1, 0, 0, 0), row(0, -1, 0, 0), row(0, 0, -1, 0),
                                      row(2, 2, 2, -5)};
  const RationalPoint center(Rational(1, 2), Rational(1, 2), Rational(1, 2));
  const DualHull dual = dual_of(cut, center).dual;
  const auto cost = [&](const Halfspace& of, CostMeasure measure) {
    DualSurface surface(dual.halfspaces, dual.triangles, center, 1, measure);
    return surface.removal_of(id_of(dual, of)).cost.value().decimal(12);
  };
  CHECK(cost(row(2, 2, 2, -5), CostMeasure::Area) == "0.158493649054");
  CHECK(cost(row(2, 2, 2, -5), CostMeasure::MeanWidth) == "0.0262336615512");
  CHECK(cost(row(1, 0, 0, -1), CostMeasure::Area) == "2.89054445662");
  CHECK(cost(row(1, 0, 0, -1), CostMeasure::MeanWidth) == "0.483340442738");
}

// [Jacobson2026] takes costs from a queue; these show that old ones are no bounds.
TEST_CASE("metric runs: a cost may fall when another halfspace goes") {
  // z <= y, z <= -y, 4 z <= 4 + x, 4 z <= 4 - x, z >= -2, |2 y| <= 3, moved up by one.
  const std::vector<Halfspace> roof = {row(0, -1, 1, -1), row(0, 1, 1, -1),  row(-1, 0, 4, -8),
                                       row(1, 0, 4, -8),  row(0, 0, -1, -1), row(0, 2, 0, -3),
                                       row(0, -2, 0, -3)};
  const auto area = costs_around(roof, row(0, -1, 1, -1), row(0, 1, 1, -1), CostMeasure::Area);
  CHECK(area[0] == doctest::Approx(18.4815683485).epsilon(1e-11));
  CHECK(area[1] == doctest::Approx(15.4140711008).epsilon(1e-11));
  CHECK(area[1] - area[0] ==
        doctest::Approx(2 * std::sqrt(17.0) - 8 * std::sqrt(2.0)).epsilon(1e-11));
  const auto width =
      costs_around(roof, row(0, -1, 1, -1), row(0, 1, 1, -1), CostMeasure::MeanWidth);
  CHECK(width[0] == doctest::Approx(0.07133506074).epsilon(1e-9));
  CHECK(width[1] == doctest::Approx(0.04891123963).epsilon(1e-9));
  const auto volume = costs_around(roof, row(0, -1, 1, -1), row(0, 1, 1, -1), CostMeasure::Volume);
  CHECK(volume[0] == doctest::Approx(18 + 1.0 / 6));
  CHECK(volume[1] == doctest::Approx(20 + 5.0 / 6));
}

TEST_CASE("metric runs: bounds from before a removal would choose wrongly") {
  const Run area = simplify_points({{-2, 3, 0},
                                    {1, 3, -1},
                                    {-4, 1, 0},
                                    {1, 0, 0},
                                    {1, 4, -1},
                                    {-3, -1, 2},
                                    {-3, -2, 4},
                                    {-4, 3, -3}},
                                   {.cost = CostMeasure::Area});
  REQUIRE(area.steps.size() >= 5);
  CHECK(area.halfspaces[area.steps[4].removed.index()] == row(-3, -22, -17, 3));
  CHECK(near(*area.steps[4].cost) == doctest::Approx(2.5728647).epsilon(1e-7));
  const Run width = simplify_points(
      {{4, -2, -3}, {-1, -2, 2}, {-2, -4, -2}, {3, -4, 0}, {-4, 3, -2}, {0, 1, 1}, {1, -2, 0}},
      {.cost = CostMeasure::MeanWidth});
  REQUIRE(width.steps.size() >= 3);
  CHECK(width.halfspaces[width.steps[2].removed.index()] == row(-2, -9, 5, -30));
  CHECK(near(*width.steps[2].cost) == doctest::Approx(1.3291680).epsilon(1e-7));
}

// Cuts that are not congruent: legs 3, 1, 3 and 1, 1, 7 on a box, both (15 - sqrt 99) / 2.
TEST_CASE("metric runs: an accidental tie of areas") {
  const std::vector<Halfspace> box = {row(1, 0, 0, -20), row(-1, 0, 0, 0),  row(0, 1, 0, -20),
                                      row(0, -1, 0, 0),  row(0, 0, 1, -20), row(0, 0, -1, 0),
                                      row(1, 3, 1, -97), row(-7, -7, -1, 7)};
  const RationalPoint center(10, 10, 10);
  const DualHull dual = dual_of(box, center).dual;
  REQUIRE(dual.halfspaces.size() == 8);
  const Run run = simplify_exact(dual, center, {.cost = CostMeasure::Area});
  CHECK(run.steps[0].tie.size() == 2);
  CHECK(run.steps[0].tie_evidence.proof == TieProof::SquareClasses);
  RootSum expected(Rational(15, 2));
  expected.add(Rational(-1, 2), 99);
  CHECK(compare(*run.steps[0].cost, Cost(expected)).order == Order::Equal);
}

// Two cuts through a prism that cost 1 each; their angles are complements.
TEST_CASE("metric runs: an accidental tie of mean widths") {
  const std::vector<Halfspace> box = {row(1, 0, 0, -40),   row(-1, 0, 0, 0),  row(0, 1, 0, -40),
                                      row(0, -1, 0, 0),    row(0, 0, 1, -3),  row(0, 0, -1, 0),
                                      row(-12, -5, 0, 60), row(4, 3, 0, -256)};
  const RationalPoint center(20, 20, Rational(3, 2));
  const DualHull dual = dual_of(box, center).dual;
  REQUIRE(dual.halfspaces.size() == 8);
  const Run run = simplify_exact(dual, center, {.cost = CostMeasure::MeanWidth});
  CHECK(run.steps[0].tie.size() == 2);
  CHECK(run.steps[0].tie_evidence.proof == TieProof::NormalForm);
  CHECK(compare(*run.steps[0].cost, Cost(AngleSum::pi(4))).order == Order::Equal);
}

// All facets touch the unit sphere, so V = A / 3 for every solid of the run: same removals, and
// three times the costs. Normals are rational unit vectors from Pythagorean quadruples.
TEST_CASE("metric runs: around a sphere, area and volume agree") {
  const int quadruples[][4] = {
      {1, 2, 2, 3}, {2, 3, 6, 7}, {1, 4, 8, 9}, {4, 4, 7, 9}, {2, 6, 9, 11}};
  std::vector<Halfspace> tangent;
  std::uint32_t turn = 0;
  for (const auto& [x, y, z, r] : quadruples) {
    for (int signs = 0; signs < 8; ++signs, ++turn) {
      int n[3] = {signs & 1 ? -x : x, signs & 2 ? -y : y, signs & 4 ? -z : z};
      std::rotate(n, n + turn % 3, n + 3);
      tangent.push_back(row(n[0], n[1], n[2], -r));
    }
  }
  const RationalPoint center = RationalPoint::Zero();
  const DualHull dual = dual_of(tangent, center).dual;
  REQUIRE(dual.halfspaces.size() == tangent.size());
  const Run volume = simplify_exact(dual, center);
  const Run area = simplify_exact(dual, center, {.cost = CostMeasure::Area});
  REQUIRE(volume.steps.size() == area.steps.size());
  for (std::size_t s = 0; s < volume.steps.size(); ++s) {
    CHECK(volume.steps[s].removed == area.steps[s].removed);
    CHECK(volume.steps[s].tie == area.steps[s].tie);
    const Cost expected{RootSum(Rational(volume.steps[s].cost->rational() * 3))};
    CHECK(compare(*area.steps[s].cost, expected).order == Order::Equal);
  }
}

TEST_CASE("metric runs: growth is limited by the measure of the cost") {
  for (const CostMeasure measure : kMetrics) {
    CAPTURE(static_cast<int>(measure));
    const std::vector<Point> points = shapes::dodecahedron();
    const DualHull dual = dual_of_doubles(points);
    const Run all = simplify_points(points, {.cost = measure});
    const double first = near(exact_measure(to_polytope(dual.halfspaces, dual.triangles), measure));
    const double share = (near(*all.steps[0].cost) + near(*all.steps[1].cost)) / first;
    for (const double factor : {0.999, 1.001}) {
      const Run run =
          simplify_points(points, {.cost = measure, .max_growth = to_rational(share * factor)});
      CHECK(run.steps.size() == (factor < 1 ? 1 : 2));
      CHECK(run.stop == StopReason::GrowthLimit);
    }
  }
}
