// SPDX-License-Identifier: MIT
// dual_hull.hpp - the triangulated dual hull of a solid: what every engine starts from.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "convexact/geometry/halfspace.hpp"
#include "convexact/geometry/ids.hpp"
#include "convexact/geometry/polytope.hpp"
#include "convexact/hull/hull.hpp"

namespace convexact {

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

/// Reads the dual off a primal hull: no second hull is computed. `vertices` are hull.vertices.
/// @par Cost  Linear, after sorting the halfspaces.
[[nodiscard]] DualHull dual_of(const Hull& hull, const PointSet& points);

/// Why an input halfspace bounds no facet of the solid.
enum class Redundancy {
  Duplicate,       ///< Equal to an earlier row.
  ParallelWeaker,  ///< Another row has the same direction and a tighter offset.
  Implied,         ///< The others imply it; its plane meets the solid in an edge, a vertex or not.
};

struct RedundantHalfspace {
  std::size_t row;  ///< Of the input, counted from 0.
  Redundancy why;
};

/// The dual of halfspaces as given.
struct HalfspaceDual {
  DualHull dual;
  std::vector<std::size_t> rows;              ///< Input row of each halfspace of `dual`.
  std::vector<RedundantHalfspace> redundant;  ///< Ascending by row.
};

/// The dual of the intersection of `halfspaces`, by the incremental hull of their dual points.
/// @param center  Strictly inside every halfspace. The result does not depend on it.
/// @param seed    Of the hull's insertion order; only the choice among triangulations of equal
///                faces may depend on it.
/// @throws Error  InvalidArgument if the center is not strictly inside or the intersection is
///                unbounded.
/// @par Cost      Expected O(n log n).
[[nodiscard]] HalfspaceDual dual_of(std::span<const Halfspace> halfspaces,
                                    const RationalPoint& center, std::uint64_t seed = 1);

/// The solid that a dual hull stands for: equal vertices merged, facets maximal and in canonical
/// order, counter-clockwise from outside. `triangles` may use a subset of the halfspaces.
/// Precondition: a closed convex dual surface whose triangles all have a vertex (D > 0).
[[nodiscard]] Polytope to_polytope(std::span<const Halfspace> halfspaces,
                                   std::span<const DualTriangle> triangles);

}  // namespace convexact
