// SPDX-License-Identifier: MIT
// long_metric.hpp - what a removal adds to the area or the mean width, in double-doubles: for costs
// that doubles do not tell apart, as those of points spread evenly over a sphere.
#pragma once
#include <span>
#include <vector>

#include "fast/dual.hpp"
#include "fast/metric_cost.hpp"
#include "fast/ring.hpp"
#include "fast/roof.hpp"

namespace convexact {

/// The sums of MetricCost. Normals are computed as they are needed, which is seldom.
class LongMetric {
 public:
  /// Of Area or MeanWidth. @param dual  Must outlive the object.
  LongMetric(const FastDual& dual, CostMeasure measure) : dual_(dual), measure_(measure) {}

  /// Bounds of twice the area, or of 4 pi times the mean width, that the cap of i adds. T is taken
  /// as it is. Doubtful where angular_excess() has no bound.
  CostBounds<DoubleDouble> bounds(const RingGeometry<DoubleDouble>& geometry, HalfspaceId i,
                                  std::span<const HalfspaceId> ring,
                                  std::span<const RingTriangle> triangles);

 private:
  using Determinants = IntervalDeterminants<DoubleDouble>;
  using Number = Interval<DoubleDouble>;
  // As DualNormals has them. Without a direction where underflow would spoil it.
  struct Normal {
    bool is_known;
    Triple<DoubleDouble> direction;
    DoubleDouble length;
  };
  struct Side {
    Normal normal;
    Triple<DoubleDouble> from_i;  // to this direction
  };
  Normal normal(HalfspaceId i) const;
  bool load(HalfspaceId i, std::span<const HalfspaceId> ring);
  Number area(std::span<const RingTriangle> triangles, Determinants& determinants);
  Number mean_width(std::span<const RingTriangle> triangles, Determinants& determinants);

  const FastDual& dual_;
  const CostMeasure measure_;
  Roof<Determinants> roof_;
  std::vector<Side> ring_;
  std::vector<Number> sides_;
};

}  // namespace convexact
