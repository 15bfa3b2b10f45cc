// SPDX-License-Identifier: MIT
// divide.hpp - divides a part by a plane through its notch: the planes, their order, and the
// triangles that are moved.
#pragma once
#include <optional>

#include "decompose/cluster_engines.hpp"
#include "decompose/notch.hpp"

namespace convexact {

/// The triangles that move as one: one with an area and those without that are attached to it; and
/// which units are neighbours.
class Units {
 public:
  Units(const Surface& surface, const ClusterStart& start);

  /// The lowest triangle of the unit of a triangle; it names the unit.
  std::uint32_t of(TriangleId triangle) const { return name_[triangle.index()]; }
  const std::vector<TriangleId>& triangles(std::uint32_t unit) const { return triangles_[unit]; }
  /// The triangle that decides on which side of a plane the unit is: the one with an area, if there
  /// is one.
  TriangleId shown(std::uint32_t unit) const { return shown_[unit]; }
  const std::vector<std::uint32_t>& beside(std::uint32_t unit) const { return beside_[unit]; }

 private:
  std::vector<std::uint32_t> name_;
  // By name; those of other triangles are not used.
  std::vector<std::vector<TriangleId>> triangles_;
  std::vector<TriangleId> shown_;
  std::vector<std::vector<std::uint32_t>> beside_;
};

/// A plane to split at, through an edge at a notch.
struct SplitPlane {
  PointId to;                         ///< The other end of the edge.
  std::vector<TriangleId> triangles;  ///< At the edge: two, or one at a border.
  Halfspace plane;
  bool is_convex = true;  ///< Whether the surface is not concave at the edge.
  Rational cosine = 1;    ///< Of the normals there: d |d| for d = n1.n2.
};

/// The planes at a notch, in the order in which they are tried. For each two triangles at an edge,
/// with unit normals n1 and n2 and d = n1.n2, the plane through the edge and n1 + n2, or
/// |d| n1 + (1 - |d|) n2 if |d| < 1/5. First the edges where the surface is concave, then the
/// others, both by ascending d. If all edges at the notch are borders, the plane through the lowest
/// one and the normal of its triangle.
/// @par Source  [Backenhof2011]; unit normals are rounded to multiples of 2^-20.
[[nodiscard]] std::vector<SplitPlane> split_planes(const Surface& surface, const Patch& patch,
                                                   PointId notch);

struct Division {
  std::vector<TriangleId> kept, moved, islands;  ///< Ascending.
};

/// Moves the triangles beyond a plane that are reached from the notch over others beyond it. Of the
/// rest, the triangles connected to one at the notch are kept; the islands are moved, too. So both
/// halves are connected. A triangle is beyond the plane if its centroid is.
/// @return Nothing if one half would have no triangle at the notch.
[[nodiscard]] std::optional<Division> divide(const Surface& surface, const Units& units,
                                             const Patch& patch, PointId notch,
                                             const SplitPlane& plane, const NearSurface& near);

}  // namespace convexact
