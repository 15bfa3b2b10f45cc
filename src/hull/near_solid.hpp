// SPDX-License-Identifier: MIT
// near_solid.hpp - the hull of points as doubles: its vertices, planes that hold them, its volume.
#pragma once
#include <span>
#include <vector>

#include "convexact/geometry.hpp"

namespace convexact {

/// The hull of the doubles themselves; what is said of it holds for these, up to rounding.
struct NearSolid {
  /// n.y + d <= 0, |n| = 1 up to roundings.
  struct Plane {
    Point normal;
    double offset;
    /// No vertex is farther beyond the plane, if coordinates are at most 2; of slivers it is large.
    double error;
  };
  std::vector<Point> vertices;  ///< Of the hull; all points if they are flat.
  /// Of its facets. None if the points are flat.
  std::vector<Plane> planes;
  double volume = 0;
};

/// @param points  Finite. None are flat.
[[nodiscard]] NearSolid near_solid(std::span<const Point> points);

}  // namespace convexact
