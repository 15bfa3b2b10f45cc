// SPDX-License-Identifier: MIT
// What set a candidate is: readable, solid, bounded, and how large.
#include <algorithm>

#include "convexact/number.hpp"
#include "oracle/judge.hpp"
#include "scene/solid.hpp"
#include "stored/near_products.hpp"

namespace convexact::oracle {
namespace {

using enum ClaimCode;

constexpr ClaimCode kAfterReading[] = {
    CandidateSolid, CandidateBounded, MeshClosed, MeshOriented, MeshPlanar,
    MeshConvex,     ContainsInput,    MaxFacets,  MaxVertices,  MaxFacetVertices};

std::string read_sentence(const Candidate& candidate) {
  if (const auto* mesh = std::get_if<Mesh>(&candidate)) {
    return "a mesh of " + counted(mesh->points.size(), "point", "points") + " and " +
           counted(mesh->polygons.size(), "face", "faces");
  }
  return "a list of " +
         counted(std::get<HalfspaceList>(candidate).row_count(), "halfspace", "halfspaces");
}

Halfspace turned_over(const Halfspace& h) {
  return {IntegerVector3(-h.normal()), Integer(-h.offset())};
}

CandidateSet flat_mesh(const FlatInput& flat, Docket& docket) {
  CandidateSet set;
  set.is_empty = flat.dimension < 0;
  Witness witness;
  for (const PointId id : flat.basis) witness.vertices.push_back(id.index());
  for (const Halfspace& plane : flat.equations) {
    set.planes.push_back(plane);
    set.planes.push_back(turned_over(plane));
  }
  if (!flat.equations.empty()) witness.plane = flat.equations.front();
  docket.violated(CandidateSolid, describe(flat), std::move(witness));
  docket.not_applicable(CandidateBounded, "there is no solid");
  return set;
}

std::vector<std::size_t> rows_of(const std::vector<Multiplier>& multipliers) {
  std::vector<std::size_t> rows;
  for (const Multiplier& m : multipliers) rows.push_back(m.row);
  return rows;
}

void judge_no_solid(const NotSolid& reason, Docket& docket) {
  Witness witness;
  if (const auto* ray = std::get_if<RecessionRay>(&reason)) {
    docket.holds(CandidateSolid, "it has a 3D interior");
    witness.direction = ray->direction;
    docket.violated(CandidateBounded, describe(reason), std::move(witness));
    return;
  }
  if (const auto* empty = std::get_if<EmptyProof>(&reason)) {
    witness.rows = rows_of(empty->farkas);
  } else if (const auto* flat = std::get_if<FlatProof>(&reason)) {
    witness.rows = rows_of(flat->multipliers);
    witness.point = flat->point;
  }
  docket.violated(CandidateSolid, describe(reason), std::move(witness));
  docket.not_applicable(CandidateBounded, "there is no solid");
}

void measure_size(const Polytope& polytope, CandidateSize& size) {
  size.facets = polytope.planes.size();
  size.vertices = polytope.vertices.size();
  size.most_facet_vertices = 0;
  for (const auto& facet : polytope.facets) {
    size.most_facet_vertices = std::max(*size.most_facet_vertices, facet.size());
  }
}

bool needs_polytope(const Docket& docket) {
  return docket.request.tightness || docket.asks(MaxFacets) || docket.asks(MaxVertices) ||
         docket.asks(MaxFacetVertices);
}

}  // namespace

bool judge_reading(const Candidate& candidate, Docket& docket) {
  const auto* error = std::get_if<Error>(&candidate);
  if (error == nullptr) {
    docket.holds(CandidateReadable, read_sentence(candidate));
    docket.holds(CandidateFinite, "every number is finite");
    return true;
  }
  Witness witness;
  witness.line = error->line();
  const bool is_number = error->code() == ErrorCode::NotFinite;
  docket.violated(is_number ? CandidateFinite : CandidateReadable, error->what(), witness);
  docket.not_applicable(is_number ? CandidateReadable : CandidateFinite,
                        "reading ended at that place");
  for (const ClaimCode code : kAfterReading) {
    docket.not_applicable(code, "the candidate could not be read");
  }
  return false;
}

CandidateSet judge_mesh_set(const Mesh& mesh, Docket& docket, StageLog& log) {
  CandidateSize& size = docket.verdict.size;
  size.stored_faces = mesh.polygons.size();
  size.stored_vertices = mesh.points.size();
  StageLog within(StageWatch{.stop = log.watch().stop});
  auto outcome = log.run("candidate's hull",
                         [&] { return make_hull(mesh.points, docket.request.seed, true, within); });
  if (const auto* reason = std::get_if<NotSolid>(&outcome)) {
    return flat_mesh(std::get<FlatInput>(*reason), docket);
  }
  CandidateSet set;
  set.hull = std::get<Hull>(std::move(outcome));
  set.planes = facet_halfspaces(*set.hull, mesh.points);
  if (needs_polytope(docket)) set.polytope = to_polytope(*set.hull, mesh.points);
  size.facets = set.hull->facets.size();
  size.vertices = set.hull->vertices.size();
  size.most_facet_vertices = 0;
  for (std::size_t f = 0; f < set.hull->facets.size(); ++f) {
    size.most_facet_vertices = std::max(*size.most_facet_vertices, set.hull->facets[f].size());
  }
  docket.holds(CandidateSolid, "its points span a volume");
  docket.holds(CandidateBounded, "the hull of points is bounded");
  return set;
}

CandidateSet judge_halfspace_set(const HalfspaceList& list, Docket& docket, StageLog& log) {
  docket.verdict.size.stored_faces = list.row_count();
  CandidateSet set;
  set.planes = list.halfspaces;
  if (list.impossible_row) {
    set.is_empty = true;
    Witness witness;
    witness.rows = {*list.impossible_row};
    docket.violated(CandidateSolid, "it is empty: a row with a zero normal holds nowhere",
                    std::move(witness));
    docket.not_applicable(CandidateBounded, "there is no solid");
    return set;
  }
  if (!needs_polytope(docket) && !docket.asks(CandidateSolid) && !docket.asks(CandidateBounded)) {
    log.skip("candidate's vertices", "only its planes were asked about");
    return set;
  }
  StageLog within(StageWatch{.stop = log.watch().stop});
  auto outcome = log.run("candidate's vertices", [&] {
    return make_polytope(list.halfspaces, docket.request.seed, within);
  });
  set.is_examined = true;
  if (const auto* reason = std::get_if<NotSolid>(&outcome)) {
    judge_no_solid(of_typed_rows(*reason, list), docket);
    return set;
  }
  set.polytope = std::get<Polytope>(std::move(outcome));
  measure_size(*set.polytope, docket.verdict.size);
  docket.holds(CandidateSolid, "it has a 3D interior");
  docket.holds(CandidateBounded, "no direction leads to infinity");
  return set;
}

void find_facets_as_meant(const Mesh& mesh, CandidateSet& set, Docket& docket, StageLog& log) {
  const bool is_asked = docket.request.tightness || docket.asks(MaxFacets);
  if (!set.polytope || !is_asked) return;
  CandidateSize& size = docket.verdict.size;
  const Precision precision = precision_of(mesh.points);
  log.run("facets as meant", [&] {
    size.slack = {precision, 0};
    set.patches = planar_patches(*set.polytope, size.slack);
    const Slack wide = {precision, docket.request.slack_ulps};
    if (wide.ulps_of_largest > 0) {
      auto patches = planar_patches(*set.polytope, wide);
      if (patches.size() < set.patches.size()) {
        set.patches = std::move(patches);
        size.slack = wide;
      }
    }
    size.facets_as_meant = set.patches.size();
  });
}

namespace {

// The patches of which every corner is as near to a facet plane of the input's hull as rounding
// explains, whatever program did it.
class PlanesOfTheInput {
 public:
  PlanesOfTheInput(const Polytope& polytope, Precision precision, std::span<const Halfspace> planes)
      : polytope_(polytope), planes_(planes.begin(), planes.end()) {
    std::sort(planes_.begin(), planes_.end());
    std::vector<Point> points;
    for (const RationalPoint& v : polytope.vertices) {
      Point& p = points.emplace_back();
      for (int k = 0; k < 3; ++k) {
        p[k] = to_double(v[k], Rounding::Nearest);
        slack_ = std::max<Rational>(slack_, abs(v[k]));
      }
    }
    slack_ = kRoundingUlps * unit_in_last_place(precision, slack_);
    vertices_.emplace(points);
    for (const Halfspace& h : planes_) near_planes_.emplace_back(h);
  }

