// SPDX-License-Identifier: MIT
// hull_steps.hpp - the three steps of convex_hull(): a simplex, a triangulated surface, its facets.
// Each is a function over any exact points, and is compiled for both kinds.
#pragma once
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "convexact/hull.hpp"
#include "hull/exact_points.hpp"

namespace convexact {

/// Affinely independent points, far apart where possible, as many as there are (at most 4). If
/// there are four, the side of the last from the first three is Negative. Linear time; the exact
/// tests run over all points only if the input is flat or nearly so.
/// @tparam Points  ExactPoints that also offer size() and collinear(a, b, c).
template <ExactPoints Points>
std::vector<PointId> find_simplex(const Points& points);

/// A triangle of the surface, counter-clockwise from outside, with its near plane: a cache line.
/// neighbors[k] lies over the edge from corners[k] to corners[(k + 1) % 3].
struct alignas(64) SurfaceTriangle {
  NearPlane plane;
  std::array<PointId, 3> corners;
  std::array<std::uint32_t, 3> neighbors;
};

inline constexpr std::array<std::size_t, 3> kNextCorner{1, 2, 0};

/// The corner of a triangle from which its edge to the triangle `neighbor` starts.
inline std::size_t edge_towards(const SurfaceTriangle& triangle, std::uint32_t neighbor) {
  return triangle.neighbors[0] == neighbor ? 0 : triangle.neighbors[1] == neighbor ? 1 : 2;
}

/// The result of inserting all points. Coplanar triangles are not merged, and vertices may lie
/// inside a facet or an edge of the hull.
struct TriangulatedHull {
  std::vector<SurfaceTriangle> triangles;
  std::vector<InsideProof> inside;  ///< In the order in which points were discarded.
  /// (p, v): p was discarded because it equals the vertex v.
  std::vector<std::pair<PointId, PointId>> repeats;
};

/// The hull of points that are centered at `simplex`, with side(simplex 0, 1, 2, 3) Negative.
/// @throws Error Stopped when options.stop becomes true.
/// @par Source  [ClarksonShor1989], [deBerg2008, sec. 11.2], [Barber1996] for furthest-first
template <ExactPoints Points>
TriangulatedHull triangulate(const Points& points, const std::array<PointId, 4>& simplex,
                             const HullOptions& options);

/// Maximal facets with extreme corners, and the certificate: merges coplanar triangles and leaves
/// out the vertices that are not extreme.
template <ExactPoints Points>
Hull merge_facets(const Points& points, TriangulatedHull surface,
                  const std::array<PointId, 4>& simplex);

}  // namespace convexact
