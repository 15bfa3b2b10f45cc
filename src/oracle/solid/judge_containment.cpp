// SPDX-License-Identifier: MIT
// Whether a candidate contains the input, in two ways that share no predicate, and how far the
// input reaches out of it; of an inner solid, whether the input's hull contains the candidate; of a
// hull, both.
#include <fmt/format.h>

#include <algorithm>

#include "convexact/error.hpp"
#include "convexact/geometry.hpp"
#include "convexact/number.hpp"
#include "convexact/stored.hpp"
#include "number/arithmetic.hpp"
#include "number/text.hpp"
#include "oracle/solid/excess.hpp"
#include "oracle/solid/judge.hpp"
#include "oracle/solid/second_way.hpp"
#include "solid/solid.hpp"

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
  found.witness.input_point = input.number_of(point);
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

// Finds the candidate's polytope, which earlier claims may not have needed.
void find_polytope(Trial& trial) {
  CandidateSet& set = trial.set;
  if (set.hull && !set.polytope) set.polytope = to_polytope(*set.hull, trial.mesh()->points);
  if (trial.list() != nullptr && !set.is_examined && !set.is_empty) (void)find_vertices(trial);
}

// How many of these points of the input no face of it uses.
std::size_t count_unused(std::span<const PointId> points, const Trial& trial) {
  const std::vector<bool>& used = trial.request.used;
  if (used.empty()) return 0;
  return static_cast<std::size_t>(std::count_if(
      points.begin(), points.end(), [&](PointId p) { return !used[trial.input.number_of(p)]; }));
}

// Programs that read faces drop the points that no face uses.
void note_points(Trial& trial) {
  const auto& used = trial.request.used;
  const auto unused = static_cast<std::size_t>(std::count(used.begin(), used.end(), false));
  const Outside& outside = *trial.verdict.outside;
  if (!trial.input.numbers.empty() && unused > 0) {
    trial.verdict.notes.push_back(unused_text(unused));
  } else if (outside.unused > 0) {
    trial.verdict.notes.push_back(unused_outside_text(outside.unused, outside.points));
  }
}

void judge_outside(const std::vector<PointId>& outside, Trial& trial) {
  const std::string count =
      fmt::format("{} outside, of {} tested", counted(outside.size(), "point", "points"),
                  with_separators(trial.input.points.size()));
  find_polytope(trial);
  if (!trial.set.polytope) {
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
                  *worst.witness.input_point, trial.distance_text(squared), worst.plane_name),
      std::move(worst.witness));
}

// The vertices of a candidate. Where halfspaces meet may be beyond the largest double: then these
// points are the vertices over 2^shift.
struct CandidateVertices {
  explicit CandidateVertices(const PointSet& given) : points(given) {}
  explicit CandidateVertices(std::vector<RationalPoint> exact) {
    if (const auto largest = largest_exponent(exact)) shift = std::max(0L, *largest - 1000);
    if (shift > 0) {
      for (RationalPoint& v : exact) v = v.unaryExpr([&](const Rational& x) { return divided(x); });
    }
    points = PointSet(std::move(exact));
  }

  Rational divided(const Rational& x) const { return scale_by_power_of_two(x, -shift); }
  // The solid over the same power.
  Polytope divided(Polytope solid) const {
    for (RationalPoint& v : solid.vertices) {
      v = v.unaryExpr([&](const Rational& x) { return divided(x); });
    }
    for (Halfspace& plane : solid.planes) {
      plane = Halfspace(plane.normal().cast<Rational>(), divided(Rational(plane.offset())));
    }
    return solid;
  }
  RationalPoint operator[](PointId id) const {
    return points[id].unaryExpr([&](const Rational& x) { return scale_by_power_of_two(x, shift); });
  }

  PointSet points;
  long shift = 0;
};

// Those that lie outside of the input's hull.
struct VerticesOutside {
  std::size_t count = 0;
  std::optional<Farthest> worst;
  std::size_t plane = 0;  // of the hull: that the worst one is farthest beyond
};

VerticesOutside vertices_outside(const CandidateVertices& vertices, const Trial& trial) {
  std::optional<Polytope> divided;
  if (vertices.shift > 0) divided = vertices.divided(trial.input.hull);
  const Polytope& hull = divided ? *divided : trial.input.hull;
  const std::vector<PointId> outside = trial.log.run(
      "inside", [&] { return find_outside(hull.planes, vertices.points, trial.stop()); });
  if (outside.empty()) return {};
  std::optional<Farthest> worst = trial.log.run(
      "distance", [&] { return find_farthest(hull, vertices.points, outside, trial.stop()); });
  if (!worst) throw Error(ErrorCode::Internal, "vertices are outside, but none is far");
  const auto excess =
      find_excess(hull.planes, subset(vertices.points, std::span(&worst->point, 1)));
  if (!excess) throw Error(ErrorCode::Internal, "a vertex is outside, but beyond no plane");
  worst->nearest = worst->nearest.unaryExpr(
      [&](const Rational& x) { return scale_by_power_of_two(x, vertices.shift); });
  worst->squared_distance = scale_by_power_of_two(worst->squared_distance, 2 * vertices.shift);
  return {outside.size(), std::move(worst), excess->plane};
}

Witness witness_of(const Farthest& vertex, const CandidateVertices& vertices, const Trial& trial) {
  Witness witness;
  if (trial.mesh() != nullptr) witness.vertices = {vertex.point.index()};
  witness.point = vertices[vertex.point];
  witness.nearest = vertex.nearest;
  return witness;
}

// Why the candidate is no bounded solid; null if it is one, and then its polytope is known.
const char* reason_of_no_solid(Trial& trial) {
  if (trial.set.is_empty) return "the candidate is empty";
  find_polytope(trial);
  return trial.set.polytope ? nullptr : "the candidate is flat, or extends to infinity";
}

