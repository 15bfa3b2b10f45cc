// SPDX-License-Identifier: MIT
// frame.hpp - the positions at which a lesson draws points, planes and dual points.
#pragma once
#include <array>
#include <span>

#include "convexact/dual.hpp"
#include "convexact/geometry.hpp"
#include "io/json_document.hpp"

namespace convexact {

/// Moves the center of the dual to the origin and scales each axis by a power of two, so that the
/// solid fits in about [-1, 1]. Everything is exact except the last step: a drawn number is a
/// double of nine digits, and finite.
class LessonFrame {
 public:
  /// One scale for all axes, unless the solid is sixteen times longer along one than another.
  LessonFrame(std::span<const RationalPoint> vertices, const RationalPoint& center);

  const RationalPoint& center() const { return center_; }

  /// A point as it is drawn.
  Json at(const RationalPoint& point) const;
  /// {"exact", "at"}.
  Json both(const RationalPoint& point) const;
  /// The drawn plane's n1, n2, n3, d, its largest |n_k| in [1/2, 1].
  Json plane(const Halfspace& halfspace) const;
  /// The polar of the drawn plane. @param dual  From any center.
  Json dual(const DualPoint& dual) const;
  /// {"center", "scale"}.
  Json json() const;

 private:
  RationalPoint center_;
  std::array<long, 3> exponent_;  // an axis is multiplied by 2^-exponent
};

}  // namespace convexact
