// SPDX-License-Identifier: MIT
// dual_faces.hpp - the faces of a dual hull: the facets around each vertex of the primal hull.
#pragma once
#include <vector>

#include "convexact/hull.hpp"

namespace convexact {

/// The dual hull of a primal hull, triangulated. Ids are positions in the list of facets.
struct DualFaces {
  std::vector<DualTriangle> triangles;
  /// Of half-edge 3 t + c, which leaves corner c of triangle t, the opposite one.
  std::vector<std::uint32_t> twins;
};

/// A dual face, the convex polygon of the facets around a vertex, is cut in a zigzag: no dual point
/// gets more than two diagonals of it, so rings stay short where hundreds of facets meet, as a fan
/// would not keep them.
/// @param facets  Closed and manifold; corners below point_count.
/// @par Cost      Linear.
[[nodiscard]] DualFaces triangulate_dual_faces(const FacetList& facets, std::size_t point_count);

}  // namespace convexact
