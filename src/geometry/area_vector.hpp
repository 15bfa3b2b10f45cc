// SPDX-License-Identifier: MIT
// area_vector.hpp - the vector (b - a) x (c - a) of three points, exactly: normal to their plane,
// as long as twice the area of their triangle. Of doubles it is made of integers, an order of
// magnitude faster.
#pragma once
#include <cstdint>
#include <span>

#include "convexact/geometry.hpp"

namespace convexact {

/// n 2^(2 exponent).
struct ScaledNormal {
  IntegerVector3 n;
  int exponent;  ///< All coordinates of the three points are integers times 2^exponent.
};

/// (b - a) x (c - a) of finite doubles.
[[nodiscard]] ScaledNormal scaled_normal(const Point& a, const Point& b, const Point& c);

/// p 2^-exponent. Precondition: these are integers.
[[nodiscard]] IntegerVector3 scaled_to_integer(const Point& p, int exponent);

/// (b - a) x (c - a), exactly.
[[nodiscard]] RationalVector3 area_vector(const PointSet& points, PointId a, PointId b, PointId c);

/// The sum of the cross products around a polygon: normal to its plane if it has one, as long as
/// twice its area, and pointing to where the corners look counter-clockwise. Zero for fewer than
/// three corners.
[[nodiscard]] RationalVector3 area_vector(const PointSet& points,
                                          std::span<const std::uint32_t> corners);

}  // namespace convexact