  bool have(const std::vector<std::uint32_t>& patch) const {
    const auto is_exact = [&](std::uint32_t f) {
      return std::binary_search(planes_.begin(), planes_.end(), polytope_.planes[f]);
    };
    if (std::any_of(patch.begin(), patch.end(), is_exact)) return true;
    for (std::size_t i = 0; i < planes_.size(); ++i) {
      if (may_be_near(i, polytope_.facets[patch[0]][0]) && is_near(i, patch)) return true;
    }
    return false;
  }

 private:
  bool may_be_near(std::size_t plane, std::uint32_t vertex) const {
    const stored::NearValue near =
        near_planes_[plane].at(*vertices_, vertex, stored::absolute_error(vertices_->largest));
    const double most = 3 * to_double(slack_, Rounding::Up);  // no component is above 1
    return !(std::abs(near.value) - near.error > most);
  }
  bool is_near(std::size_t plane, const std::vector<std::uint32_t>& patch) const {
    const Halfspace& h = planes_[plane];
    Rational limit = 0;
    for (const Integer& n : h.normal()) limit += Rational(abs(n)) * slack_;
    return std::all_of(patch.begin(), patch.end(), [&](std::uint32_t f) {
      const auto& corners = polytope_.facets[f];
      return std::all_of(corners.begin(), corners.end(),
                         [&](std::uint32_t v) { return abs(h(polytope_.vertices[v])) <= limit; });
    });
  }

