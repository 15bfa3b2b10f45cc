// SPDX-License-Identifier: MIT
// dual.hpp - the polar dual of a solid: the map, its hull, and its topology as a matrix.
//
// A halfspace with the center strictly inside becomes a point, a vertex of the solid becomes a
// plane, and the solid becomes the hull of the points: to drop a halfspace is to remove a point.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "convexact/geometry.hpp"
#include "convexact/hull.hpp"
#include "convexact/number.hpp"

namespace convexact {

/// The point n / w of dual space, in primitive integers; w > 0.
using DualPoint = HomogeneousPoint;

/// The plane {p : dot(x, p) = d} of dual space in primitive integers, x nonzero. With d > 0 it is
/// the polar of the primal vertex center + x / d and the origin lies below it; with d <= 0 it
/// corresponds to no vertex: the three halfspaces through it leave a gap to infinity.
struct DualPlane {
  IntegerVector3 x;
  Integer d;
};

/// Halfspace {x : n.x + d <= 0} to its dual point (n : w), w = -(n.center + d).
/// @throws Error InvalidArgument unless the center is strictly inside.
[[nodiscard]] DualPoint polar(const Halfspace& halfspace, const RationalPoint& center);
/// The inverse: the polar of the polar is the halfspace itself.
[[nodiscard]] Halfspace polar(const DualPoint& point, const RationalPoint& center);

/// Dual plane to the vertex center + x / d. Precondition: d > 0.
[[nodiscard]] RationalPoint polar(const DualPlane& plane, const RationalPoint& center);
/// The inverse. @throws Error InvalidArgument if the vertex is the center.
[[nodiscard]] DualPlane polar(const RationalPoint& vertex, const RationalPoint& center);

/// The plane through three dual points, counter-clockwise from outside: d has the sign of
/// det(n_a, n_b, n_c). For the dual points (1,0,0), (0,1,0), (0,0,1), w = 1, it is x = (1,1,1),
/// d = 1, the polar of the cube corner (1,1,1). Precondition: the points are not collinear.
[[nodiscard]] DualPlane plane_through(const DualPoint& a, const DualPoint& b, const DualPoint& c);

/// dot(x, n) - d w: positive iff the dual point lies strictly beyond the plane, that is, iff the
/// halfspace cuts the vertex off. Up to a positive factor it is the determinant H of the four rows
/// (n, d) of the planes concerned, and hence independent of the center. For the plane above,
/// (1,1,1 : 2) gives 3 - 2 = 1: x + y + z <= 2 cuts (1,1,1) off.
[[nodiscard]] Integer height(const DualPlane& plane, const DualPoint& point);
[[nodiscard]] inline bool is_beyond(const DualPoint& point, const DualPlane& plane) {
  return height(plane, point) > 0;
}

/// Entry (i, j) = k says that the triangle (i, j, k) lies to the left of the directed edge i -> j,
/// seen from outside. A row holds the one-ring of its dual point, so memory is linear in the edges.
/// The paper's own data structure for the topology of the dual.
class AdjacencyMatrix {
 public:
  explicit AdjacencyMatrix(std::size_t size) : rows_(size) {}

  std::size_t size() const { return rows_.size(); }
  /// Sets the three entries of a triangle. Precondition: none of them is set.
  void add(const DualTriangle& triangle);
  /// Clears the three entries of a triangle that is present.
  void remove(const DualTriangle& triangle);
  /// Entry (i, j).
  std::optional<HalfspaceId> at(HalfspaceId i, HalfspaceId j) const;
  /// Neighbours of i, counter-clockwise from outside, starting at the lowest id; empty if i has
  /// none.
  std::vector<HalfspaceId> one_ring(HalfspaceId i) const;
  /// Every triangle once, lowest id first, ascending.
  std::vector<DualTriangle> triangles() const;
  /// (i, j) is set iff (j, i) is; (i, j) = k implies (j, k) = i and (k, i) = j; one ring per row.
  bool is_closed_manifold() const;

 private:
  using Entry = std::pair<HalfspaceId, HalfspaceId>;  // column j, value k
  std::vector<std::vector<Entry>> rows_;
};

/// A bounded solid as halfspaces, with the topology of the hull of their dual points. Dual vertices
/// are the solid's facets; dual faces, cut into triangles, are its vertices.
struct DualHull {
  std::vector<Halfspace> halfspaces;    ///< In canonical order, none redundant; at least four.
  std::vector<DualTriangle> triangles;  ///< 2 halfspaces.size() - 4 of them, a closed sphere.
  std::vector<RationalPoint> vertices;  ///< Of the solid, each once, in no promised order.
  /// witness[i] is the index of a vertex that lies on plane i: there n_i.x is largest over the
  /// solid, so the halfspace holds the solid as long as it holds its witness.
  std::vector<std::uint32_t> witness;
};

/// Reads the dual off a primal hull, without computing a second hull. `vertices` are hull.vertices.
/// @par Cost  Linear, after sorting the halfspaces.
[[nodiscard]] DualHull dual_of(const Hull& hull, const PointSet& points);

/// The dual of halfspaces as given.
struct HalfspaceDual {
  DualHull dual;
  std::vector<std::size_t> rows;  ///< Input row of each halfspace of `dual`, counted from 0.
  /// Input row of each dual point that the hull was made of: the tightest of each direction, in
  /// canonical order. An observer's points are positions in this list.
  std::vector<std::size_t> hull_rows;
  /// The other input rows, ascending: repeats of earlier rows, those with the direction of a
  /// tighter one, and those that the others imply.
  std::vector<std::size_t> redundant;
};

/// The dual of the intersection of `halfspaces`, by the incremental hull of their dual points.
/// @param center  Strictly inside every halfspace. The result does not depend on it.
/// @param seed    Seed of the hull's insertion order; only the choice among triangulations of equal
///                faces may depend on it.
/// @param observer  Sees the hull of the dual points grow; null for none.
/// @throws Error  InvalidArgument if the center is not strictly inside or the intersection is
///                unbounded.
/// @par Cost      Expected O(n log n).
[[nodiscard]] HalfspaceDual dual_of(std::span<const Halfspace> halfspaces,
                                    const RationalPoint& center, std::uint64_t seed = 1,
                                    HullObserver* observer = nullptr);

/// The solid that a dual hull stands for: equal vertices merged, facets maximal and in canonical
/// order, counter-clockwise from outside. `triangles` may use a subset of the halfspaces.
/// Precondition: a closed convex dual surface whose triangles all have a vertex (D > 0).
[[nodiscard]] Polytope to_polytope(std::span<const Halfspace> halfspaces,
                                   std::span<const DualTriangle> triangles);

}  // namespace convexact
