// SPDX-License-Identifier: MIT
// mass_sum.hpp - mass properties as sums over a boundary: of the cones from one point over
// triangles of it. With corners a, b, c as seen from the point, a cone has the volume V = det(a, b,
// c) / 6, the first moment V (a + b + c) / 4, and the second moment V (a a' + b b' + c c' + s s') /
// 20, s = a + b + c.
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "convexact/measure.hpp"

namespace convexact {

class MassSum {
 public:
  /// @param origin  The point of the cones: any, but one in the middle keeps numbers short.
  explicit MassSum(RationalPoint origin) : origin_(std::move(origin)) {}

  /// A triangle of the boundary, counter-clockwise as seen from outside.
  void add(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c);

  /// Nothing if all cones together have no volume. To be called once.
  std::optional<MassProperties> total();

 private:
  RationalPoint origin_;
  std::vector<Rational> volumes_;
  std::array<std::vector<Rational>, 3> first_;
  std::array<std::vector<Rational>, 6> second_;
};

}  // namespace convexact
