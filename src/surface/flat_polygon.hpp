// SPDX-License-Identifier: MIT
// flat_polygon.hpp - a polygon of a mesh as triangles.
#pragma once
#include <array>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "convexact/geometry.hpp"

namespace convexact {

/// Points of a set, two of three coordinates of them, and the sign of a triangle's area.
class PlaneView {
 public:
  /// Drops the coordinate `axis`; the other two keep their cyclic order.
  PlaneView(const PointSet& points, int axis)
      : points_(points), u_((axis + 1) % 3), v_((axis + 2) % 3) {}

  /// Positive if a, b, c turn to the left, exactly.
  Sign turn(PointId a, PointId b, PointId c) const;
  /// Whether the segments ab and cd have a common point; each may be a point.
  bool meet(PointId a, PointId b, PointId c, PointId d) const;
  /// Whether p lies in the triangle, its boundary included. Precondition: it has an area.
  bool is_in(const std::array<PointId, 3>& triangle, PointId p) const;

 private:
  // Whether a coordinate of p is less, or more, than all of the triangle's.
  bool is_beside(int axis, const std::array<PointId, 3>& triangle, PointId p) const;
  bool overlap(int axis, PointId a, PointId b, PointId c, PointId d) const;

  const PointSet& points_;
  int u_, v_;
};

using Triangle = std::array<PointId, 3>;

/// Why a polygon is not cut.
enum class NotCut {
  Bent,     ///< Its corners are not in one plane.
  Crossed,  ///< Its boundary crosses itself, or bounds nothing.
};

/// The triangles of a planar polygon by ear clipping: all turn as the polygon does, none lacks an
/// area, and they use each of its edges. Its boundary meets itself at repeated corners and along
/// edges that it runs both ways only, and winds once about each point inside: a simple polygon, or
/// one with holes whose loop goes to each hole and back. The triangles of a simple polygon depend
/// neither on the first corner nor on the direction.
/// @param points   In lexicographic order, as in a surface.
/// @param corners  At least 4 ids, no two in a row the same.
/// @par Cost       n^2 for n corners, in fractions if some repeat.
[[nodiscard]] std::variant<std::vector<Triangle>, NotCut> clip_ears(
    const PointSet& points, std::span<const PointId> corners);

/// Whether the corners lie on a line.
[[nodiscard]] bool has_no_area(const PointSet& points, const Triangle& triangle);
/// An axis along which the triangle is seen with an area. Precondition: it has one.
[[nodiscard]] int seen_along(const PointSet& points, const Triangle& triangle);

/// (b - a) x (c - a), exactly.
[[nodiscard]] RationalVector3 area_vector(const PointSet& points, const Triangle& triangle);

}  // namespace convexact
