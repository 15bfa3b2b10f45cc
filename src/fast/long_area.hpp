// SPDX-License-Identifier: MIT
// long_area.hpp - what a removal adds to the area, in double-doubles: for costs that doubles do not
// tell apart, as those of points spread evenly over a sphere.
#pragma once
#include <span>
#include <vector>

#include "fast/dual.hpp"
#include "fast/metric_cost.hpp"
#include "fast/ring.hpp"
#include "fast/roof.hpp"

namespace convexact {

/// The sum of MetricCost for areas. Normals are computed as they are needed, which is seldom.
class LongArea {
 public:
  /// @param dual  Must outlive the object.
  explicit LongArea(const FastDual& dual) : dual_(dual) {}

  /// Bounds of twice the area that the cap of i adds. T is taken as it is.
  CostBounds<DoubleDouble> bounds(const RingGeometry<DoubleDouble>& geometry, HalfspaceId i,
                                  std::span<const HalfspaceId> ring,
                                  std::span<const RingTriangle> triangles);

 private:
  // As DualNormals has them. Without a direction where underflow would spoil it.
  struct Normal {
    bool is_known;
    Triple<DoubleDouble> direction;
    DoubleDouble length;
  };
  Normal normal(HalfspaceId i) const;

  const FastDual& dual_;
  Roof<IntervalDeterminants<DoubleDouble>> roof_;
  std::vector<Interval<DoubleDouble>> sides_;
};

}  // namespace convexact
