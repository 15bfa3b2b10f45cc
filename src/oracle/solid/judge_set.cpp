// SPDX-License-Identifier: MIT
// The set that a candidate is: readable, solid, bounded, and its size.
#include <algorithm>

#include "convexact/measure.hpp"
#include "convexact/number.hpp"
#include "number/text.hpp"
#include "oracle/solid/judge.hpp"
#include "scene/objects.hpp"
#include "solid/solid.hpp"

namespace convexact::oracle {
namespace {

using enum ClaimCode;

// A flat mesh stands for the set that its planes hold, both sides of each.
void judge_flat_mesh(const FlatInput& flat, Trial& trial) {
  trial.set.is_empty = flat.dimension < 0;
  Witness witness;
  for (const PointId id : flat.basis) witness.vertices.push_back(id.index());
  for (const Halfspace& plane : flat.equations) {
    trial.set.planes.push_back(plane);
    trial.set.planes.emplace_back(IntegerVector3(-plane.normal()), Integer(-plane.offset()));
  }
  if (!flat.equations.empty()) witness.plane = flat.equations.front();
  trial.violated(CandidateSolid, describe(flat), std::move(witness));
  trial.not_applicable(CandidateBounded, "there is no solid");
}

void judge_no_solid(const NotSolid& reason, Trial& trial) {
  Witness witness;
  if (const auto* ray = std::get_if<RecessionRay>(&reason)) {
    trial.holds(CandidateSolid, "it has a 3D interior");
    witness.direction = ray->direction;
    trial.violated(CandidateBounded, describe(reason), std::move(witness));
    return;
  }
  const auto set_rows = [&](const std::vector<Multiplier>& multipliers) {
    for (const Multiplier& m : multipliers) witness.rows.push_back(m.row);
  };
  if (const auto* empty = std::get_if<EmptyProof>(&reason)) {
    set_rows(empty->farkas);
  } else if (const auto* flat = std::get_if<FlatProof>(&reason)) {
    set_rows(flat->multipliers);
    witness.point = flat->point;
  }
  trial.violated(CandidateSolid, describe(reason), std::move(witness));
  trial.not_applicable(CandidateBounded, "there is no solid");
}

// @param facets  The facets of a hull or a polytope.
template <class Facets>
void measure_size(const Facets& facets, std::size_t vertices, CandidateSize& size) {
  size.facets = facets.size();
  size.vertices = vertices;
  size.most_facet_vertices = 0;
  for (std::size_t f = 0; f < facets.size(); ++f) {
    size.most_facet_vertices = std::max(*size.most_facet_vertices, facets[f].size());
  }
}

bool needs_polytope(const Trial& trial) {
  return trial.request.tightness || trial.asks(MaxFacets) || trial.asks(MaxVertices) ||
         trial.asks(MaxFacetVertices);
}

void judge_mesh_set(const Mesh& mesh, Trial& trial) {
  CandidateSize& size = trial.verdict.size;
  size.stored_faces = mesh.polygons.size();
  size.stored_vertices = mesh.points.size();
  StageLog within = trial.unrecorded();
  auto outcome = trial.log.run("candidate's hull", [&] {
    return make_hull(mesh.points, {.seed = trial.request.seed}, within);
  });
  if (const auto* reason = std::get_if<NotSolid>(&outcome)) {
    return judge_flat_mesh(std::get<FlatInput>(*reason), trial);
  }
  trial.set.hull = std::get<Hull>(std::move(outcome));
  const Hull& hull = *trial.set.hull;
  trial.set.planes = facet_halfspaces(hull, mesh.points);
  if (needs_polytope(trial)) trial.set.polytope = to_polytope(hull, mesh.points);
  measure_size(hull.facets, hull.vertices.size(), size);
  trial.holds(CandidateSolid, "its points span a volume");
  trial.holds(CandidateBounded, "the hull of points is bounded");
}

void judge_halfspace_set(const HalfspaceList& list, Trial& trial) {
  trial.verdict.size.stored_faces = list.row_count();
  trial.set.planes = list.halfspaces;
  if (list.impossible_row) {
    trial.set.is_empty = true;
    Witness witness;
    witness.rows = {*list.impossible_row};
    trial.violated(CandidateSolid, "it is empty: a row with a zero normal holds nowhere",
                   std::move(witness));
    trial.not_applicable(CandidateBounded, "there is no solid");
    return;
  }
  if (!needs_polytope(trial) && !trial.asks(CandidateSolid) && !trial.asks(CandidateBounded)) {
    trial.log.skip("candidate's vertices", "only its planes were asked about");
    return;
  }
  if (const auto reason = find_vertices(trial)) {
    return judge_no_solid(of_typed_rows(*reason, list), trial);
  }
  const Polytope& polytope = *trial.set.polytope;
  measure_size(polytope.facets, polytope.vertices.size(), trial.verdict.size);
  trial.holds(CandidateSolid, "it has a 3D interior");
  trial.holds(CandidateBounded, "no direction leads to infinity");
}

void judge_budget(ClaimCode code, std::optional<std::size_t> found, const std::string& what,
                  const std::string& remark, Trial& trial) {
  const std::optional<std::size_t>& most = *budget_of(trial.request, code);
  if (!most) return;
  if (!found) return trial.not_applicable(code, "there is no bounded solid to count on");
  const std::string sentence = what + ": " + std::to_string(*found) + ", at most " +
                               std::to_string(*most) + " allowed" + remark;
  if (*found <= *most) return trial.holds(code, sentence);
  Witness witness;
  witness.count = *found;
  trial.violated(code, sentence, std::move(witness));
}

}  // namespace

bool judge_reading(Trial& trial) {
  const auto* error = std::get_if<Error>(&trial.candidate);
  if (error == nullptr) {
    const Mesh* mesh = trial.mesh();
    trial.holds(CandidateReadable,
                mesh == nullptr
                    ? "a list of " + counted(trial.list()->row_count(), "halfspace", "halfspaces")
                    : "a mesh of " + counted(mesh->points.size(), "point", "points") + " and " +
                          counted(mesh->polygons.size(), "face", "faces"));
    trial.holds(CandidateFinite, "every number is finite");
    if (const std::size_t objects = mesh == nullptr ? 0 : objects_in(*mesh); objects > 1) {
      trial.verdict.notes.push_back(
          "its " + std::to_string(objects) +
          " objects are judged as one solid, the hull of them all; --union judges their union");
    }
    return true;
  }
  trial.unreadable(*error, CandidateReadable, CandidateFinite, "the candidate");
  return false;
}

void judge_set(Trial& trial) {
  if (const Mesh* mesh = trial.mesh()) return judge_mesh_set(*mesh, trial);
  judge_halfspace_set(*trial.list(), trial);
}

std::optional<NotSolid> find_vertices(Trial& trial) {
  StageLog within = trial.unrecorded();
  auto outcome = trial.log.run("candidate's vertices", [&] {
    return make_polytope(trial.list()->halfspaces, trial.request.seed, within);
  });
  trial.set.is_examined = true;
  if (auto* reason = std::get_if<NotSolid>(&outcome)) return std::move(*reason);
  trial.set.polytope = std::get<Polytope>(std::move(outcome));
  return std::nullopt;
}

void find_facets_as_meant(Trial& trial) {
  const bool is_asked = trial.request.tightness || trial.asks(MaxFacets);
  CandidateSet& set = trial.set;
  if (trial.mesh() == nullptr || !set.polytope || !is_asked) return;
  CandidateSize& size = trial.verdict.size;
  const Precision precision = precision_of(trial.mesh()->points);
  trial.log.run("facets as meant", [&] {
    size.slack = {precision, 0};
    const Watch watch(trial.stop());
    set.patches = planar_patches(*set.polytope, size.slack, watch);
    const Slack wide = {precision, trial.request.slack_ulps};
    if (wide.ulps_of_largest > 0) {
      auto patches = planar_patches(*set.polytope, wide, watch);
      if (patches.size() < set.patches.size()) {
        set.patches = std::move(patches);
        size.slack = wide;
      }
    }
    size.facets_as_meant = set.patches.size();
  });
}

void judge_budgets(Trial& trial) {
  const CandidateSize& size = trial.verdict.size;
  if (size.facets_as_meant && !trial.request.exact_facets) {
    judge_budget(MaxFacets, size.facets_as_meant, "facets as meant",
                 "; exactly there are " + std::to_string(*size.facets) + ", and u is " +
                     describe(size.slack),
                 trial);
  } else {
    judge_budget(MaxFacets, size.facets, "facets", "", trial);
  }
  judge_budget(MaxVertices, size.vertices, "vertices", "", trial);
  judge_budget(MaxFacetVertices, size.most_facet_vertices, "corners of the largest facet", "",
               trial);
}

}  // namespace convexact::oracle
