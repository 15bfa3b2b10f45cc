// SPDX-License-Identifier: MIT
// The filtered engine against the exact one on inputs that shrink: whatever makes them differ is
// printed as its smallest counterexample.
#include <array>
#include <string>

#include "convexact/linear_program.hpp"
#include "fast/engines.hpp"
#include "hard_halfspaces.hpp"
#include "perturb.hpp"
#include "property.hpp"
#include "same_run.hpp"
#include "simplify/exact_engine.hpp"

using namespace convexact;

namespace {

using Coordinates = std::vector<std::array<int, 3>>;

std::vector<Point> small_points(const Coordinates& raw, int range) {
  std::vector<Point> points;
  for (const auto& p : raw) points.emplace_back(p[0] % range, p[1] % range, p[2] % range);
  return points;
}

// What differs first; empty if nothing does.
std::string difference(const Run& exact, const Run& filtered) {
  const std::size_t common = std::min(exact.steps.size(), filtered.steps.size());
  for (std::size_t s = 0; s < common; ++s) {
    const Step &a = exact.steps[s], &b = filtered.steps[s];
    const std::string step = "step " + std::to_string(s) + ": ";
    if (a.removed != b.removed) {
      return step + std::to_string(b.removed.value) + " goes at " + b.cost->rational().str() +
             ", not " + std::to_string(a.removed.value) + " at " + a.cost->rational().str();
    }
    if (a.cost != b.cost)
      return step + "costs " + b.cost->rational().str() + ", not " + a.cost->rational().str();
    if (a.tie != b.tie) return step + "another tie";
  }
  return exact.stop == filtered.stop && exact.steps.size() == filtered.steps.size()
             ? ""
             : "the end, after " + std::to_string(common) + " steps";
}

std::string disagreement(const std::vector<Point>& points, SimplifyOptions options = {}) {
  const PointSet set(points);
  const HullOutcome outcome = convex_hull(set);
  const Hull* hull = std::get_if<Hull>(&outcome);
  if (hull == nullptr) return "";
  const DualHull solid = dual_of(*hull, set);
  const RationalPoint center = mean_of_vertices(solid);
  const Run filtered = simplify_filtered(solid, center, options);
  options.verify = VerifyLevel::None;
  return difference(simplify_exact(solid, center, options), filtered);
}

}  // namespace

TEST_CASE("agreement: any small integers") {
  check_property("the engines agree", [](const Coordinates& raw, std::uint8_t range) {
    RC_ASSERT(disagreement(small_points(raw, 2 + range % 8)) == "");
  });
}

TEST_CASE("agreement: any small integers, an ulp off") {
  check_property(
      "the engines agree", [](const Coordinates& raw, std::uint8_t range, std::uint32_t seed) {
        RC_ASSERT(disagreement(perturb::nudged(small_points(raw, 2 + range % 8), seed)) == "");
      });
}

TEST_CASE("agreement: any small integers and their opposites, stretched by powers of two") {
  check_property("the engines agree", [](const Coordinates& raw, std::array<int, 3> by) {
    const auto points = perturb::with_opposites(small_points(raw, 9));
    RC_ASSERT(disagreement(perturb::stretched(points, {by[0] % 300, by[1] % 300, by[2] % 300})) ==
              "");
  });
}

TEST_CASE("agreement: any growth limit") {
  check_property("the engines agree", [](const Coordinates& raw, std::uint8_t percent) {
    RC_ASSERT(disagreement(small_points(raw, 6), {.max_growth = Rational(percent, 100)}) == "");
  });
}

TEST_CASE("agreement: hundreds of sets of halfspaces") {
  const RationalPoint origin = RationalPoint::Zero();
  std::size_t runs = 0, ties = 0;
  for (std::uint32_t i = 0; i < 800; ++i) {
    CAPTURE(i);
    const hard::Halfspaces input(i);
    if (!std::holds_alternative<BoundedProof>(find_recession(input.all()))) continue;
    const DualHull solid = dual_of(input.all(), origin, i).dual;
    const Run exact = check_same_solid(solid, {.seed = i});
    const FastDual dual = FastDual::of(solid, origin);
    const FastResult lean = simplify_filtered(dual, {.seed = i + 1});
    CHECK(lean.stop == exact.stop);
    check_same_prefix(exact, exact.steps.size(), dual, lean);
    ++runs;
    for (const Step& step : exact.steps) ties += step.tie.size() > 1;
  }
  CHECK(runs > 700);
  CHECK(ties > 50);
  MESSAGE(runs << " runs, " << ties << " steps with ties");
}
