// SPDX-License-Identifier: MIT
// distance.hpp - from points to a polytope, and from a polytope to one that it contains: exact
// squares.
#pragma once
#include <vector>

#include "convexact/geometry/edges.hpp"
#include "convexact/geometry/polytope.hpp"

namespace convexact {

/// Finds the nearest point of one polytope. Space outside is divided into the regions of points
/// that are nearest to one facet, edge or vertex; each is bounded by planes, so that only signs of
/// integers are needed to find the right one, and it proves itself.
/// @par Source  [LinCanny1991]; [Rockafellar1970, thm. 27.4] for the proof.
class NearestPoint {
 public:
  /// Keeps a reference. @par Cost  O(E) planes.
  explicit NearestPoint(const Polytope& polytope);

  /// The unique point of the polytope nearest to x; x itself if inside or on the boundary.
  /// @par Cost  One sign per facet, then a few for each feature of the facets visible from x.
  RationalPoint operator()(const RationalPoint& x) const;

 private:
  struct Homogeneous;
  // A facet's side from vertex `tail` to vertex `head`, and two planes through `tail`.
  struct HalfEdge {
    std::uint32_t tail, head, twin;
    Halfspace side;  // holds what projects to the facet's side of the edge
    Halfspace end;   // perpendicular to the edge; holds what does not lie towards `head`
  };

  RationalPoint nearest_on_visible(const std::vector<std::uint32_t>& visible,
                                   const RationalPoint& x, const Homogeneous& homogeneous) const;
  bool in_facet_region(std::uint32_t facet, const Homogeneous& x) const;
  bool in_edge_region(std::uint32_t half_edge, const Homogeneous& x) const;
  bool in_vertex_region(std::uint32_t vertex, const Homogeneous& x) const;

  const Polytope& polytope_;
  std::vector<HalfEdge> half_edges_;
  std::vector<std::vector<std::uint32_t>> of_facet_;   // half-edges around each facet
  std::vector<std::vector<std::uint32_t>> of_vertex_;  // half-edges out of each vertex
};

/// The Hausdorff distance between a polytope and one inside it, with the pair that attains it.
struct HausdorffDistance {
  Rational squared;       ///< Exact, in squared length units.
  std::uint32_t vertex;   ///< Of the outer polytope, the lowest index on a tie.
  RationalPoint nearest;  ///< Its nearest point of the inner polytope.
};

/// The distance to a convex set is a convex function, so on the outer polytope it is largest at one
/// of its vertices; and no point of the inner one is away from the outer one. Precondition: `outer`
/// contains `inner`.
/// @par Cost  Outer vertices times inner facets integer signs.
[[nodiscard]] HausdorffDistance hausdorff_distance(const Polytope& outer, const Polytope& inner);

}  // namespace convexact
