// SPDX-License-Identifier: MIT
// inner_runs.hpp - inner runs of points, and a judge of them by the definition: at each step the
// hull is computed from scratch without each of the vertices that are left.
#pragma once
#include <doctest/doctest.h>

#include <optional>
#include <vector>

#include "convexact/hull.hpp"
#include "convexact/measure.hpp"
#include "convexact/run.hpp"
#include "fast/filtered_inner.hpp"
#include "simplify/exact_inner.hpp"

namespace inner_runs {

using namespace convexact;

/// None if the points span no volume.
inline std::optional<VertexHull> start_of(const PointSet& points, std::uint64_t seed = 1) {
  const HullOutcome outcome = convex_hull(points, HullOptions{.seed = seed});
  const Hull* hull = std::get_if<Hull>(&outcome);
  if (hull == nullptr) return {};
  return vertex_hull(*hull, points);
}

inline Rational volume_of(const PointSet& points) {
  const HullOutcome outcome = convex_hull(points);
  const Hull* hull = std::get_if<Hull>(&outcome);
  return hull == nullptr ? Rational(0) : volume(*hull, points);
}

inline Rational volume_without(const VertexHull& start, const std::vector<VertexId>& left,
                               std::optional<VertexId> without) {
  std::vector<PointId> ids;
  for (const VertexId v : left) {
    if (v != without) ids.emplace_back(v.index());
  }
  return volume_of(subset(start.points, ids));
}

/// Every removal must lose the least volume of all, with exactly the true ties.
inline void check_against_definition(const VertexHull& start, const InnerRun& run) {
  std::vector<VertexId> left = vertices_left({}, start.points.size());
  Rational before = volume_without(start, left, {});
  for (const Step& step : run.steps) {
    CAPTURE(step.left);
    std::vector<VertexId> tie;
    Rational least = before;
    for (const VertexId v : left) {
      const Rational cost = before - volume_without(start, left, v);
      if (cost < least) tie.clear();
      if (cost <= least) tie.push_back(v);
      if (cost < least) least = cost;
    }
    REQUIRE(step.cost.value().rational() == least);
    REQUIRE(step.tie == tie);
    REQUIRE(step.removed == tie.front());
    std::erase(left, step.removed);
    REQUIRE(step.left == left.size());
    before -= least;
  }
  CHECK(volume_without(start, left, {}) == before);
}

inline InnerRun exact_run(const VertexHull& start, const InnerOptions& options = {}) {
  InnerRun run = simplify_inner_exact(start, options);
  verify_inner_run(start, run, VerifyLevel::Full);
  return run;
}

inline InnerRun filtered_run(const VertexHull& start, const InnerOptions& options = {}) {
  InnerRun run = with_costs(start, simplify_inner_filtered(start, options));
  verify_inner_run(start, run, VerifyLevel::Local);
  return run;
}

/// Removals, exact costs, ties and the end; rings depend on how facets are cut.
inline void check_same_inner_steps(const InnerRun& a, const InnerRun& b) {
  CHECK(a.stop == b.stop);
  REQUIRE(a.steps.size() == b.steps.size());
  for (std::size_t s = 0; s < a.steps.size(); ++s) {
    CAPTURE(s);
    REQUIRE(a.steps[s].removed == b.steps[s].removed);
    REQUIRE(a.steps[s].cost.value() == b.steps[s].cost.value());
    REQUIRE(a.steps[s].tie == b.steps[s].tie);
    REQUIRE(a.steps[s].left == b.steps[s].left);
  }
}

/// Both engines on one set of points, down to four vertices. Points without volume are left out.
inline void check_same_inner_run(const PointSet& points) {
  const auto start = start_of(points);
  if (!start) return;
  const InnerRun exact = exact_run(*start), filtered = filtered_run(*start);
  check_same_inner_steps(exact, filtered);
  CHECK(exact.steps.size() + 4 == start->points.size());
}
inline void check_same_inner_run(const std::vector<Point>& points) {
  check_same_inner_run(PointSet(points));
}

}  // namespace inner_runs
