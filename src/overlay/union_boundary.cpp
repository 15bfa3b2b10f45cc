// SPDX-License-Identifier: MIT
#include "overlay/union_boundary.hpp"

namespace convexact {
namespace {

std::vector<LaidPart> lay_solids(std::span<const ConvexPart> parts, long exponent) {
  std::vector<LaidPart> solids;
  for (const ConvexPart& part : parts) {
    if (part.solid) solids.emplace_back(part, exponent);
  }
  return solids;
}

BoxTree tree_over_solids(std::span<const LaidPart> solids) {
  std::vector<NearBox> boxes;
  for (const LaidPart& solid : solids) boxes.push_back(solid.box);
  return BoxTree(std::move(boxes));
}

}  // namespace

PlanePieces whole_facet(const LaidPart& solid, std::size_t facet) {
  const std::vector<std::uint32_t>& ids = solid.part->solid->facets[facet];
  const std::size_t m = ids.size();
  const auto corner = [&](std::size_t i) -> const HomogeneousPoint& {
    return solid.vertices.exact(ids[i % m]);
  };
  PlanePieces whole{Arrangement<3>({corner(0), corner(m / 3), corner(2 * m / 3)}), {}};
  if (m == 3) {
    whole.pieces.push_back(whole_frame<3>());
    return whole;
  }
  const IntegerVector3& normal = solid.part->solid->planes[facet].normal();
  std::vector<std::uint32_t> sides;
  for (std::size_t i = 0; i < m; ++i) {
    sides.push_back(whole.arrangement.add(wall(corner(i), corner(i + 1), normal)));
  }
  ConvexPiece<3>& piece = whole.pieces.emplace_back();
  for (std::size_t i = 0; i < m; ++i) {
    const auto at = whole.arrangement.meet({sides[(i + m - 1) % m], sides[i]});
    piece.corners.push_back({at, sides[i]});
  }
  return whole;
}

UnionBoundary::UnionBoundary(std::span<const ConvexPart> parts, long exponent)
    : solids_(lay_solids(parts, exponent)), tree_(tree_over_solids(solids_)) {
  for (std::size_t s = 0; s < solids_.size(); ++s) {
    for (std::size_t f = 0; f < solids_[s].part->solid->facets.size(); ++f) {
      facets_.push_back({static_cast<std::uint32_t>(s), static_cast<std::uint32_t>(f)});
    }
  }
}

NearBox UnionBoundary::box(FacetId f) const {
  NearBox box;
  for (const std::uint32_t i : corners(f)) box.include(points(f).box(i));
  return box;
}

std::optional<PlanePieces> UnionBoundary::subtract_from(PlanePieces rest,
                                                        const Meetings& meetings) const {
  std::vector<std::uint32_t> rows;
  for (const auto& [s, met] : meetings) {
    rows.clear();
    for (const std::size_t h : met.planes) {
      rows.push_back(rest.arrangement.add(solids_[s].part->halfspaces[h]));
    }
    (void)subtract<3>(rest.arrangement, rest.pieces, rows);
    if (rest.pieces.empty()) return std::nullopt;
  }
  return rest;
}

std::optional<PlanePieces> UnionBoundary::rest(FacetId f) const {
  std::vector<std::uint32_t> near;
  tree_.find(box(f), near);
  Meetings meetings;
  for (const std::uint32_t s : near) {
    if (s == f.part) continue;
    Meeting met = meeting(solids_[s], points(f), corners(f));
    if (met.kind == Meeting::Apart) continue;
    if (met.coplanar) {
      const Halfspace& other = solids_[s].part->halfspaces[*met.coplanar];
      const bool looks_alike = dot(other.normal(), plane(f).normal()) > 0;
      if (looks_alike && s > f.part) continue;  // this facet comes first
    }
    if (met.kind == Meeting::Holds) return std::nullopt;
    meetings.emplace_back(s, std::move(met));
  }
  return subtract_from(whole_facet(solids_[f.part], f.facet), meetings);
}

std::optional<PlanePieces> UnionBoundary::rest_of(
    const ScaledPoints& points, const std::array<std::uint32_t, 3>& corners) const {
  NearBox box;
  for (const std::uint32_t i : corners) box.include(points.box(i));
  std::vector<std::uint32_t> near;
  tree_.find(box, near);
  Meetings meetings;
  for (const std::uint32_t s : near) {
    Meeting met = meeting(solids_[s], points, corners);
    if (met.kind == Meeting::Holds) return std::nullopt;
    if (met.kind == Meeting::Crossing) meetings.emplace_back(s, std::move(met));
  }
  PlanePieces whole{Arrangement<3>({points.exact(corners[0]), points.exact(corners[1]),
                                    points.exact(corners[2])}),
                    {whole_frame<3>()}};
  return subtract_from(std::move(whole), meetings);
}

}  // namespace convexact
