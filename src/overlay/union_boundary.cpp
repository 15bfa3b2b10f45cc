// SPDX-License-Identifier: MIT
#include "overlay/union_boundary.hpp"

#include <algorithm>

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

UnionBoundary::UnionBoundary(std::span<const ConvexPart> parts, long exponent)
    : solids_(lay_solids(parts, exponent)), tree_(tree_over_solids(solids_)) {
  for (std::size_t s = 0; s < solids_.size(); ++s) {
    const auto& facets = solids_[s].part->solid->facets;
    EdgeFacets& edges = edge_facets_.emplace_back();
    for (std::size_t f = 0; f < facets.size(); ++f) {
      facets_.push_back({static_cast<std::uint32_t>(s), static_cast<std::uint32_t>(f)});
      for (std::size_t i = 0; i < facets[f].size(); ++i) {
        const std::uint32_t tail = facets[f][i], head = facets[f][(i + 1) % facets[f].size()];
        edges.push_back({{tail, head}, static_cast<std::uint32_t>(f)});
      }
    }
    std::sort(edges.begin(), edges.end());
  }
}

NearBox UnionBoundary::box(FacetId f) const {
  NearBox box;
  for (const std::uint32_t i : corners(f)) box.include(points(f).box(i));
  return box;
}

UnionBoundary::Rest UnionBoundary::whole(FacetId f) const {
  const auto ids = corners(f);
  const std::size_t m = ids.size();
  const ScaledPoints& vertices = points(f);
  Rest rest{Arrangement<3>({vertices.exact(ids[0]), vertices.exact(ids[m / 3]),
                            vertices.exact(ids[2 * m / 3])}),
            {}};
  if (m == 3) {
    rest.pieces.push_back(whole_frame<3>());
    return rest;
  }
  // Each side is cut out by the facet across.
  const EdgeFacets& edges = edge_facets_[f.part];
  std::vector<std::uint32_t> sides;
  for (std::size_t i = 0; i < m; ++i) {
    const std::pair reversed(ids[(i + 1) % m], ids[i]);
    const auto across = std::lower_bound(edges.begin(), edges.end(), std::pair(reversed, 0u));
    CONVEXACT_ASSERT(across != edges.end() && across->first == reversed);
    sides.push_back(rest.arrangement.add(polytope(f).planes[across->second]));
  }
  ConvexPiece<3>& piece = rest.pieces.emplace_back();
  for (std::size_t i = 0; i < m; ++i) {
    const auto corner = rest.arrangement.meet({sides[(i + m - 1) % m], sides[i]});
    piece.corners.push_back({corner, sides[i]});
  }
  return rest;
}

std::optional<UnionBoundary::Rest> UnionBoundary::subtract_from(Rest rest,
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

std::optional<UnionBoundary::Rest> UnionBoundary::rest(FacetId f) const {
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
  return subtract_from(whole(f), meetings);
}

std::optional<UnionBoundary::Rest> UnionBoundary::rest_of(
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
  Rest whole{Arrangement<3>(
                 {points.exact(corners[0]), points.exact(corners[1]), points.exact(corners[2])}),
             {whole_frame<3>()}};
  return subtract_from(std::move(whole), meetings);
}

}  // namespace convexact
