// SPDX-License-Identifier: MIT
// union_boundary.hpp - the boundary of a union of convex solids: the rest of each facet outside the
// other parts.
//
// Up to a set without area, a point of a facet lies on the boundary of the union iff no other part
// holds it in its interior, or in a facet that faces the opposite way. If other parts hold it in
// facets that face the same way, it is counted for the first part. So each point of the boundary is
// in one facet, which faces out of the union there.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "convexact/overlay.hpp"
#include "overlay/convex_piece.hpp"
#include "overlay/scaled.hpp"

namespace convexact {

/// Pieces of a plane.
struct PlanePieces {
  Arrangement<3> arrangement;
  std::vector<ConvexPiece<3>> pieces;
};

/// A facet of a solid part as one piece. The frame's triangle looks outward; its points are three
/// corners of the facet.
[[nodiscard]] PlanePieces whole_facet(const LaidPart& solid, std::size_t facet);

class UnionBoundary {
 public:
  /// The boundary of the parts that are solid. Keeps references.
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
  /// The solids that hold each of the points. @throws Error Stopped when the watch ends the call.
  Holders holders(const ScaledPoints& points, const Watch& watch, std::size_t jobs) const {
    return Holders(points, solids_, tree_, watch, jobs);
  }

  /// The pieces of a facet, in whole_facet(), that bound the union; nothing if there are none.
  std::optional<PlanePieces> rest(FacetId f) const;

  /// The rest of a triangle with an area outside the closed solids.
  std::optional<PlanePieces> rest_of(const ScaledPoints& points,
                                     const std::array<std::uint32_t, 3>& corners) const;

 private:
  using Meetings = std::vector<std::pair<std::uint32_t, Meeting>>;
  std::optional<PlanePieces> subtract_from(PlanePieces rest, const Meetings& meetings) const;
  const Polytope& polytope(FacetId f) const { return *solids_[f.part].part->solid; }

  std::vector<LaidPart> solids_;
  std::vector<FacetId> facets_;
  BoxTree tree_;
};

}  // namespace convexact
