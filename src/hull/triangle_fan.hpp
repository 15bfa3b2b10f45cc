// SPDX-License-Identifier: MIT
// triangle_fan.hpp - the triangles that join a new hull vertex to its horizon, and which of
// them a ray from the center meets.
#pragma once
#include <span>
#include <vector>

#include "hull/exact_points.hpp"

namespace convexact {

/// Triangle i of the fan is (rim[i], rim[i+1], apex), counter-clockwise from outside, and the
/// center lies strictly below all of them; so around the axis from the center to the apex the
/// rim turns once, by less than pi at each step.
template <ExactPoints Points>
class TriangleFan {
 public:
  explicit TriangleFan(const Points& points) : points_(points) {}

  /// Starts a new fan; keeps the memory of the old one.
  void assign(PointId apex, std::span<const PointId> rim) {
    apex_ = apex;
    rim_ = rim;
    normals_.clear();
    const auto near = points_.near();
    for (const PointId p : rim) normals_.push_back(cross(near[apex.index()], near[p.index()]));
    split_ = 1;  // the first step turns by less than pi
    std::size_t end = rim.size();
    while (end - split_ > 1) {
      const std::size_t middle = (split_ + end) / 2;
      (side(0, rim[middle]) != Sign::Negative ? split_ : end) = middle;
    }
  }

  /// A triangle whose cone from the center holds p, if any does. At most 2 + log2(rim) signs.
  std::size_t locate(PointId p) const {
    // Let f be the angle of p about the axis and t[i] that of rim[i], both in [0, 2 pi) from
    // t[0] = 0. Wanted is the last i with t[i] <= f. side(i, p) tells the sign of sin(f - t[i]),
    // which is that of f - t[i] while both lie in the same half [0, pi] or [pi, 2 pi).
    const Sign first = side(0, p);
    if (first == Sign::Zero && side(1, p) != Sign::Positive) return 0;  // f = 0, or on the axis
    // f in (0, pi]: i <= split, the last with t[i] <= pi. f in (pi, 2 pi): i >= split.
    std::size_t low = first == Sign::Negative ? split_ : 0;
    std::size_t end = first == Sign::Negative ? rim_.size() : split_ + 1;
    while (end - low > 1) {
      const std::size_t middle = (low + end) / 2;
      (side(middle, p) != Sign::Negative ? low : end) = middle;
    }
    return low;
  }

 private:
  // The side of the half plane from the axis through rim[i] on which p lies; Positive is ahead.
  Sign side(std::size_t i, PointId p) const {
    return center_side_of(points_, normals_[i], apex_, rim_[i], p);
  }

  const Points& points_;
  PointId apex_;
  std::span<const PointId> rim_;
  std::vector<NearPoint> normals_;  // cross(apex, rim[i])
  std::size_t split_ = 0;           // the last rim vertex with an angle of at most pi
};

}  // namespace convexact
