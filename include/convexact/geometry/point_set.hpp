// SPDX-License-Identifier: MIT
// point_set.hpp - the input points: doubles, or rationals where decimals are taken as spelled.
#pragma once
#include <span>
#include <vector>

#include "convexact/geometry/ids.hpp"
#include "convexact/number/rational.hpp"

namespace convexact {

using Point = Vector3<double>;  ///< Finite coordinates in the caller's length unit.
using RationalPoint = RationalVector3;

/// Finite points, repeats allowed. Either every coordinate is a double (then `is_binary()`), or
/// all of them are kept as rationals as well.
class PointSet {
 public:
  PointSet() = default;
  /// @throws Error NotFinite, naming the first such point, if a coordinate is NaN or infinite.
  explicit PointSet(std::vector<Point> points);
  /// Rationals; those that all happen to be doubles become a binary set.
  explicit PointSet(std::vector<RationalPoint> points);

  std::size_t size() const { return points_.size(); }
  bool is_binary() const { return rationals_.empty(); }
  /// The doubles: exact if is_binary(), else each rational rounded to nearest.
  std::span<const Point> doubles() const { return points_; }
  /// The point itself, exactly.
  RationalPoint operator[](PointId id) const;

 private:
  std::vector<Point> points_;
  std::vector<RationalPoint> rationals_;  // empty, or as long as points_
};

}  // namespace convexact