// The points whose hull the candidate is; none, with the claim decided, if it has no such points.
std::optional<CandidateVertices> vertices_of_candidate(Trial& trial) {
  if (trial.set.is_empty) {
    trial.not_applicable(InsideInput, "the candidate is empty");
    return {};
  }
  if (const Mesh* mesh = trial.mesh()) return CandidateVertices(mesh->points);
  if (trial.set.polytope) return CandidateVertices(trial.set.polytope->vertices);
  const std::optional<NotSolid> reason = find_vertices(trial);
  if (!reason) return CandidateVertices(trial.set.polytope->vertices);
  if (const auto* ray = std::get_if<RecessionRay>(&*reason)) {
    Witness witness;
    witness.direction = ray->direction;
    trial.violated(InsideInput, "the candidate extends to infinity", std::move(witness));
  } else {
    trial.not_applicable(InsideInput, "the candidate has no interior, so no vertices are known");
  }
  return {};
}

}  // namespace

void judge_containment(Trial& trial) {
  if (!trial.asks(ContainsInput)) return;
  const PointSet& points = trial.input.points;
  if (trial.set.is_empty) {
    trial.verdict.outside = Outside{.points = points.size(), .tested = points.size()};
    Witness witness;
    witness.input_point = trial.input.number_of(PointId(0));
    witness.point = points[PointId(0)];
    return trial.violated(ContainsInput, "the candidate is empty, so every point is outside",
                          std::move(witness));
  }
  trial.set.missed = trial.log.run(
      "containment", [&] { return find_outside(trial.set.planes, points, trial.stop()); });
  const std::vector<PointId>& outside = *trial.set.missed;
  trial.log.run("containment, second way", [&] { confirm(!outside.empty(), trial); });
  trial.verdict.outside = Outside{
      .points = outside.size(), .tested = points.size(), .unused = count_unused(outside, trial)};
  note_points(trial);
  if (!outside.empty()) return judge_outside(outside, trial);
  trial.holds(ContainsInput, counted(points.size(), "point", "points") + " tested, none outside");
}

// The hull of points lies in a convex set iff the points do.
void judge_inside_input(Trial& trial) {
  if (!trial.asks(InsideInput)) return;
  const std::optional<CandidateVertices> vertices = vertices_of_candidate(trial);
  if (!vertices) return;
  const std::string tested = counted(vertices->points.size(), "vertex", "vertices") + " tested";
  const VerticesOutside outside = vertices_outside(*vertices, trial);
  if (!outside.worst) {
    return trial.holds(InsideInput, tested + ", none outside of the input's hull");
  }
  const PointId worst = outside.worst->point;
  Witness witness = witness_of(*outside.worst, *vertices, trial);
  witness.plane = trial.input.hull.planes[outside.plane];
  trial.violated_by(
      outside.worst->squared_distance, InsideInput,
      fmt::format("{} outside of the input's hull, of {}; vertex {} is worst, {} from it, beyond "
                  "facet {}",
                  counted(outside.count, "vertex", "vertices"), tested, worst.index(),
                  trial.distance_text(outside.worst->squared_distance), outside.plane),
      std::move(witness));
}

// Two convex bodies are equal iff each holds the corners of the other, and the distance between
// them is the largest one of a corner of one to the other: the distance to a convex set is convex.
void judge_is_hull(Trial& trial) {
  if (!trial.asks(IsHull)) return;
  if (const char* reason = reason_of_no_solid(trial)) {
    return trial.violated(IsHull,
                          std::string(reason) + ", and the input's hull is a bounded solid");
  }
  const Polytope& solid = *trial.set.polytope;
  // As stored if they can be: doubles are tested faster.
  const CandidateVertices vertices =
      trial.set.hull ? CandidateVertices(subset(trial.mesh()->points, trial.set.hull->vertices))
                     : CandidateVertices(solid.vertices);
  const VerticesOutside beyond = vertices_outside(vertices, trial);
  if (!trial.set.missed) {
    trial.set.missed = trial.log.run("input outside", [&] {
      return find_outside(solid.planes, trial.input.points, trial.stop());
    });
  }
  const std::vector<PointId>& missed = *trial.set.missed;
  std::optional<Farthest> worst_missed;
  if (!missed.empty()) {
    worst_missed = trial.log.run("distance", [&] { return farthest_of(missed, trial); });
  }
  if (!beyond.worst && !worst_missed) {
    return trial.holds(IsHull,
                       fmt::format("it is the hull: {} and {} tested, none outside of the other",
                                   counted(trial.input.points.size(), "point", "points"),
                                   counted(vertices.points.size(), "vertex", "vertices")));
  }
  const bool is_too_large = beyond.worst && (!worst_missed || beyond.worst->squared_distance >=
                                                                  worst_missed->squared_distance);
  const Farthest& worst = is_too_large ? *beyond.worst : *worst_missed;
  Witness witness;
  witness.point = is_too_large ? vertices[worst.point] : trial.input.points[worst.point];
  witness.nearest = worst.nearest;
  if (!is_too_large) witness.input_point = trial.input.number_of(worst.point);
  trial.violated_by(
      worst.squared_distance, IsHull,
      fmt::format("it is not the hull: {} outside of it, and {} outside of the hull; worst is {}, "
                  "{} away",
                  counted(missed.size(), "point", "points"),
                  counted(beyond.count, "vertex", "vertices"),
                  is_too_large ? "a vertex of the candidate"
                               : fmt::format("point {}", *witness.input_point),
                  trial.distance_text(worst.squared_distance)),
      std::move(witness));
}

}  // namespace convexact::oracle
