// SPDX-License-Identifier: MIT
// double_points.hpp - exact sides for points whose coordinates are doubles.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "convexact/point_set.hpp"
#include "hull/exact_points.hpp"

namespace convexact {

/// ExactPoints over finite doubles; keeps a reference to them. Until center_at() the near points
/// are about the middle of the box and center_side() must not be called.
class DoublePoints {
 public:
  explicit DoublePoints(std::span<const Point> points);
  /// The center becomes the centroid of four points that span a volume.
  void center_at(const std::array<PointId, 4>& simplex);

  std::size_t size() const { return points_.size(); }
  std::span<const NearPoint> near() const { return near_; }
  Sign side(PointId a, PointId b, PointId c, PointId p) const;
  Sign center_side(PointId a, PointId b, PointId p) const;
  bool equal(PointId p, PointId q) const { return at(p) == at(q); }
  bool collinear(PointId a, PointId b, PointId c) const;
  RationalPoint rational(PointId p) const { return to_rational(at(p)); }

 private:
  const Point& at(PointId p) const { return points_[p.index()]; }
  void compute_near(const RationalPoint& center);

  std::span<const Point> points_;
  std::vector<NearPoint> near_;
  Point low_ = Point::Zero(), high_ = Point::Zero();  // the box
  RationalPoint center_;
};
static_assert(ExactPoints<DoublePoints>);

}  // namespace convexact
