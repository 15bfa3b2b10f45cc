// SPDX-License-Identifier: MIT
// union_distance_near.hpp - bounds of distances in doubles: to the convex hull of a few points, to
// convex parts, and to triangles. Each bound is proven; exact numbers decide the rest.
#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "convexact/geometry.hpp"
#include "convexact/overlay.hpp"
#include "near/frame.hpp"
#include "surface/box_tree.hpp"

namespace convexact {

/// low <= distance <= high.
struct NearBounds {
  double low = 0;
  double high = std::numeric_limits<double>::infinity();
};

/// The error that rounding adds to the bounds of distances of a point y of a frame to a shape in
/// it, as a multiple of max(1, |y_k|). With u = 2^-53:
/// - Rounding to the frame moves a coordinate below 1 by u/2 at most, so vertices and with them
///   their hull by less than u, and the point by less than u max(1, |y_k|).
/// - Differences w = v - y have |w| <= 2 sqrt(3) max(1, |y_k|) = W and an error of u W. A
///   combination of them with factors >= 0 whose sum is 1 up to 4u has an error of 9u W; its length
///   another 3u W.
/// - For any q the distance is at least the minimum of q.w / |q| over the vertices: the dot product
///   has an error of 4u |q| W, the quotient one of 4u W.
/// Together less than 24u W < 84u; 2^-46 is 128u. Bounds are not taken from squares that might
/// underflow.
inline constexpr double kDistanceError = 0x1p-46;

/// At least one point, whose hull may be seen from many places: neighbours in the list are in
/// boxes, most of which need no look for the point that is farthest along a direction.
class HullPoints {
 public:
  explicit HullPoints(std::vector<Point> points);
  std::span<const Point> points() const { return points_; }
  /// The one where q.(x - y) is least, and that least value; of several the first, as in doubles.
  std::pair<std::size_t, double> least_along(const Point& q, const Point& y) const;

 private:
  std::vector<Point> points_;
  std::vector<NearBox> boxes_;  // of 32 neighbours each; none if there are few points
};

/// A distance between a point of a frame and the hull of some of its points, without
/// kDistanceError.
struct NearHull {
  NearBounds bounds;
  Point nearest;                  ///< The nearest point found, less y.
  Point towards = Point::Zero();  ///< All of the hull is bounds.low or more from y along this.
};

/// The distance to the hull of at least one point, seen from y.
/// @param enough  Ends as soon as the distance is known to be above this, or not: whether the hull
///                meets a ball needs no more. NaN: never.
/// @par Source  [Gilbert1988]: a simplex of vertices whose nearest point to y is replaced by that
///              of the simplex and the vertex beyond, until there is none.
[[nodiscard]] NearHull near_hull(std::span<const Point> points, const Point& y,
                                 double enough = std::numeric_limits<double>::quiet_NaN());
[[nodiscard]] NearHull near_hull(const HullPoints& points, const Point& y,
                                 double enough = std::numeric_limits<double>::quiet_NaN());

/// The same for a triangle, which may be degenerate.
[[nodiscard]] NearHull near_triangle(const std::array<Point, 3>& corners, const Point& y);

/// Widens by the error of rounding at y.
[[nodiscard]] NearBounds widened(const NearBounds& bounds, const Point& y);

/// Bounds of distances to parts.
class NearParts {
 public:
  NearParts(std::span<const ConvexPart> parts, const NearFrame& frame);

  std::size_t size() const { return boxes_.size(); }
  const NearFrame& frame() const { return frame_; }

  /// At most the distance of y to the part, by its box alone.
  double box_distance(std::size_t part, const Point& y) const;
  NearBounds to_part(std::size_t part, const Point& y) const;
  /// To the nearest of all parts.
  NearBounds to_union(const Point& y) const;
  /// The parts that may be nearest to y, ascending.
  std::vector<std::uint32_t> candidates(const Point& y) const;
  /// The parts that may be nearest to a point at most `radius` from y, ascending.
  std::vector<std::uint32_t> candidates(const Point& y, double radius) const;

 private:
  std::span<const Point> vertices(std::size_t part) const;

  NearFrame frame_;
  std::vector<Point> vertices_;
  std::vector<std::size_t> starts_{0};  // of each part in vertices_
  std::vector<NearBox> boxes_;
};

}  // namespace convexact
