// SPDX-License-Identifier: MIT
// Whether a candidate contains the input, in two ways that share no predicate, and how far the
// input reaches out of it.
#include <fmt/format.h>

#include "convexact/error.hpp"
#include "convexact/number.hpp"
#include "convexact/point_set.hpp"
#include "convexact/polytope.hpp"
#include "convexact/stored.hpp"
#include "number/text.hpp"
#include "oracle/cone_location.hpp"
#include "oracle/excess.hpp"
#include "oracle/judge.hpp"
#include "oracle/support_program.hpp"
#include "scene/solid.hpp"

namespace convexact::oracle {
namespace {

using enum ClaimCode;
using StopFlag = const std::atomic<bool>*;

void require_no_stop(StopFlag stop) {
  if (stop != nullptr && *stop) throw Error(ErrorCode::Stopped, "interrupted");
}

// Whether a vertex of the input's hull lies beyond the candidate's triangle in its direction. Each
// walk to that triangle starts where the one for a neighbour has ended.
bool reaches_out_of_cones(const Input& input, const Hull& hull, const PointSet& mesh,
                          StopFlag stop) {
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
    require_no_stop(stop);
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
bool reaches_beyond_planes(const Input& input, std::span<const Halfspace> planes, StopFlag stop) {
  SupportProgram program(input.hull);
  for (const Halfspace& plane : planes) {
    require_no_stop(stop);
    if (program.maximum(plane.normal()) + Rational(plane.offset()) > 0) return true;
  }
  return false;
}

// @throws Error Internal if the second way comes to another result than the first.
void confirm(bool is_outside, const Input& input, const Candidate& candidate,
             const CandidateSet& set, StopFlag stop) {
  const auto* mesh = std::get_if<Mesh>(&candidate);
  const bool reaches_out = mesh != nullptr && set.hull
                               ? reaches_out_of_cones(input, *set.hull, mesh->points, stop)
                               : reaches_beyond_planes(input, set.planes, stop);
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

void judge_empty(const Input& input, Docket& docket) {
  docket.verdict.outside = Outside{input.points.size(), input.points.size(), {}};
  Witness witness;
  witness.input_point = 0;
  witness.point = input.points[PointId(0)];
  docket.violated(ContainsInput, "the candidate is empty, so every point is outside",
                  std::move(witness));
}

std::string name_of_plane(const Candidate& candidate, const CandidateSet& set, std::size_t plane) {
  if (const auto* list = std::get_if<HalfspaceList>(&candidate)) {
    return fmt::format("row {}", list->rows[plane]);
  }
  if (!set.hull) return "the plane that holds the candidate";
  std::string corners;
  for (const PointId p : set.hull->facets[plane].first(3)) {
    corners += (corners.empty() ? "" : ", ") + std::to_string(p.index());
  }
  return "the facet through its points " + corners;
}

// The plane that a point lies farthest beyond, and the point.
Witness witness_of(const Excess& worst, const Input& input, const Candidate& candidate,
                   const CandidateSet& set) {
  Witness witness;
  witness.input_point = worst.point.index();
  witness.point = input.points[worst.point];
  witness.plane = set.planes[worst.plane];
  if (const auto* list = std::get_if<HalfspaceList>(&candidate)) {
    witness.rows = {list->rows[worst.plane]};
  } else if (set.hull) {
    for (const PointId p : set.hull->facets[worst.plane]) witness.vertices.push_back(p.index());
  }
  return witness;
}

Excess excess_of(std::span<const PointId> outside, const PointSet& points,
                 const CandidateSet& set) {
  std::optional<Excess> excess = find_excess(set.planes, subset(points, outside));
  if (!excess) throw Error(ErrorCode::Internal, "a point is outside, but beyond no plane");
  excess->point = outside[excess->point.index()];
  return std::move(*excess);
}

// The candidate as a bounded solid, if it is one.
void find_solid(const Candidate& candidate, CandidateSet& set, const Docket& docket,
                StageLog& log) {
  if (set.polytope || set.is_examined) return;
  if (const auto* mesh = std::get_if<Mesh>(&candidate)) {
    if (set.hull) set.polytope = to_polytope(*set.hull, mesh->points);
    return;
  }
  StageLog within(StageWatch{.stop = log.watch().stop});
  auto outcome = log.run("candidate's vertices",
                         [&] { return make_polytope(set.planes, docket.request.seed, within); });
  if (auto* polytope = std::get_if<Polytope>(&outcome)) set.polytope = std::move(*polytope);
}

// The distance to a convex set is a convex function: of the input it is largest at a corner.
Farthest farthest_of(const std::vector<PointId>& outside, const Input& input,
                     const Polytope& polytope, StopFlag stop) {
  std::vector<PointId> corners;
  std::copy_if(input.extreme.begin(), input.extreme.end(), std::back_inserter(corners),
               [&](PointId p) { return std::binary_search(outside.begin(), outside.end(), p); });
  std::optional<Farthest> farthest = find_farthest(polytope, input.points, corners, stop);
  if (!farthest) throw Error(ErrorCode::Internal, "points are outside, but no corner is");
  confirm_nearest(farthest->nearest, input.points[farthest->point], polytope);
  return std::move(*farthest);
}

void judge_outside(const std::vector<PointId>& outside, const Input& input,
                   const Candidate& candidate, CandidateSet& set, Docket& docket, StageLog& log) {
  const std::string count =
      fmt::format("{} outside, of {} tested", counted(outside.size(), "point", "points"),
                  with_separators(input.points.size()));
  find_solid(candidate, set, docket, log);
  if (!set.polytope) {
    const Excess worst = excess_of(outside, input.points, set);
    docket.violated(
        ContainsInput,
        fmt::format("{}; point {} is beyond {}; the candidate is no bounded solid, so there is no "
                    "distance to it, and no tolerance applies",
                    count, worst.point.index(), name_of_plane(candidate, set, worst.plane)),
        witness_of(worst, input, candidate, set));
    return;
  }
  const Farthest farthest = log.run(
      "distance", [&] { return farthest_of(outside, input, *set.polytope, log.watch().stop); });
  docket.verdict.outside->relative_squared_distance =
      farthest.squared_distance / input.squared_diameter;
  const Excess beyond = excess_of({{farthest.point}}, input.points, set);
  Witness witness = witness_of(beyond, input, candidate, set);
  witness.nearest = farthest.nearest;
  docket.violated_by(
      farthest.squared_distance, ContainsInput,
      fmt::format("{}; point {} is worst, {} from the candidate, beyond {}", count,
                  farthest.point.index(), docket.distance_text(farthest.squared_distance),
                  name_of_plane(candidate, set, beyond.plane)),
      std::move(witness));
}

}  // namespace

void judge_containment(const Input& input, const Candidate& candidate, CandidateSet& set,
                       Docket& docket, StageLog& log) {
  if (!docket.asks(ContainsInput)) return;
  if (set.is_empty) return judge_empty(input, docket);
  const StopFlag stop = log.watch().stop;
  const std::vector<PointId> outside =
      log.run("containment", [&] { return find_outside(set.planes, input.points, stop); });
  log.run("containment, second way",
          [&] { confirm(!outside.empty(), input, candidate, set, stop); });
  docket.verdict.outside = Outside{outside.size(), input.points.size(), {}};
  if (!outside.empty()) return judge_outside(outside, input, candidate, set, docket, log);
  docket.holds(ContainsInput,
               counted(input.points.size(), "point", "points") + " tested, none outside");
}

}  // namespace convexact::oracle
