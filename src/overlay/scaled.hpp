// SPDX-License-Identifier: MIT
// scaled.hpp - points and planes of a scene in doubles, all coordinates at most 1 in size after
// one common scaling, and the exact sides of planes on which points lie.
#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "convexact/overlay.hpp"
#include "number/arithmetic.hpp"
#include "overlay/arrangement.hpp"
#include "surface/box_tree.hpp"
#include "task/lazy.hpp"

namespace convexact {

/// A halfspace whose plane holds p and q, and is parallel to the axis along which the normal is
/// longest. Seen from the side to which the normal points, its inside lies to the left of the path
/// from p to q. Precondition: q - p is perpendicular to the normal, and not zero.
[[nodiscard]] Halfspace wall(const HomogeneousPoint& p, const HomogeneousPoint& q,
                             const IntegerVector3& normal);

/// The least e such that all coordinates of the boxes are below 2^e in size, or that e plus 1; 0 if
/// all are zero.
[[nodiscard]] long common_exponent(std::span<const BoundingBox> boxes);

/// Points times 2^-e, e a common_exponent(). Keeps a reference.
class ScaledPoints {
 public:
  ScaledPoints(const PointSet& points, long exponent);
  ScaledPoints(std::span<const RationalPoint> points, long exponent);

  std::size_t size() const { return near_.size(); }
  /// Off by a relative 5 u and some of u^2, or by 2^-1074.
  const Point& near(std::size_t i) const { return near_[i]; }
  /// The unscaled point; computed when it is first asked for.
  const HomogeneousPoint& exact(std::size_t i) const {
    return exact_[i].get([&] { return clear_denominators(rational(i)); });
  }
  RationalPoint rational(std::size_t i) const {
    return set_ != nullptr ? (*set_)[PointId(i)] : list_[i];
  }
  /// Holds the scaled point.
  NearBox box(std::size_t i) const;

 private:
  const PointSet* set_ = nullptr;
  std::span<const RationalPoint> list_;
  std::vector<Point> near_;
  std::vector<Lazy<HomogeneousPoint>> exact_;
};

/// A plane for points times 2^-e. Precondition: it passes near the scaled points.
class ScaledPlane {
 public:
  ScaledPlane(const Halfspace& plane, long exponent);

  /// Positive beyond the plane.
  Sign side(const Halfspace& plane, const ScaledPoints& points, std::size_t i) const;

 private:
  std::array<double, 4> near_;  // (n, d 2^-e) in proportion, the largest of n in [1/2, 1)
};

/// A part whose planes and vertices are also scaled doubles.
struct LaidPart {
  LaidPart(const ConvexPart& part, long exponent);

  const ConvexPart* part;
  std::vector<ScaledPlane> planes;
  ScaledPoints vertices;
  NearBox box;

  Sign side(std::size_t plane, const ScaledPoints& points, std::size_t i) const {
    return planes[plane].side(part->halfspaces[plane], points, i);
  }
};

/// By point, the parts that hold it, ascending.
class Holders {
 public:
  /// @param tree  Over the boxes of the parts.
  /// @param jobs  Threads, at least 1.
  /// @throws Error Stopped when the watch ends the call.
  Holders(const ScaledPoints& points, std::span<const LaidPart> parts, const BoxTree& tree,
          const Watch& watch, std::size_t jobs);

  /// Whether one part holds all three points, and so their triangle.
  bool any_holds(const std::array<std::uint32_t, 3>& ids) const;

 private:
  std::vector<std::vector<std::uint32_t>> holders_;
};

/// The position of a part relative to a convex polygon or segment.
struct Meeting {
  enum Kind {
    Apart,     ///< The common part has no area (no length).
    Holds,     ///< The part holds all of it.
    Crossing,  ///< Neither is clear from the corners alone.
  } kind = Apart;
  std::vector<std::size_t> planes;      ///< If Crossing: those with corners on both sides.
  std::optional<std::size_t> coplanar;  ///< A plane that holds all corners.
};

/// @param corners  Into `points`, of a convex polygon with an area or of a segment with a length.
[[nodiscard]] Meeting meeting(const LaidPart& part, const ScaledPoints& points,
                              std::span<const std::uint32_t> corners);

}  // namespace convexact
