// SPDX-License-Identifier: MIT
// exact_points.hpp - the points as the hull needs them: doubles near them, and exact signs; for
// points whose coordinates are doubles, and for rational points given by integers.
#pragma once
#include <array>
#include <concepts>
#include <optional>
#include <span>
#include <vector>

#include "convexact/geometry.hpp"
#include "convexact/hull.hpp"
#include "near/near_geometry.hpp"

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

/// The side of a triangle's plane on which p lies: by its near plane if that is certain, otherwise
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

/// center_side(a, b, p), in doubles if these are certain. `normal` is cross(near a, near b).
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

/// Whether three points lie on a line, in doubles if these are certain that they do not: the bound
/// of a plane's heights includes six times the error of a component of its normal.
template <ExactPoints Points>
bool are_collinear(const Points& points, PointId a, PointId b, PointId c) {
  const auto near = points.near();
  const NearPlane plane = NearPlane::through(near[a.index()], near[b.index()], near[c.index()]);
  const auto& [x, y, z] = plane.normal;
  return std::max({std::abs(x), std::abs(y), std::abs(z)}) <= plane.bound &&
         points.collinear(a, b, c);
}

/// ExactPoints over finite doubles; keeps a reference to them. Until center_at() the near points
/// are about a double near the middle of the box and center_side() must not be called.
class DoublePoints {
 public:
  /// Whether several threads may ask for signs at the same time.
  static constexpr bool kForThreads = true;

  explicit DoublePoints(std::span<const Point> points);
  /// The center becomes the centroid of four points that span a volume. It is computed in doubles
  /// if the result is strictly inside of them: signs about such a center are those of orient3d().
  void center_at(const std::array<PointId, 4>& simplex);
  RationalPoint center() const { return double_center_ ? to_rational(*double_center_) : center_; }

  std::size_t size() const { return points_.size(); }
  std::span<const NearPoint> near() const { return near_; }
  Sign side(PointId a, PointId b, PointId c, PointId p) const;
  Sign center_side(PointId a, PointId b, PointId p) const;
  bool equal(PointId p, PointId q) const { return at(p) == at(q); }
  bool collinear(PointId a, PointId b, PointId c) const;
  RationalPoint rational(PointId p) const { return to_rational(at(p)); }

 private:
  const Point& at(PointId p) const { return points_[p.index()]; }
  void compute_near();

  std::span<const Point> points_;
  std::vector<NearPoint> near_;
  Point low_ = Point::Zero(), high_ = Point::Zero();  // the box
  std::optional<Point> double_center_;                // the center, if its coordinates are doubles,
  RationalPoint center_;                              // and else this
};
static_assert(ExactPoints<DoublePoints>);

/// ExactPoints over fractions, as homogeneous integers or as a set, to which a reference is kept.
/// Until center_at() the near points are about the middle of the box and center_side() must not be
/// called.
class HomogeneousPoints {
 public:
  static constexpr bool kForThreads = false;  // integers are kept as they are needed

  /// @throws Error InvalidArgument if some w <= 0.
  explicit HomogeneousPoints(std::span<const HomogeneousPoint> points);
  /// Integers are computed for the points that a sign needs. Precondition: it is not binary.
  explicit HomogeneousPoints(const PointSet& points);
  /// The center becomes the centroid of four points that span a volume.
  void center_at(const std::array<PointId, 4>& simplex);
  RationalPoint center() const {
    return {Rational(center_.n[0], center_.w), Rational(center_.n[1], center_.w),
            Rational(center_.n[2], center_.w)};
  }

  std::size_t size() const { return near_.size(); }
  std::span<const NearPoint> near() const { return near_; }
  Sign side(PointId a, PointId b, PointId c, PointId p) const;
  Sign center_side(PointId a, PointId b, PointId p) const;
  bool equal(PointId p, PointId q) const;
  bool collinear(PointId a, PointId b, PointId c) const;
  RationalPoint rational(PointId p) const;

 private:
  const HomogeneousPoint& at(PointId p) const;
  void find_box();
  void compute_near(const RationalPoint& center);
  [[nodiscard]] bool compute_near_in_doubles(int axis, const Rational& center);

  std::span<const HomogeneousPoint> points_;
  const PointSet* set_ = nullptr;                                // or these,
  mutable std::vector<std::optional<HomogeneousPoint>> of_set_;  // as far as they were needed
  std::vector<NearPoint> near_;
  RationalPoint low_, high_;  // the box
  HomogeneousPoint center_;
};
static_assert(ExactPoints<HomogeneousPoints>);

}  // namespace convexact
