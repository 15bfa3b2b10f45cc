// SPDX-License-Identifier: MIT
// near_shapes.hpp - perimeters and areas of clusters in doubles, each with the bound of its error.
#pragma once
#include <cmath>
#include <span>
#include <vector>

#include "decompose/merge_cost.hpp"
#include "decompose/near_concavity.hpp"
#include "number/roundoff.hpp"

namespace convexact {

/// A sum of lengths or areas of scaled points, and a bound of its error.
struct NearSum {
  double value = 0, error = 0;

  NearSum& operator+=(const NearSum& other) {
    value += other.value;
    error += other.error + kUnitRoundoff * std::abs(value);
    return *this;
  }
  NearSum operator*(double power_of_two) const {
    return {value * power_of_two, error * std::abs(power_of_two)};
  }
  double low() const { return std::max(0.0, value - error); }
  double high() const { return value + error; }
};

/// What the second term of a merge's cost depends on, for one cluster.
struct NearShape {
  std::vector<std::uint32_t> boundary;  ///< Edges that an odd number of the triangles have;
                                        ///< ascending.
  NearSum perimeter, doubled_area;
};

/// The shapes of clusters of a surface, and weight / 20 pi times perimeter^2 / doubled area of
/// their unions, which CostOrder adds to the concavity. All lengths are in the units of `near`.
class NearShapes {
 public:
  /// @param is_float  Without bounds of errors.
  NearShapes(const Surface& surface, const NearConcavity& near, const Rational& squared_weight,
             bool is_float);

  [[nodiscard]] NearShape shape(std::span<const TriangleId> triangles) const;
  [[nodiscard]] NearShape unite(const NearShape& a, const NearShape& b) const;

  /// Of the union of two disjoint clusters. Linear in the sizes of their boundaries.
  [[nodiscard]] LengthBounds term(const NearShape& a, const NearShape& b) const;

  /// The exact perimeter and doubled area of that union, of these triangles. Each root is computed
  /// once.
  void set_exact(MergeCost& cost, const NearShape& a, const NearShape& b,
                 std::span<const TriangleId> triangles);

 private:
  struct Edge {
    PointId low, high;
    NearSum length;
  };

  double error(double rounding) const;
  NearSum doubled_area(TriangleId t) const;
  NearSum perimeter(std::span<const std::uint32_t> boundary) const;

  const Surface& surface_;
  std::span<const Point> points_;
  double off_;
  bool is_float_;
  LengthBounds weight_;
  std::vector<Edge> edges_;
  std::vector<std::vector<std::uint32_t>> edges_of_;      // by triangle
  std::vector<std::optional<RootTerm>> areas_, lengths_;  // exact; by triangle, by edge
};

}  // namespace convexact
