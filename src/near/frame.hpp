// SPDX-License-Identifier: MIT
// frame.hpp - a frame around shapes, in which doubles are as fine as the shapes need.
#pragma once
#include <span>
#include <vector>

#include "convexact/geometry.hpp"

namespace convexact {

/// x = center + 2^exponent y: a frame in which doubles are as fine as the shapes need. The shapes
/// that a frame was made for have |y_k| < 1.
struct NearFrame {
  RationalPoint center;
  long exponent = 0;

  /// Each coordinate rounded to nearest; infinite if it is too far away.
  Point operator()(const RationalPoint& x) const;
  /// The same of each point of a set; of doubles without exact numbers.
  std::vector<Point> operator()(const PointSet& points) const;
  /// Exactly; `y` finite.
  RationalPoint point(const Point& y) const;
  /// A length of the frame in length units, exactly.
  Rational length(double y) const;
  /// Bounds in the frame of the root of a square of a length.
  double root_down(const Rational& squared) const;
  double root_up(const Rational& squared) const;
};

/// The frame of the shapes in these boxes, at least one.
[[nodiscard]] NearFrame frame_around(std::span<const BoundingBox> boxes);

}  // namespace convexact
