// SPDX-License-Identifier: MIT
// second_way.hpp - the second of the two ways to containment: for a mesh the one triangle in whose
// cone a point lies, for halfspaces a linear program for each plane.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "convexact/geometry.hpp"
#include "convexact/hull.hpp"

namespace convexact::oracle {

/// Walks over the triangles of a hull to the one that the ray from an interior point o through a
/// point p meets. Every sign is one of orient3d; no plane of a facet is computed.
///
/// From triangle f the walk crosses an edge that has p strictly on its other side, as seen from o.
/// With planes n_f.(x - o) = h_f, h_f > 0, of f and g on both sides of the edge, that is where
/// n_g.(p - o) / h_g is larger than n_f.(p - o) / h_f: the walk is the simplex method on the polar
/// of the hull. So it never comes back, and the cone of o over the triangle where it ends holds p.
/// Then p is outside if and only if it lies strictly beyond that triangle.
/// @par Source  [Mehlhorn1999, sec. 2.3] for the cones, [Schrijver1986, ch. 11] for the walk.
class ConeLocation {
 public:
  /// @param points  Those to be located. @par Cost  O(T log T) for T triangles.
  ConeLocation(const Hull& hull, const PointSet& mesh, const PointSet& points);

  /// The triangle whose cone holds a point. @param start  Any triangle; a nearer one makes the walk
  /// shorter.
  [[nodiscard]] std::uint32_t locate(std::size_t point, std::uint32_t start) const;
  /// Whether a point lies strictly beyond the triangle that locate() found for it.
  [[nodiscard]] bool is_outside(std::size_t point, std::uint32_t triangle) const;

 private:
  struct Triangle {
    std::array<std::uint32_t, 3> corners;    // counter-clockwise from outside
    std::array<std::uint32_t, 3> neighbors;  // across the edge from corner k to the next one
  };

  void add_triangles(const FacetList& facets);
  void join_neighbors();
  bool is_center_inside(const std::array<PointId, 4>& simplex) const;
  bool is_beyond(std::size_t a, std::size_t b, std::size_t c, std::size_t p) const;

  std::vector<Triangle> triangles_;
  PointSet all_;  // those of the mesh, then those to be located, then o
  std::size_t first_point_, center_;
};

/// Maximises linear functionals over a polytope, given by its facets, by the simplex method: from
/// vertex to better neighbour, in doubles while these are certain, then exactly. The vertex where
/// it ends is proven optimal by duality: the functional is a nonnegative combination of the normals
/// of three facets there.
/// @par Source  [Schrijver1986, ch. 11 and cor. 7.1g]
class SupportProgram {
 public:
  /// Keeps a reference. @par Cost  O(E log E).
  explicit SupportProgram(const Polytope& polytope);

  /// max n.x over the polytope; n nonzero.
  /// @par Cost  A product in doubles for each neighbour on the way from the optimum of the last
  ///            call, then as many 3x3 determinants as facets meet in the vertex.
  [[nodiscard]] Rational maximum(const IntegerVector3& n);

 private:
  std::uint32_t climb_in_doubles(const Vector3<double>& direction) const;
  std::uint32_t better_neighbor(std::uint32_t vertex, const RationalVector3& n) const;
  bool is_optimal(std::size_t vertex, const IntegerVector3& n) const;

  const Polytope& polytope_;
  std::vector<Vector3<double>> near_;                  // the vertices, rounded
  std::vector<std::vector<std::uint32_t>> around_;     // facets at each vertex, counter-clockwise
  std::vector<std::vector<std::uint32_t>> neighbors_;  // vertices an edge away
  std::uint32_t last_ = 0;                             // the optimum that was found last
};

}  // namespace convexact::oracle
