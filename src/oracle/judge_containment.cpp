// SPDX-License-Identifier: MIT
// Whether a candidate contains the input: in two ways that share no predicate.
#include <fmt/format.h>

#include "convexact/error.hpp"
#include "convexact/geometry/orient3d.hpp"
#include "convexact/geometry/subset.hpp"
#include "convexact/number/digits.hpp"
#include "convexact/oracle/excess.hpp"
#include "convexact/oracle/support_program.hpp"
#include "convexact/stored/containment.hpp"
#include "judge.hpp"

namespace convexact::oracle {
namespace {

using enum ClaimCode;

bool is_strictly_beyond(const PointSet& mesh, const std::array<PointId, 3>& triangle,
                        const PointSet& points, std::size_t point) {
  const auto& [a, b, c] = triangle;
  if (mesh.is_binary() && points.is_binary()) {
    return is_beyond(mesh.doubles()[a.index()], mesh.doubles()[b.index()],
                     mesh.doubles()[c.index()], points.doubles()[point]);
  }
  const RationalPoint origin = mesh[a];
  const RationalVector3 u = mesh[b] - origin, v = mesh[c] - origin,
                        w = points[PointId(point)] - origin;
  return u.cross(v).dot(w) > 0;
}

// Every vertex of the input's hull against every triangle of the candidate's hull.
bool is_outside_by_triangles(const Hull& hull, const PointSet& mesh, const PointSet& extreme) {
  for (std::size_t f = 0; f < hull.facets.size(); ++f) {
    const auto corners = hull.facets[f];
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
      const std::array<PointId, 3> triangle{corners[0], corners[k], corners[k + 1]};
      for (std::size_t p = 0; p < extreme.size(); ++p) {
        if (is_strictly_beyond(mesh, triangle, extreme, p)) return true;
      }
    }
  }
  return false;
}

// The largest squared distance to which the input's hull reaches beyond a plane, by a linear
// program for each; 0 if it does so nowhere.
Rational reach_by_programs(const Polytope& hull, std::span<const Halfspace> planes) {
  const SupportProgram program(hull);
  Rational worst = 0;
  for (const Halfspace& plane : planes) {
    const Rational beyond = program.maximum(plane.normal()) + Rational(plane.offset());
    if (beyond <= 0) continue;
    worst = std::max(worst, Rational(beyond * beyond / Rational(plane.normal().squaredNorm())));
  }
  return worst;
}

// @throws Error Internal if the second way comes to another result than the first.
void confirm(const Input& input, const Candidate& candidate, const CandidateSet& set,
             const std::optional<Excess>& worst) {
  bool agrees = false;
  if (const auto* mesh = std::get_if<Mesh>(&candidate); mesh != nullptr && set.hull) {
    const PointSet extreme = subset(input.points, input.extreme);
    agrees = is_outside_by_triangles(*set.hull, mesh->points, extreme) == worst.has_value();
  } else {
    agrees = reach_by_programs(input.hull, set.planes) ==
             (worst ? worst->squared_distance : Rational(0));
  }
  if (!agrees) {
    throw Error(ErrorCode::Internal, "two ways to test containment disagree");
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
    return fmt::format("row {}", list->rows[plane] - 1);
  }
  if (!set.hull) return "the plane that holds the candidate";
  std::string corners;
  for (const PointId p : set.hull->facets[plane].first(3)) {
    corners += (corners.empty() ? "" : ", ") + std::to_string(p.index());
  }
  return "the facet through its points " + corners;
}

Witness witness_of(const Excess& worst, const Input& input, const Candidate& candidate,
                   const CandidateSet& set) {
  Witness witness;
  witness.input_point = worst.point.index();
  witness.point = input.points[worst.point];
  witness.plane = set.planes[worst.plane];
  if (const auto* list = std::get_if<HalfspaceList>(&candidate)) {
    witness.rows = {list->rows[worst.plane] - 1};
  } else if (set.hull) {
    for (const PointId p : set.hull->facets[worst.plane]) witness.vertices.push_back(p.index());
  }
  return witness;
}

}  // namespace

void judge_containment(const Input& input, const Candidate& candidate, const CandidateSet& set,
                       Docket& docket, StageLog& log) {
  if (!docket.asks(ContainsInput)) return;
  if (set.is_empty) return judge_empty(input, docket);
  Outside outside{0, input.points.size(), {}};
  std::optional<Excess> worst;
  log.run("containment", [&] {
    outside.points = count_outside(set.planes, input.points);
    if (outside.points > 0) worst = find_excess(set.planes, input.points);
  });
  log.run("containment, second way", [&] { confirm(input, candidate, set, worst); });
  if (worst) {
    outside.relative_squared_distance = worst->squared_distance / input.squared_diameter;
  }
  docket.verdict.outside = outside;
  if (!worst) {
    docket.holds(ContainsInput,
                 counted(outside.tested, "point", "points") + " tested, none outside");
    return;
  }
  docket.violated_by(
      worst->squared_distance, ContainsInput,
      fmt::format("{} outside, of {} tested; point {} is worst, beyond {} by {}",
                  counted(outside.points, "point", "points"), with_separators(outside.tested),
                  worst->point.index(), name_of_plane(candidate, set, worst->plane),
                  docket.distance_text(worst->squared_distance)),
      witness_of(*worst, input, candidate, set));
}

}  // namespace convexact::oracle
