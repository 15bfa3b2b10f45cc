// SPDX-License-Identifier: MIT
// same_run.hpp - the filtered engine against the exact one, step by step, on one solid.
#pragma once
#include <doctest/doctest.h>

#include <limits>
#include <variant>

#include "convexact/dual.hpp"
#include "convexact/hull.hpp"
#include "fast/filtered_engine.hpp"
#include "simplify/exact_engine.hpp"

/// Strictly inside.
inline convexact::RationalPoint mean_of_vertices(const convexact::DualHull& solid) {
  convexact::RationalPoint sum = convexact::RationalPoint::Zero();
  for (const convexact::RationalPoint& v : solid.vertices) sum += v;
  return sum / convexact::Rational(solid.vertices.size());
}

/// Checks the removals, exact costs, ties and the end; rings depend on the triangulation of faces.
inline void check_same_steps(const convexact::Run& exact, const convexact::Run& filtered) {
  CHECK(exact.stop == filtered.stop);
  REQUIRE(exact.steps.size() == filtered.steps.size());
  for (std::size_t s = 0; s < exact.steps.size(); ++s) {
    CAPTURE(s);
    REQUIRE(exact.steps[s].removed == filtered.steps[s].removed);
    REQUIRE(compare(exact.steps[s].cost.value(), filtered.steps[s].cost.value()).order ==
            convexact::Order::Equal);
    REQUIRE(exact.steps[s].tie == filtered.steps[s].tie);
    REQUIRE(exact.steps[s].left == filtered.steps[s].left);
  }
}

/// Checks that a run without a record is the first `count` steps of an exact one, and its reason to
/// end.
inline void check_same_prefix(const convexact::Run& exact, std::size_t count,
                              const convexact::FastDual& dual, const convexact::FastResult& lean) {
  using namespace convexact;
  REQUIRE(lean.steps.size() == count);
  for (std::size_t s = 0; s < count; ++s) {
    CAPTURE(s);
    const Step& step = exact.steps[s];
    REQUIRE(dual.exact(lean.steps[s].removed) == exact.halfspaces[step.removed.index()]);
    REQUIRE(lean.steps[s].tied == step.tie.size());
    const Enclosure cost = step.cost->enclose(200);
    const long exponent = -dual.cost_exponent(step.cost->measure());
    REQUIRE(to_rational(lean.steps[s].cost_lower) <= scale_by_power_of_two(cost.high(), exponent));
    const double upper = lean.steps[s].cost_upper;
    REQUIRE((upper == std::numeric_limits<double>::infinity() ||
             to_rational(upper) >= scale_by_power_of_two(cost.low(), exponent)));
  }
}

/// Runs both engines to the end on a solid. @return  The exact run.
inline convexact::Run check_same_solid(const convexact::DualHull& solid,
                                       convexact::SimplifyOptions options = {}) {
  using namespace convexact;
  const RationalPoint center = mean_of_vertices(solid);
  const Run filtered = simplify_filtered(solid, center, options);
  options.verify = VerifyLevel::None;  // tested separately
  Run exact = simplify_exact(solid, center, options);
  check_same_steps(exact, filtered);
  return exact;
}

/// Runs both engines to the end, the filtered one from the exact dual hull and from the hull.
/// Points that span no volume are skipped. @return  Whether the engines were compared.
inline bool check_same_run(const std::vector<convexact::Point>& points,
                           const convexact::SimplifyOptions& options = {}) {
  using namespace convexact;
  const PointSet set(points);
  const HullOutcome outcome = convex_hull(set);
  const Hull* hull = std::get_if<Hull>(&outcome);
  if (hull == nullptr) return false;
  const Run exact = check_same_solid(dual_of(*hull, set), options);
  const FastDual dual = FastDual::of(*hull, set);
  const FastResult lean = simplify_filtered(dual, options);
  CHECK(lean.stop == exact.stop);
  check_same_prefix(exact, exact.steps.size(), dual, lean);
  return true;
}
