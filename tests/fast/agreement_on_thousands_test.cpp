// SPDX-License-Identifier: MIT
// The filtered engine against the exact one on thousands of small inputs, random and degenerate:
// the same removals, exact costs, ties and end, from points and from halfspaces, whatever the seed,
// and wherever the run is told to end.

#include "growth_limits.hpp"
#include "hard_inputs.hpp"
#include "number/random.hpp"
#include "same_run.hpp"

using namespace convexact;

namespace {

Rational volume_of(const DualHull& solid) {
  return volume(to_polytope(solid.halfspaces, solid.triangles));
}

// The filtered engine, told to end at a number of faces, must do a prefix of the exact run.
void check_at_faces(const Run& exact, const FastDual& dual, std::size_t count, std::uint64_t seed) {
  const FastResult result =
      simplify_filtered(dual, {.faces = exact.halfspaces.size() - count, .seed = seed});
  CHECK(result.stop == StopReason::Reached);
  check_same_prefix(exact, count, dual, result);
}

// The same with limits of growth that it just meets or just misses, and the exact engine with one
// of these.
void check_at_growth(const Run& exact, const DualHull& solid, const FastDual& dual,
                     std::size_t count) {
  SimplifyOptions options;
  const auto cases = limits_after(exact, volume_of(solid), count);
  for (const auto& [limit, steps] : cases) {
    options.max_growth = limit;
    const FastResult result = simplify_filtered(dual, options);
    CHECK(result.stop == (steps == exact.steps.size() ? exact.stop : StopReason::GrowthLimit));
    check_same_prefix(exact, steps, dual, result);
  }
  options.max_growth = cases.front().limit;
  CHECK(check_same_solid(solid, options).steps.size() == count);
}

struct Compared {
  std::size_t runs = 0, ties = 0;
};

// Every fourth input by another cost, too: the exact engine takes ten times as long for these.
void check_another_cost(const DualHull& solid, const FastDual& dual, std::uint64_t i) {
  if (i % 4 != 1) return;
  const CostMeasure measure = i % 8 == 1 ? CostMeasure::Area : CostMeasure::MeanWidth;
  CAPTURE(static_cast<int>(measure));
  const Run exact = check_same_solid(solid, {.cost = measure, .seed = i});
  const FastResult lean = simplify_filtered(dual, {.cost = measure, .seed = i + 1});
  CHECK(lean.stop == exact.stop);
  check_same_prefix(exact, exact.steps.size(), dual, lean);
  for (const Step& step : exact.steps) {
    CHECK(step.tie_evidence.proof != TieProof::Undecided);
  }
}

void compare(const std::vector<Point>& points, std::uint64_t i, Compared& total) {
  const PointSet set(points);
  const HullOutcome outcome = convex_hull(set, {.seed = i});
  const Hull* hull = std::get_if<Hull>(&outcome);
  if (hull == nullptr) return;
  const DualHull solid = dual_of(*hull, set);
  const Run exact = check_same_solid(solid, {.seed = i});
  const FastDual dual = FastDual::of(*hull, set);
  const FastResult lean = simplify_filtered(dual, {.seed = i + 1});
  CHECK(lean.stop == exact.stop);
  check_same_prefix(exact, exact.steps.size(), dual, lean);
  check_another_cost(solid, dual, i);
  Random random(i);
  const std::size_t count = uniform_below(random, exact.steps.size() + 1);
  check_at_faces(exact, dual, count, random());
  if (i % 8 == 0) check_at_growth(exact, solid, dual, count);  // dear: long rationals
  ++total.runs;
  for (const Step& step : exact.steps) total.ties += step.tie.size() > 1;
}

Compared compare(std::string_view kind) {
  Compared total;
  hard::for_each(kind, [&](std::uint32_t i, const std::vector<Point>& points) {
    CAPTURE(std::string(kind));
    CAPTURE(i);
    compare(points, i, total);
  });
  // Hardly any input may be flat, or nothing would be compared.
  CHECK(total.runs * 4 >= hard::named(kind).count / hard::stride() * 3);
  MESSAGE(std::string(kind) << ": " << total.runs << " runs, " << total.ties << " steps with ties");
  return total;
}

}  // namespace

TEST_CASE("agreement: lattices") { CHECK(compare("lattice").ties > 0); }
TEST_CASE("agreement: grids") {
  CHECK(compare("grid part").ties > 0);
  compare("nudged grid");
}
TEST_CASE("agreement: nudged lattices") { compare("nudged lattice"); }
TEST_CASE("agreement: over polygons") {
  CHECK(compare("over a polygon").ties > 0);
  compare("nudged over a polygon");
  compare("turned over a polygon");
}
TEST_CASE("agreement: boxes") {
  CHECK(compare("box").ties > 0);
  compare("nudged box");
}
TEST_CASE("agreement: barely nudged") { compare("barely nudged"); }
TEST_CASE("agreement: symmetric solids") {
  CHECK(compare("symmetric").ties > 0);
  CHECK(compare("integer sphere").ties > 0);
}
TEST_CASE("agreement: spheres and regular solids") {
  compare("sphere");
  compare("regular");
}
TEST_CASE("agreement: needles and slabs") {
  compare("needle");
  CHECK(compare("squeezed").ties > 0);
}
TEST_CASE("agreement: far away") { compare("far away"); }
TEST_CASE("agreement: scales") {
  CHECK(compare("scaled").ties > 0);
  compare("mixed exponents");
}
TEST_CASE("agreement: near planes") {
  compare("near a plane");
  CHECK(compare("repeated").ties > 0);
}
TEST_CASE("agreement: high valence") { compare("high valence"); }
