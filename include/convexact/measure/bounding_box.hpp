// SPDX-License-Identifier: MIT
// bounding_box.hpp - the axis-aligned box of points, and the diameter that tolerances refer to.
#pragma once
#include <span>

#include "convexact/geometry/point_set.hpp"

namespace convexact {

/// low <= x <= high in each coordinate; exact.
struct BoundingBox {
  RationalPoint low, high;

  RationalVector3 size() const { return high - low; }
  /// Square of the diagonal: what the project calls the diameter of an input.
  Rational squared_diameter() const { return size().squaredNorm(); }
};

/// The smallest box around n >= 1 points. @throws Error InvalidArgument if there is none.
[[nodiscard]] BoundingBox bounding_box(std::span<const RationalPoint> points);
[[nodiscard]] BoundingBox bounding_box(const PointSet& points);

}  // namespace convexact
