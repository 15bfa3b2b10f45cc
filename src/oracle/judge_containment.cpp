// SPDX-License-Identifier: MIT
// Whether a candidate contains the input, decided in two ways that share no predicate, and how far
// the input reaches out of it.
#include <fmt/format.h>

#include <algorithm>

#include "convexact/error.hpp"
#include "convexact/number.hpp"
#include "convexact/point_set.hpp"
#include "convexact/polytope.hpp"
#include "convexact/stored.hpp"
#include "convexact/watch.hpp"
#include "number/text.hpp"
#include "oracle/excess.hpp"
#include "oracle/judge.hpp"
#include "oracle/second_way.hpp"
#include "scene/solid.hpp"

namespace convexact::oracle {
namespace {

using enum ClaimCode;

// Whether a vertex of the input's hull lies beyond the candidate's triangle in its direction. Each
// walk to that triangle starts where the one for a neighbour has ended.
bool reaches_out_of_cones(const Input& input, const Hull& hull, const PointSet& mesh,
                          const Watch& watch) {
  std::vector<std::vector<std::uint32_t>> neighbors(input.hull.vertices.size());
  for (const Edge& edge : edges(input.hull)) {
    neighbors[edge.tail].push_back(edge.head);
    neighbors[edge.head].push_back(edge.tail);
  }
  const ConeLocation cones(hull, mesh, PointSet(input.hull.vertices));
  struct Walk {
    std::uint32_t vertex, triangle;
  };
  std::vector<Walk> queue{{0, 0}};
  std::vector<bool> is_queued(neighbors.size(), false);
  is_queued[0] = true;
  for (std::size_t next = 0; next < queue.size(); ++next) {
    watch.ask();
    const std::uint32_t vertex = queue[next].vertex;
    const std::uint32_t triangle = cones.locate(vertex, queue[next].triangle);
    if (cones.is_outside(vertex, triangle)) return true;
    for (const std::uint32_t neighbor : neighbors[vertex]) {
      if (is_queued[neighbor]) continue;
      is_queued[neighbor] = true;
      queue.push_back({neighbor, triangle});
    }
  }
  return false;
}

// Whether the input's hull reaches beyond a plane, by a linear program for each.
bool reaches_beyond_planes(const Input& input, std::span<const Halfspace> planes,
                           const Watch& watch) {
  SupportProgram program(input.hull);
  for (const Halfspace& plane : planes) {
    watch.ask();
    if (program.maximum(plane.normal()) + Rational(plane.offset()) > 0) return true;
  }
  return false;
}

// @throws Error Internal if the second way gives another result than the first.
void confirm(bool is_outside, const Trial& trial) {
  const CandidateSet& set = trial.set;
  const bool reaches_out =
      set.hull ? reaches_out_of_cones(trial.input, *set.hull, trial.mesh()->points, trial.stop())
               : reaches_beyond_planes(trial.input, set.planes, trial.stop());
  if (reaches_out != is_outside) {
    throw Error(ErrorCode::Internal, "two ways to test containment disagree");
  }
}

// By the projection theorem: q belongs to the solid, and none of its vertices lies on x's side of
// the plane through q perpendicular to x - q.
// @throws Error Internal if q is not the nearest point.
void confirm_nearest(const RationalPoint& q, const RationalPoint& x, const Polytope& polytope) {
  const RationalVector3 away = x - q;
  const Rational at_q = away.dot(q);
  const bool is_inside = std::all_of(polytope.planes.begin(), polytope.planes.end(),
                                     [&](const Halfspace& plane) { return plane(q) <= 0; });
  const bool is_nearest = std::all_of(polytope.vertices.begin(), polytope.vertices.end(),
                                      [&](const RationalPoint& v) { return away.dot(v) <= at_q; });
  if (!is_inside || !is_nearest) {
    throw Error(ErrorCode::Internal, "a point of a solid is not the nearest one");
  }
}

// The plane that one of some points lies farthest beyond, with that point, and the plane in words.
struct Beyond {
  Witness witness;
  std::string plane_name;
};

Beyond farthest_beyond(std::span<const PointId> outside, const Trial& trial) {
  const Input& input = trial.input;
  const CandidateSet& set = trial.set;
  const std::optional<Excess> worst = find_excess(set.planes, subset(input.points, outside));
  if (!worst) throw Error(ErrorCode::Internal, "a point is outside, but beyond no plane");
  const PointId point = outside[worst->point.index()];
  Beyond found{{}, "the plane that holds the candidate"};
  found.witness.input_point = point.index();
  found.witness.point = input.points[point];
  found.witness.plane = set.planes[worst->plane];
  if (const HalfspaceList* list = trial.list()) {
    found.witness.rows = {list->rows[worst->plane]};
    found.plane_name = fmt::format("row {}", list->rows[worst->plane]);
  } else if (set.hull) {
    auto& corners = found.witness.vertices;
    for (const PointId p : set.hull->facets[worst->plane]) corners.push_back(p.index());
    found.plane_name =
        fmt::format("the facet through its points {}, {}, {}", corners[0], corners[1], corners[2]);
  }
  return found;
}

// The distance to a convex set is a convex function: over the input it is largest at a corner.
Farthest farthest_of(const std::vector<PointId>& outside, const Trial& trial) {
  const Input& input = trial.input;
  std::vector<PointId> corners;
  std::copy_if(input.extreme.begin(), input.extreme.end(), std::back_inserter(corners),
               [&](PointId p) { return std::binary_search(outside.begin(), outside.end(), p); });
  const Polytope& polytope = *trial.set.polytope;
  std::optional<Farthest> farthest = find_farthest(polytope, input.points, corners, trial.stop());
  if (!farthest) throw Error(ErrorCode::Internal, "points are outside, but no corner is");
  confirm_nearest(farthest->nearest, input.points[farthest->point], polytope);
  return std::move(*farthest);
}

void judge_outside(const std::vector<PointId>& outside, Trial& trial) {
  const std::string count =
      fmt::format("{} outside, of {} tested", counted(outside.size(), "point", "points"),
                  with_separators(trial.input.points.size()));
  CandidateSet& set = trial.set;  // earlier claims may not have needed its polytope
  if (set.hull && !set.polytope) set.polytope = to_polytope(*set.hull, trial.mesh()->points);
  if (trial.list() != nullptr && !set.is_examined) (void)find_vertices(trial);
  if (!set.polytope) {
    Beyond worst = farthest_beyond(outside, trial);
    trial.violated(
        ContainsInput,
        fmt::format("{}; point {} is beyond {}; the candidate is no bounded solid, so there is no "
                    "distance to it, and no tolerance applies",
                    count, *worst.witness.input_point, worst.plane_name),
        std::move(worst.witness));
    return;
  }
  const Farthest farthest = trial.log.run("distance", [&] { return farthest_of(outside, trial); });
  const Rational& squared = farthest.squared_distance;
  trial.verdict.outside->relative_squared_distance = squared / trial.input.squared_diameter;
  Beyond worst = farthest_beyond(std::span(&farthest.point, 1), trial);
  worst.witness.nearest = farthest.nearest;
  trial.violated_by(
      squared, ContainsInput,
      fmt::format("{}; point {} is worst, {} from the candidate, beyond {}", count,
                  farthest.point.index(), trial.distance_text(squared), worst.plane_name),
      std::move(worst.witness));
}

}  // namespace

void judge_containment(Trial& trial) {
  if (!trial.asks(ContainsInput)) return;
  const PointSet& points = trial.input.points;
  if (trial.set.is_empty) {
    trial.verdict.outside = Outside{points.size(), points.size(), {}};
    Witness witness;
    witness.input_point = 0;
    witness.point = points[PointId(0)];
    return trial.violated(ContainsInput, "the candidate is empty, so every point is outside",
                          std::move(witness));
  }
  const std::vector<PointId> outside = trial.log.run(
      "containment", [&] { return find_outside(trial.set.planes, points, trial.stop()); });
  trial.log.run("containment, second way", [&] { confirm(!outside.empty(), trial); });
  trial.verdict.outside = Outside{outside.size(), points.size(), {}};
  if (!outside.empty()) return judge_outside(outside, trial);
  trial.holds(ContainsInput, counted(points.size(), "point", "points") + " tested, none outside");
}

}  // namespace convexact::oracle
