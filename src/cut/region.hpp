// SPDX-License-Identifier: MIT
// region.hpp - the convex region of a leaf: a box, cut by the planes on the way to it.
#pragma once
#include <span>
#include <utility>
#include <vector>

#include "cut/cut_points.hpp"

namespace convexact {

/// A bounded region with a volume. Its faces are polygons of corners, each in a plane.
class Region {
 public:
  struct Face {
    std::uint32_t plane;                 ///< Into the planes of the run.
    std::vector<std::uint32_t> corners;  ///< In order around the face.
  };

  /// @param faces  Of a convex solid; each edge is in two of them.
  explicit Region(std::vector<Face> faces) : faces_(std::move(faces)) {}

  std::span<const Face> faces() const { return faces_; }
  /// Ascending.
  std::vector<std::uint32_t> corners() const;
  /// A point in its interior, exactly.
  RationalPoint middle(std::span<const CutPlane> planes, const CutPoints& points) const;

  /// What lies below the plane (n.x + d <= 0) and above it. The plane runs through the interior.
  /// @param plane  Into `planes`.
  std::pair<Region, Region> cut(std::uint32_t plane, std::span<const CutPlane> planes,
                                CutPoints& points) const;

 private:
  std::vector<Face> faces_;
};

}  // namespace convexact
