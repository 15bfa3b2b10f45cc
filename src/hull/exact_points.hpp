// SPDX-License-Identifier: MIT
// exact_points.hpp - what the hull needs of its points: doubles near them, and exact signs.
#pragma once
#include <array>
#include <concepts>
#include <span>

#include "convexact/point_set.hpp"
#include "hull/near_geometry.hpp"

namespace convexact {

/// Points of which a hull can be built, in any representation. `near()` are their NearPoints about
/// a center that lies strictly inside the hull (near_geometry.hpp); the other members are exact:
///   side(a, b, c, p)       Positive if p is strictly beyond the plane of a, b, c, which look
///                          counter-clockwise from beyond; Zero on it.
///   center_side(a, b, p)   the sign of det[a-o; b-o; p-o] with the center o: Positive if o, a, b
///                          look counter-clockwise from p.
///   equal(p, q)            whether two points are the same.
template <class Points>
concept ExactPoints = requires(const Points& points, PointId p) {
  { points.near() } -> std::convertible_to<std::span<const NearPoint>>;
  { points.side(p, p, p, p) } -> std::same_as<Sign>;
  { points.center_side(p, p, p) } -> std::same_as<Sign>;
  { points.equal(p, p) } -> std::same_as<bool>;
};

/// The side of p from the plane of a triangle: by its near plane if that is certain, otherwise
/// exactly.
template <ExactPoints Points>
Sign side_of(const Points& points, const NearPlane& plane, const std::array<PointId, 3>& triangle,
             PointId p) {
  const double height = plane.height(points.near()[p.index()]);
  if (const auto sign = certain_sign(height, plane.bound)) return *sign;
  return points.side(triangle[0], triangle[1], triangle[2], p);
}

/// The same without a plane at hand.
template <ExactPoints Points>
Sign side_of(const Points& points, const std::array<PointId, 3>& triangle, PointId p) {
  const auto near = points.near();
  const NearPlane plane = NearPlane::through(near[triangle[0].index()], near[triangle[1].index()],
                                             near[triangle[2].index()]);
  return side_of(points, plane, triangle, p);
}

/// center_side(a, b, p), by doubles if these are certain. `normal` is cross(near a, near b).
template <ExactPoints Points>
Sign center_side_of(const Points& points, const NearPoint& normal, PointId a, PointId b,
                    PointId p) {
  const double value = dot(normal, points.near()[p.index()]);
  if (const auto sign = certain_sign(value, kCenterBound)) return *sign;
  return points.center_side(a, b, p);
}

template <ExactPoints Points>
Sign center_side_of(const Points& points, PointId a, PointId b, PointId p) {
  const auto near = points.near();
  return center_side_of(points, cross(near[a.index()], near[b.index()]), a, b, p);
}

}  // namespace convexact
