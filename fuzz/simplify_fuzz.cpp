// SPDX-License-Identifier: MIT
// Property: on small grids (repeats, coplanar points, exact ties) the filtered engine removes the
// same halfspaces as the exact one, at the same costs, with the same ties and the same end, and
// every step of both passes its verification.
#include "convexact/dual/dual_hull.hpp"
#include "convexact/fast/filtered_engine.hpp"
#include "convexact/simplify/exact_engine.hpp"
#include "fuzz_check.hpp"
#include "fuzz_input.hpp"

using namespace convexact;

namespace {

RationalPoint mean_of_vertices(const DualHull& solid) {
  RationalPoint sum = RationalPoint::Zero();
  for (const RationalPoint& v : solid.vertices) sum += v;
  return sum / Rational(solid.vertices.size());
}

// Rings and triangles may differ where planes share a point.
void check_same_steps(const Trace& exact, const Trace& filtered) {
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

// The run that is not written down: costs are enclosed, ties only counted.
void check_same_removals(const Trace& exact, const FastDual& dual, const FastResult& lean) {
  FUZZ_CHECK(exact.stop == lean.stop);
  FUZZ_CHECK(exact.steps.size() == lean.steps.size());
  for (std::size_t s = 0; s < exact.steps.size(); ++s) {
    const Step& step = exact.steps[s];
    FUZZ_CHECK(dual.exact(lean.steps[s].removed) == exact.halfspaces[step.removed.index()]);
    FUZZ_CHECK(lean.steps[s].tied == step.tie.size());
    const Rational cost = scale_by_power_of_two(step.cost, -dual.volume_exponent());
    FUZZ_CHECK(to_rational(lean.steps[s].cost_lower) <= cost);
    FUZZ_CHECK(cost <= to_rational(lean.steps[s].cost_upper));
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzInput in(data, size);
  SimplifyOptions options;
  options.faces = 4 + in.below(5);
  options.verify = VerifyLevel::Full;
  const std::size_t growth = in.below(8);
  if (growth > 0) options.max_growth = Rational(growth, 16);
  const PointSet points(in.grid_points(24, 3));
  const HullOutcome outcome = convex_hull(points);
  const Hull* hull = std::get_if<Hull>(&outcome);
  if (hull == nullptr) return 0;

  const DualHull solid = dual_of(*hull, points);
  const RationalPoint center = mean_of_vertices(solid);
  const Trace exact = simplify_exact(solid, center, options).trace;
  check_same_steps(exact, simplify_filtered(solid, center, options).trace);
  const FastDual dual = FastDual::of(*hull, points);
  check_same_removals(exact, dual, simplify_filtered(dual, options));
  return 0;
}
