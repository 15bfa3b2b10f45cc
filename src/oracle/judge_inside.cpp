// SPDX-License-Identifier: MIT
// Whether an inner solid lies in the hull of the input, and how far it reaches out of it.
#include <fmt/format.h>

#include <utility>

#include "convexact/error.hpp"
#include "convexact/stored.hpp"
#include "number/text.hpp"
#include "oracle/excess.hpp"
#include "oracle/judge.hpp"

namespace convexact::oracle {
namespace {

using enum ClaimCode;

// The points whose hull the candidate is; none, with the claim decided, if it has no such points.
std::optional<PointSet> vertices_of_candidate(Trial& trial) {
  if (const Mesh* mesh = trial.mesh()) return mesh->points;
  if (trial.set.is_empty) {
    trial.not_applicable(InsideInput, "the candidate is empty");
    return {};
  }
  if (trial.set.polytope) return PointSet(trial.set.polytope->vertices);
  const std::optional<NotSolid> reason = find_vertices(trial);
  if (!reason) return PointSet(trial.set.polytope->vertices);
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

// The hull of points lies in a convex set iff the points do.
void judge_inside_input(Trial& trial) {
  if (!trial.asks(InsideInput)) return;
  const std::optional<PointSet> vertices = vertices_of_candidate(trial);
  if (!vertices) return;
  const Polytope& hull = trial.input.hull;
  const std::vector<PointId> outside =
      trial.log.run("inside", [&] { return find_outside(hull.planes, *vertices, trial.stop()); });
  const std::string tested = counted(vertices->size(), "vertex", "vertices") + " tested";
  if (outside.empty())
    return trial.holds(InsideInput, tested + ", none outside of the input's hull");
  const std::optional<Farthest> farthest = trial.log.run(
      "distance", [&] { return find_farthest(hull, *vertices, outside, trial.stop()); });
  if (!farthest) throw Error(ErrorCode::Internal, "vertices are outside, but none is far");
  const PointId worst = farthest->point;
  const auto excess = find_excess(hull.planes, subset(*vertices, std::span(&worst, 1)));
  if (!excess) throw Error(ErrorCode::Internal, "a vertex is outside, but beyond no plane");
  Witness witness;
  if (trial.mesh() != nullptr) witness.vertices = {worst.index()};
  witness.point = (*vertices)[worst];
  witness.nearest = farthest->nearest;
  witness.plane = hull.planes[excess->plane];
  trial.violated_by(
      farthest->squared_distance, InsideInput,
      fmt::format("{} outside of the input's hull, of {}; vertex {} is worst, {} from it, beyond "
                  "facet {}",
                  counted(outside.size(), "vertex", "vertices"), tested, worst.index(),
                  trial.distance_text(farthest->squared_distance), excess->plane),
      std::move(witness));
}

}  // namespace convexact::oracle