  const Polytope& polytope_;
  std::vector<Halfspace> planes_;
  Rational slack_ = 0;
  std::optional<stored::Coordinates> vertices_;
  std::vector<stored::DoubleHalfspace> near_planes_;
};

}  // namespace

void count_planes_of_the_input(const Input& input, const CandidateSet& set, Docket& docket) {
  const Polytope& polytope = *set.polytope;
  const PlanesOfTheInput planes(polytope, docket.verdict.size.slack.precision, input.hull.planes);
  std::vector<std::vector<std::uint32_t>> patches = set.patches;
  if (patches.empty()) {  // halfspaces: each facet is one
    for (std::uint32_t f = 0; f < polytope.facets.size(); ++f) patches.push_back({f});
  }
  docket.verdict.size.planes_of_the_input = static_cast<std::size_t>(
      std::count_if(patches.begin(), patches.end(), [&](const auto& p) { return planes.have(p); }));
}

namespace {

void judge_budget(ClaimCode code, std::optional<std::size_t> most, std::optional<std::size_t> found,
                  const std::string& what, const std::string& remark, Docket& docket) {
  if (!most) return;
  if (!found) {
    docket.not_applicable(code, "there is no bounded solid to count on");
    return;
  }
  const std::string sentence = what + ": " + std::to_string(*found) + ", at most " +
                               std::to_string(*most) + " allowed" + remark;
  Witness witness;
  witness.count = *found;
  if (*found <= *most) {
    docket.holds(code, sentence);
  } else {
    docket.violated(code, sentence, std::move(witness));
  }
}

}  // namespace

void judge_budgets(Docket& docket) {
  const CandidateSize& size = docket.verdict.size;
  const VerifyRequest& request = docket.request;
  if (size.facets_as_meant && !request.exact_facets) {
    judge_budget(MaxFacets, request.max_facets, size.facets_as_meant, "facets as meant",
                 "; exactly there are " + std::to_string(*size.facets) + ", and u is " +
                     describe(size.slack),
                 docket);
  } else {
    judge_budget(MaxFacets, request.max_facets, size.facets, "facets", "", docket);
  }
  judge_budget(MaxVertices, request.max_vertices, size.vertices, "vertices", "", docket);
  judge_budget(MaxFacetVertices, request.max_facet_vertices, size.most_facet_vertices,
               "corners of the largest facet", "", docket);
}

}  // namespace convexact::oracle
