// SPDX-License-Identifier: MIT
// verdict_check.hpp - whether a verdict of the oracle is the one that the definitions give.
#pragma once
#include <algorithm>
#include <string>

#include "convexact/verify.hpp"
#include "definitional_verdict.hpp"

namespace definition {

/// Collects the claims whose judgement differs from the definitions.
class Disagreements {
 public:
  explicit Disagreements(const Verdict& verdict) : verdict_(verdict) {}

  void expect(ClaimCode code, Status status) {
    require(verdict_[code].status == status, name_of(code));
  }
  void expect(ClaimCode code, bool holds) {
    expect(code, holds ? Status::Holds : Status::Violated);
  }
  void require(bool agrees, const std::string& what) {
    if (!agrees) found_ += what + " ";
  }
  const std::string& found() const { return found_; }
  const Verdict& verdict() const { return verdict_; }

 private:
  const Verdict& verdict_;
  std::string found_;
};

// Whether the witness's point has the stated distance from the stated nearest point, which lies in
// the solid, and no point is farther away.
inline bool is_farthest(const Witness& w, std::span<const Halfspace> planes,
                        const std::vector<RationalPoint>& points) {
  if (!w.nearest || !w.squared_distance) return false;
  const RationalVector3 way = points[*w.input_point] - *w.nearest;
  if (way.dot(way) != *w.squared_distance) return false;
  if (beyond(planes, {*w.nearest}).points > 0) return false;
  Rational worst = 0;
  for (const RationalPoint& p : points) {
    worst = std::max(worst, squared_distance(planes, p).value());
  }
  return worst == *w.squared_distance;
}

// Checks all input points against the planes, and a witness that must be beyond the plane that it
// names, at its stated distance from a bounded solid, or without a distance if there is none.
inline void check_containment(std::span<const Halfspace> planes, bool is_bounded_solid,
                              const PointSet& input, Disagreements& so_far) {
  const Verdict& verdict = so_far.verdict();
  const std::vector<RationalPoint> points = rationals(input);
  const Beyond outside = beyond(planes, points);
  so_far.expect(ClaimCode::ContainsInput, outside.points == 0);
  so_far.require(verdict.outside && verdict.outside->points == outside.points, "points-outside");
  const Witness& w = verdict[ClaimCode::ContainsInput].witness;
  if (outside.points == 0) {
    so_far.require(!w.squared_distance && !w.input_point, "witness of nothing");
    return;
  }
  so_far.require(w.input_point && w.plane && (*w.plane)(points[*w.input_point]) > 0, "witness");
  if (!is_bounded_solid) {
    so_far.require(!w.squared_distance && !w.nearest, "distance to no solid");
  } else {
    so_far.require(w.input_point && is_farthest(w, planes, points), "worst-distance");
  }
}

// `outward`: the same faces, turned over if all of a closed mesh look inward.
inline void check_convex(const MeshByDefinition& outward, Disagreements& so_far) {
  if (!outward.no_point_beyond_a_face()) {
    so_far.expect(ClaimCode::MeshConvex, Status::Violated);
  } else if (!outward.is_closed() || outward.is_twisted()) {
    so_far.expect(ClaimCode::MeshConvex, Status::NotApplicable);
  } else if (outward.planes().size() <= 64) {
    so_far.expect(ClaimCode::MeshConvex, outward.enclosed() == outward.hull_volume());
  }
}

inline void check_faces(const Mesh& mesh, const MeshByDefinition& truth, Disagreements& so_far) {
  if (!truth.has_faces()) {
    so_far.expect(ClaimCode::MeshClosed, false);
    for (const ClaimCode code :
         {ClaimCode::MeshOriented, ClaimCode::MeshPlanar, ClaimCode::MeshConvex}) {
      so_far.expect(code, Status::NotApplicable);
    }
    return;
  }
  const bool is_closed = truth.is_closed(), is_twisted = truth.is_twisted();
  so_far.expect(ClaimCode::MeshClosed, is_closed);
  so_far.expect(ClaimCode::MeshPlanar, truth.is_planar());
  if (is_twisted || is_closed) {
    so_far.expect(ClaimCode::MeshOriented, !is_twisted && truth.enclosed() > 0);
  } else {
    so_far.expect(ClaimCode::MeshOriented, Status::NotApplicable);
  }
  if (!truth.is_solid() || !truth.is_planar()) return;
  if (is_twisted || !is_closed || truth.enclosed() > 0) return check_convex(truth, so_far);
  Mesh turned = mesh;
  for (auto& polygon : turned.polygons) std::reverse(polygon.begin(), polygon.end());
  check_convex(MeshByDefinition(turned), so_far);
}

inline void check_mesh(const Mesh& mesh, const PointSet& input, Disagreements& so_far) {
  const MeshByDefinition truth(mesh);
  so_far.expect(ClaimCode::CandidateSolid, truth.is_solid());
  if (!mesh.polygons.empty()) check_faces(mesh, truth, so_far);
  if (truth.is_solid()) {
    check_containment(truth.planes(), true, input, so_far);
  } else {
    so_far.expect(ClaimCode::ContainsInput, Status::Violated);
  }
}

inline void check_halfspaces(const HalfspaceList& list, const PointSet& input,
                             Disagreements& so_far) {
  if (list.impossible_row) {
    so_far.expect(ClaimCode::CandidateSolid, Status::Violated);
    so_far.expect(ClaimCode::ContainsInput, Status::Violated);
    return;
  }
  const Verdict& verdict = so_far.verdict();
  const bool is_bounded_solid = verdict[ClaimCode::CandidateSolid].status == Status::Holds &&
                                verdict[ClaimCode::CandidateBounded].status == Status::Holds;
  check_containment(list.halfspaces, is_bounded_solid, input, so_far);
  if (list.halfspaces.size() > 64) return;
  const HalfspaceArrangement arrangement(list.halfspaces);
  const auto volume = arrangement.volume(arrangement.all());
  so_far.require(is_bounded_solid == (volume && *volume > 0), "bounded-solid");
  if (volume && *volume == 0) so_far.expect(ClaimCode::CandidateSolid, Status::Violated);
}

/// The names of the claims that differ; empty if the verdict on a small candidate is right.
[[nodiscard]] inline std::string disagreement(const Verdict& verdict, const Candidate& candidate,
                                              const PointSet& input) {
  Disagreements so_far(verdict);
  if (const auto* mesh = std::get_if<Mesh>(&candidate)) {
    check_mesh(*mesh, input, so_far);
  } else if (const auto* list = std::get_if<HalfspaceList>(&candidate)) {
    check_halfspaces(*list, input, so_far);
  } else {
    const bool is_number = std::get<Error>(candidate).code() == ErrorCode::NotFinite;
    so_far.expect(is_number ? ClaimCode::CandidateFinite : ClaimCode::CandidateReadable, false);
  }
  return so_far.found();
}

}  // namespace definition
