// SPDX-License-Identifier: MIT
// Property of simplify: on small grids (repeats, coplanar points, exact ties) the filtered engine
// removes the same halfspaces as the exact one, at the same costs, with the same ties and the same
// end, and every step of both passes its verification; the float engine keeps a subset that is
// bounded.
#include "convexact/dual.hpp"
#include "fast/filtered_engine.hpp"
#include "fast/float_engine.hpp"
#include "fuzz_check.hpp"
#include "fuzz_target.hpp"
#include "hard_numbers.hpp"
#include "simplify/exact_engine.hpp"

using namespace convexact;

namespace {

RationalPoint mean_of_vertices(const DualHull& solid) {
  RationalPoint sum = RationalPoint::Zero();
  for (const RationalPoint& v : solid.vertices) sum += v;
  return sum / Rational(solid.vertices.size());
}

// Rings and triangles may differ where planes share a point.
void check_same_steps(const Run& exact, const Run& filtered) {
  FUZZ_CHECK(exact.halfspaces == filtered.halfspaces);
  FUZZ_CHECK(exact.stop == filtered.stop);
  FUZZ_CHECK(exact.steps.size() == filtered.steps.size());
  for (std::size_t s = 0; s < exact.steps.size(); ++s) {
    FUZZ_CHECK(exact.steps[s].removed == filtered.steps[s].removed);
    FUZZ_CHECK(exact.steps[s].cost == filtered.steps[s].cost);
    FUZZ_CHECK(exact.steps[s].tie == filtered.steps[s].tie);
    FUZZ_CHECK(exact.steps[s].left == filtered.steps[s].left);
  }
}

// The run without a record: costs are enclosed, ties only counted.
void check_same_removals(const Run& exact, const FastDual& dual, const FastResult& lean) {
  FUZZ_CHECK(exact.stop == lean.stop);
  FUZZ_CHECK(exact.steps.size() == lean.steps.size());
  for (std::size_t s = 0; s < exact.steps.size(); ++s) {
    const Step& step = exact.steps[s];
    FUZZ_CHECK(dual.exact(lean.steps[s].removed) == exact.halfspaces[step.removed.index()]);
    FUZZ_CHECK(lean.steps[s].tied == step.tie.size());
    const Rational cost = scale_by_power_of_two(step.cost->rational(), -dual.volume_exponent());
    FUZZ_CHECK(to_rational(lean.steps[s].cost_lower) <= cost);
    const double upper = lean.steps[s].cost_upper;
    FUZZ_CHECK(std::isinf(upper) || cost <= to_rational(upper));
  }
}

// Every triangle of a closed surface of all survivors has a vertex of the solid.
void check_bounded(const FastDual& dual, const FastResult& result) {
  FUZZ_CHECK(result.survivors.size() + result.steps.size() == dual.size());
  FUZZ_CHECK(result.triangles.size() == 2 * result.survivors.size() - 4);
  std::vector<std::array<std::uint32_t, 2>> edges, reversed;
  for (const DualTriangle& t : result.triangles) {
    for (int c = 0; c < 3; ++c) {
      edges.push_back({t[c].value, t[(c + 1) % 3].value});
      reversed.push_back({t[(c + 1) % 3].value, t[c].value});
      FUZZ_CHECK(std::binary_search(result.survivors.begin(), result.survivors.end(), t[c]));
    }
    const auto normal = [&](int c) -> const IntegerVector3& { return dual.exact(t[c]).normal(); };
    FUZZ_CHECK(normal(0).dot(normal(1).cross(normal(2))) > 0);
  }
  std::sort(edges.begin(), edges.end());
  std::sort(reversed.begin(), reversed.end());
  FUZZ_CHECK(std::adjacent_find(edges.begin(), edges.end()) == edges.end());
  FUZZ_CHECK(edges == reversed);
}

std::vector<Point> points_of(FuzzInput& in) {
  if (in.below(8) > 0) return in.grid_points(in.rarely() ? 24 : 7, 3);
  HardNumbers numbers(in);
  std::vector<Point> points;
  for (std::size_t count = 4 + in.below(3); points.size() < count;) {
    points.push_back(numbers.point());
  }
  return points;
}

void hold_simplify(FuzzInput& in) {
  SimplifyOptions options;
  options.faces = 4 + in.below(5);
  options.verify = in.below(16) == 0 ? VerifyLevel::Full : VerifyLevel::Local;
  const std::size_t growth = in.below(8);
  if (growth > 0) options.max_growth = Rational(growth, 16);
  const PointSet points(points_of(in));
  const HullOutcome outcome = convex_hull(points);
  const Hull* hull = std::get_if<Hull>(&outcome);
  if (hull == nullptr) return;

  const DualHull solid = dual_of(*hull, points);
  const RationalPoint center = mean_of_vertices(solid);
  const Run exact = simplify_exact(solid, center, options);
  check_same_steps(exact, simplify_filtered(solid, center, options));
  const FastDual dual = FastDual::of(*hull, points);
  check_same_removals(exact, dual, simplify_filtered(dual, options));
  check_bounded(dual, simplify_float(dual, options));
}

const FuzzTarget kSimplify("simplify", hold_simplify);

}  // namespace
