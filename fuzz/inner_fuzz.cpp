// SPDX-License-Identifier: MIT
// Property of inner runs: on small grids (repeats, coplanar points, exact ties) and on hard doubles
// the filtered engine removes the same vertices as the exact one, at the same costs, with the same
// ties and the same end; each cost is the least, by hulls computed from scratch; both pass the
// verification.
#include <algorithm>

#include "convexact/measure.hpp"
#include "fast/filtered_inner.hpp"
#include "fuzz_check.hpp"
#include "fuzz_target.hpp"
#include "hard_numbers.hpp"
#include "simplify/exact_inner.hpp"

using namespace convexact;

namespace {

Rational volume_without(const VertexHull& start, const std::vector<VertexId>& left, VertexId v) {
  std::vector<PointId> ids;
  for (const VertexId u : left) {
    if (u != v) ids.emplace_back(u.index());
  }
  const PointSet points = subset(start.points, ids);
  const HullOutcome outcome = convex_hull(points);
  const Hull* hull = std::get_if<Hull>(&outcome);
  return hull == nullptr ? Rational(0) : volume(*hull, points);
}

void check_least(const VertexHull& start, const InnerRun& run) {
  std::vector<VertexId> left = vertices_left({}, start.points.size());
  for (const InnerStep& step : run.steps) {
    const Rational most = volume_without(start, left, step.removed);
    for (const VertexId v : left) {
      const bool is_tied = std::binary_search(step.tie.begin(), step.tie.end(), v);
      const Rational rest = volume_without(start, left, v);
      FUZZ_CHECK(is_tied ? rest == most : rest < most);
    }
    std::erase(left, step.removed);
  }
}

std::vector<Point> inner_points_of(FuzzInput& in) {
  if (in.below(8) > 0) return in.grid_points(in.rarely() ? 24 : 8, 3);
  HardNumbers numbers(in);
  std::vector<Point> points;
  for (std::size_t count = 5 + in.below(4); points.size() < count;) {
    points.push_back(numbers.point());
  }
  return points;
}

void hold_inner(FuzzInput& in) {
  InnerOptions options;
  options.vertices = 4 + in.below(3);
  const std::size_t loss = in.below(8);
  if (loss > 0) options.max_loss = Rational(loss, 8);
  const PointSet points(inner_points_of(in));
  const HullOutcome outcome = convex_hull(points);
  const Hull* hull = std::get_if<Hull>(&outcome);
  if (hull == nullptr) return;

  const VertexHull start = vertex_hull(*hull, points);
  const InnerRun exact = simplify_inner_exact(start, options);
  InnerRun filtered = simplify_inner_filtered(start, options);
  add_costs(start, filtered);
  verify_inner_run(start, exact, VerifyLevel::Full);
  verify_inner_run(start, filtered, VerifyLevel::Full);
  FUZZ_CHECK(exact.stop == filtered.stop);
  FUZZ_CHECK(exact.steps.size() == filtered.steps.size());
  for (std::size_t s = 0; s < exact.steps.size(); ++s) {
    FUZZ_CHECK(exact.steps[s].removed == filtered.steps[s].removed);
    FUZZ_CHECK(exact.steps[s].cost == filtered.steps[s].cost);
    FUZZ_CHECK(exact.steps[s].tie == filtered.steps[s].tie);
  }
  if (start.points.size() <= 10) check_least(start, exact);
}

const FuzzTarget kInner("inner", hold_inner);

}  // namespace
