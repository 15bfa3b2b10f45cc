// SPDX-License-Identifier: MIT
// homogeneous_points.hpp - exact sides for rational points given by integers.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "convexact/hull.hpp"
#include "convexact/point_set.hpp"
#include "hull/exact_points.hpp"

namespace convexact {

/// ExactPoints over homogeneous integers; keeps a reference to them. Until center_at() the near
/// points are about the middle of the box and center_side() must not be called.
class HomogeneousPoints {
 public:
  /// @throws Error InvalidArgument if some w <= 0.
  explicit HomogeneousPoints(std::span<const HomogeneousPoint> points);
  /// The center becomes the centroid of four points that span a volume.
  void center_at(const std::array<PointId, 4>& simplex);

  std::size_t size() const { return points_.size(); }
  std::span<const NearPoint> near() const { return near_; }
  Sign side(PointId a, PointId b, PointId c, PointId p) const;
  Sign center_side(PointId a, PointId b, PointId p) const;
  bool equal(PointId p, PointId q) const;
  bool collinear(PointId a, PointId b, PointId c) const;
  RationalPoint rational(PointId p) const;

 private:
  const HomogeneousPoint& at(PointId p) const { return points_[p.index()]; }
  void compute_near(const RationalPoint& center);

  std::span<const HomogeneousPoint> points_;
  std::vector<NearPoint> near_;
  RationalPoint low_, high_;  // the box
  HomogeneousPoint center_;
};
static_assert(ExactPoints<HomogeneousPoints>);

/// Rationals as homogeneous points, w the least common denominator.
[[nodiscard]] HomogeneousPoint to_homogeneous(const RationalPoint& p);

}  // namespace convexact
