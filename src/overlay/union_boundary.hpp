// SPDX-License-Identifier: MIT
// union_boundary.hpp - the boundary of a union of convex solids: what other parts leave of each
// facet.
//
// Up to a set without area, a point of a facet lies on the boundary of the union iff no other part
// holds it in its interior, or in a facet that looks the other way. If other parts hold it in
// facets that look the same way, the first part has it. So each point of the boundary is in one
// facet, which looks out of the union there.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "convexact/overlay.hpp"
#include "overlay/arrangement.hpp"
#include "overlay/scaled.hpp"

namespace convexact {

class UnionBoundary {
 public:
  /// Of the parts that are solid. Keeps references.
  UnionBoundary(std::span<const ConvexPart> parts, long exponent);

  struct FacetId {
    std::uint32_t part, facet;  ///< Into solids(), and into the facets of that one.
  };
  std::span<const FacetId> facets() const { return facets_; }
  std::span<const LaidPart> solids() const { return solids_; }
  const Halfspace& plane(FacetId f) const { return polytope(f).planes[f.facet]; }
  std::span<const std::uint32_t> corners(FacetId f) const { return polytope(f).facets[f.facet]; }
  const ScaledPoints& points(FacetId f) const { return solids_[f.part].vertices; }
  NearBox box(FacetId f) const;

  /// What of a facet bounds the union. The frame's triangle looks outward; its points are three
  /// corners of the facet.
  struct Rest {
    Arrangement<3> arrangement;
    std::vector<ConvexPiece<3>> pieces;
  };
  std::optional<Rest> rest(FacetId f) const;

  /// What the closed solids leave of a triangle with an area.
  std::optional<Rest> rest_of(const ScaledPoints& points,
                              const std::array<std::uint32_t, 3>& corners) const;

 private:
  using Meetings = std::vector<std::pair<std::uint32_t, Meeting>>;
  std::optional<Rest> subtract_from(Rest rest, const Meetings& meetings) const;
  const Polytope& polytope(FacetId f) const { return *solids_[f.part].part->solid; }
  Rest whole(FacetId f) const;

  std::vector<LaidPart> solids_;
  std::vector<FacetId> facets_;
  BoxTree tree_;
  // By solid: (tail, head) of an edge of a facet with that edge, ascending.
  using EdgeFacets = std::vector<std::pair<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>>;
  std::vector<EdgeFacets> edge_facets_;
};

}  // namespace convexact
