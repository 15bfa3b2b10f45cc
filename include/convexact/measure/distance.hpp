// SPDX-License-Identifier: MIT
// distance.hpp - from points to a polytope, and from a polytope to one that it contains: exact
// squares.
#pragma once
#include <atomic>
#include <optional>
#include <vector>

#include "convexact/geometry/edges.hpp"
#include "convexact/geometry/polytope.hpp"

namespace convexact {

/// Finds the nearest point of one polytope. Space outside is divided into the regions of points
/// that are nearest to one facet, edge or vertex; each is bounded by planes, so that only signs of
/// integers are needed to find the right one, and it proves itself. Not for several threads at
/// once.
/// @par Source  [LinCanny1991]; [Rockafellar1970, thm. 27.4] for the proof.
class NearestPoint {
 public:
  /// Keeps a reference. @par Cost  O(E log E), without an exact plane: those of a feature are
  ///                             computed when it is first asked about.
  explicit NearestPoint(const Polytope& polytope);

  /// The unique point of the polytope nearest to x; x itself if inside or on the boundary.
  /// @par Cost  Of x outside: a product in doubles per facet, then a few signs for each feature of
  ///            the visible facets, those first that are next to the facet x is farthest beyond.
  ///            Of x inside: the products, and a sign where these leave it open.
  RationalPoint operator()(const RationalPoint& x) const;

 private:
  struct Homogeneous;
  // A facet's side from vertex `tail` to vertex `head`.
  struct HalfEdge {
    std::uint32_t tail, head, twin, facet;
  };
  // Two planes through its tail, once they are computed.
  struct EdgePlanes {
    std::optional<Halfspace> side;  // holds what projects to the facet's side of the edge
    std::optional<Halfspace> end;   // perpendicular to it; holds what does not lie towards `head`
  };

  // A plane in doubles with a normal of length 1, for coordinates relative to the first vertex.
  struct NearPlane {
    Vector3<double> n;
    double d;
  };

  std::optional<std::uint32_t> visible_facet(const RationalPoint& x,
                                             const Homogeneous& homogeneous) const;
  RationalPoint nearest_around(std::uint32_t visible, const RationalPoint& x,
                               const Homogeneous& homogeneous) const;
  const Halfspace& side(std::uint32_t half_edge) const;
  const Halfspace& end(std::uint32_t half_edge) const;
  bool in_facet_region(std::uint32_t facet, const Homogeneous& x) const;
  bool in_edge_region(std::uint32_t half_edge, const Homogeneous& x) const;
  bool in_vertex_region(std::uint32_t vertex, const Homogeneous& x) const;

  const Polytope& polytope_;
  std::vector<NearPlane> near_planes_;
  std::vector<HalfEdge> half_edges_;
  mutable std::vector<EdgePlanes> edge_planes_;        // as half_edges_; filled by side() and end()
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
/// @throws Error Stopped when `stop` becomes true.
/// @par Cost  NearestPoint for each outer vertex that is no inner one.
[[nodiscard]] HausdorffDistance hausdorff_distance(const Polytope& outer, const Polytope& inner,
                                                   const std::atomic<bool>* stop = nullptr);

}  // namespace convexact
