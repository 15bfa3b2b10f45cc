// SPDX-License-Identifier: MIT
// bridges.hpp - the hull of a part as bridges over it, and the points of the part under each
// bridge: hull edges between bridges become shortest paths along the mesh.
#pragma once
#include "convexact/cluster.hpp"
#include "convexact/hull.hpp"
#include "decompose/patch.hpp"

namespace convexact {

/// The hull of a patch, its ids those of the surface.
struct PatchHull {
  std::vector<PointId> corners;            ///< Ascending.
  std::vector<Association::Facet> facets;  ///< In ascending order; none if the hull is flat.
  std::vector<Halfspace> planes;           ///< By facet.
};

[[nodiscard]] PatchHull hull_of(const Surface& surface, const Patch& patch, const Watch& watch);

/// Whether the cosine of the angle between two vectors is larger than a number >= 0, exactly.
[[nodiscard]] bool is_cosine_above(const IntegerVector3& a, const IntegerVector3& b,
                                   const Rational& cosine);

/// Projects the edges of a hull that has an interior.
/// @param options  Only `bridge` and `coplanar` count.
[[nodiscard]] Association associate(const Surface& surface, const Patch& patch,
                                    const PatchHull& hull, const NearSurface& near,
                                    const SplitOptions& options);

/// Shortest paths along the edges of a patch: exact, and among several of the same length the one
/// that, followed back from its end, has the lowest points.
/// @par Source  [Hart1968]: Dijkstra's search, those points first that are nearest to the end.
class ShortestPaths {
 public:
  /// Keeps a reference. @param near  The points of the surface in the frame of the lengths.
  ShortestPaths(const Patch& patch, std::span<const Point> near);

  /// @param from, to  Numbers of points.
  /// @return The numbers of the points, both ends included; empty if there is no path.
  std::vector<std::uint32_t> operator()(std::uint32_t from, std::uint32_t to);

 private:
  std::uint64_t& distance(std::uint32_t point);
  std::uint64_t at_least(std::uint32_t from, std::uint32_t to) const;

  const Patch& patch_;
  std::vector<Point> near_;               // by number
  std::vector<std::uint64_t> distances_;  // of points that the current search has seen
  std::vector<std::uint32_t> search_;     // by number: the last search that has seen it
  std::uint32_t current_ = 0;
};

/// Whether the edge of a hull from a to b spans a hole: some border of the patch leads from a to b
/// on the left of it and leaves b to the right, seen from outside.
/// @param normals  The normals of the two facets at the edge.
[[nodiscard]] bool spans_hole(const Surface& surface, const Patch& patch, std::uint32_t a,
                              std::uint32_t b, const std::array<IntegerVector3, 2>& normals);

}  // namespace convexact
