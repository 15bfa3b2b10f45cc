// SPDX-License-Identifier: MIT
// met_cell.hpp - a convex part in the doubles of a frame, and whether it meets a cell.
#pragma once
#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "convexact/overlay.hpp"
#include "hull/near_solid.hpp"
#include "near/near_plane.hpp"
#include "number/arithmetic.hpp"
#include "reach/reach_cells.hpp"

namespace convexact {

/// A part whose vertices are doubles of a frame, and its planes, if it has them: with normals of
/// length about 1.
class NearPart {
 public:
  /// The hull of some points, without planes.
  explicit NearPart(std::vector<Point> points) : vertices_(std::move(points)) {}
  NearPart(const ConvexPart& part, const NearFrame& frame)
      : vertices_(framed(part.vertices, frame)) {
    for (const Halfspace& h : part.halfspaces) {
      // n.x + d of x = c + 2^e y.
      const Rational at_center = h(frame.center);
      const DoubleHalfspace scaled(h);
      const Point normal(scaled.n[0], scaled.n[1], scaled.n[2]);
      const auto bits = static_cast<long>(bit_length(h.normal()));
      const double offset =
          to_double(scale_by_power_of_two(at_center, -bits - frame.exponent), Rounding::Nearest);
      planes_.push_back({normal / normal.norm(), offset / normal.norm()});
    }
  }

  explicit NearPart(NearSolid solid) : vertices_(std::move(solid.vertices)) {
    // All vertices are within a plane that is moved out by its error. Of a sliver, which may have
    // any normal, the plane is moved to the outermost.
    constexpr double kSmall = 0x1p-30;
    for (const auto& [normal, offset, error] : solid.planes) {
      double most = error - offset;
      if (error > kSmall) {
        most = normal.dot(vertices().front());
        for (const Point& v : vertices()) most = std::max(most, normal.dot(v));
      }
      planes_.push_back({normal, -most});
    }
  }

  std::span<const Point> vertices() const { return vertices_.points(); }
  /// Its hull, as near_hull() sees it.
  NearHull seen_from(const Point& y,
                     double enough = std::numeric_limits<double>::quiet_NaN()) const {
    return near_hull(vertices_, y, enough);
  }
  std::size_t planes() const { return planes_.size(); }

  /// Whether it is certain that a point is in the part, as planes tell that may run by it.
  bool holds(std::span<const std::uint32_t> planes, const Point& y) const {
    return !planes_.empty() && std::all_of(planes.begin(), planes.end(), [&](std::uint32_t k) {
      const auto& [normal, offset] = planes_[k];
      return normal.dot(y) + offset < -kReachError;
    });
  }

  /// How far a point is beyond a plane, up to kReachError.
  double beyond(std::uint32_t plane, const Point& y) const {
    return planes_[plane].normal.dot(y) + planes_[plane].offset;
  }
  /// A point inside of the part, unless that is flat or nearly so.
  Point middle() const {
    Point sum = Point::Zero();
    for (const Point& v : vertices()) sum += v;
    return sum / static_cast<double>(vertices().size());
  }
  /// With all points x moved to x + share (to - x), share < 1.
  NearPart towards(const Point& to, double share) const {
    std::vector<Point> points(vertices().begin(), vertices().end());
    for (Point& v : points) v += share * (to - v);
    NearPart moved(std::move(points));
    moved.planes_ = planes_;
    for (auto& [normal, offset] : moved.planes_) offset -= share * (normal.dot(to) + offset);
    return moved;
  }
  NearBox box() const {
    NearBox box;
    for (const Point& v : vertices()) box.include(v);
    return box;
  }

  /// How a plane of the part runs by a cell.
  enum class Side {
    Beyond,   ///< All of the cell is beyond the plane.
    Within,   ///< All of it is on the inner side.
    Crossing  ///< Or so near that it is not certain.
  };
  Side side(std::size_t plane, const CellPlace& place) const {
    const auto& [normal, offset] = planes_[plane];
    const double value = normal.dot(place.center) + offset;
    const double width = place.half * normal.lpNorm<1>() + kReachError;
    return value > width ? Side::Beyond : value < -width ? Side::Within : Side::Crossing;
  }

 private:
  struct Plane {
    Point normal;
    double offset;
  };
  static std::vector<Point> framed(std::span<const RationalPoint> points, const NearFrame& frame) {
    std::vector<Point> list;
    for (const RationalPoint& x : points) list.push_back(frame(x));
    return list;
  }

  HullPoints vertices_;
  std::vector<Plane> planes_;
};

/// A cell that a part may meet, and the planes of the part that may cross it.
struct MetCell {
  CellPlace place;
  std::vector<std::uint32_t> planes;

  /// Whether the planes leave it open that the part meets the half-sized cell `at`; `half` has the
  /// planes that cross that.
  bool may_meet(const NearPart& part, const CellPlace& at, MetCell& half) const {
    half.place = at;
    half.planes.clear();
    for (const std::uint32_t k : planes) {
      switch (part.side(k, at)) {
        case NearPart::Side::Beyond:
          return false;
        case NearPart::Side::Within:
          break;
        case NearPart::Side::Crossing:
          half.planes.push_back(k);
      }
    }
    return true;
  }
};

/// A part as the center of a cell sees it.
struct SeenPart {
  bool has_center = false;  ///< Whether it is certain that the part holds the center.
  bool is_apart = false;    ///< Or that it does not meet the ball around the cell.
  NearHull hull;            ///< Unless it has the center: seen from there, as far as the ball.
  Point nearest;            ///< A point of the part, up to rounding, about as near as any.
};

inline SeenPart seen_from(const MetCell& met, const NearPart& part) {
  const CellPlace& place = met.place;
  if (part.holds(met.planes, place.center)) return {true, false, {}, place.center};
  const NearHull hull = part.seen_from(place.center, place.radius() + kReachError);
  return {false, widened(hull.bounds, place.center).low > place.radius(), hull,
          place.center + hull.nearest};
}

}  // namespace convexact
