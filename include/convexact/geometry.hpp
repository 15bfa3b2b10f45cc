// SPDX-License-Identifier: MIT
// geometry.hpp - point sets, halfspaces, polytopes, and the exact predicates.
#pragma once
#include <algorithm>
#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "convexact/number.hpp"

namespace convexact {

// ---- Finite points with exact coordinates, and ids.

/// A 0-based index into one kind of list.
template <class Tag>
struct Id {
  std::uint32_t value = 0;

  constexpr Id() = default;
  constexpr explicit Id(std::size_t index) : value(static_cast<std::uint32_t>(index)) {}
  constexpr std::size_t index() const { return value; }
  friend constexpr auto operator<=>(const Id&, const Id&) = default;
};

using PointId = Id<struct PointTag>;          ///< Into the input's points.
using HalfspaceId = Id<struct HalfspaceTag>;  ///< Into halfspaces in canonical order.

/// Three dual points (so three halfspaces, whose planes meet in a primal vertex), counter-clockwise
/// seen from outside the dual hull.
using DualTriangle = std::array<HalfspaceId, 3>;

}  // namespace convexact

template <class Tag>
struct std::hash<convexact::Id<Tag>> {
  std::size_t operator()(const convexact::Id<Tag>& id) const noexcept { return id.value; }
};

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
  /// The doubles: exact if is_binary(), otherwise each rational rounded to nearest.
  std::span<const Point> doubles() const { return points_; }
  /// Of points that are not binary, by point: itself less its double, rounded to nearest.
  std::span<const Point> remainders() const { return remainders_; }
  /// The point itself, exactly.
  RationalPoint operator[](PointId id) const;

  friend PointSet subset(const PointSet& points, std::span<const PointId> ids);

 private:
  std::vector<Point> points_;
  std::vector<RationalPoint> rationals_;  // empty, or as long as points_
  std::vector<Point> remainders_;         // as long as rationals_
};

/// The points with these ids, in this order.
[[nodiscard]] PointSet subset(const PointSet& points, std::span<const PointId> ids);

/// The points of one set, then those of the other.
[[nodiscard]] PointSet concatenated(const PointSet& first, const PointSet& second);

// ---- Halfspaces as primitive integer vectors, and lists of them as a file gives them.

/// The set {x : dot(n, x) + d <= 0}, n nonzero and pointing outward. The four integers have gcd 1,
/// so equal halfspaces compare equal.
class Halfspace {
 public:
  /// @throws Error InvalidArgument if the normal is zero.
  Halfspace(IntegerVector3 normal, Integer offset);
  Halfspace(const RationalVector3& normal, const Rational& offset);
  /// Bounded by the plane through a, b, c, which look counter-clockwise from outside:
  /// n = (b - a) x (c - a). @throws Error InvalidArgument if the points are collinear.
  static Halfspace through(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c);
  /// The same for finite doubles: integers only, an order of magnitude faster.
  static Halfspace through(const Point& a, const Point& b, const Point& c);

  const IntegerVector3& normal() const { return normal_; }
  const Integer& offset() const { return offset_; }
  /// dot(n, x) + d: negative inside, zero on the plane.
  Rational operator()(const RationalPoint& x) const;

  friend bool operator==(const Halfspace& a, const Halfspace& b) {
    return a.offset_ == b.offset_ && a.normal_ == b.normal_;
  }
  /// Canonical order: by n/gcd(n) as a triple, then by d/gcd(n).
  friend std::strong_ordering operator<=>(const Halfspace& a, const Halfspace& b);

 private:
  IntegerVector3 normal_;
  Integer offset_;
  Integer normal_gcd_;  // gcd(n1, n2, n3), kept for the canonical order
};

/// Whether two halfspaces have the same outward direction (their planes are then parallel).
[[nodiscard]] bool same_direction(const Halfspace& a, const Halfspace& b);

/// The value of the halfspace at p.n / p.w, times p.w: of the same sign, and an integer.
[[nodiscard]] Integer plane_value(const Halfspace& h, const HomogeneousPoint& p);

/// The point where three planes meet.
/// @throws Error InvalidArgument if det(n_a, n_b, n_c) = 0.
[[nodiscard]] RationalPoint meet(const Halfspace& a, const Halfspace& b, const Halfspace& c);

/// Where the halfspaces of a list stand in its file, and how they were typed. Rows are counted
/// from 0.
struct TypedRows {
  std::vector<std::size_t> rows;  ///< rows[k]: the row of halfspaces[k].
  std::vector<Rational> scales;   ///< halfspaces[k] = scales[k] > 0 times that row as typed.
};

/// Halfspaces n.x + d <= 0 in the order of a file. A row with n = 0 bounds nothing: it holds
/// everywhere if d <= 0, and is dropped; otherwise it holds nowhere, and the whole list is empty.
struct HalfspaceList : TypedRows {
  std::vector<Halfspace> halfspaces;
  std::vector<std::size_t> trivial_rows;  ///< Rows with n = 0, d <= 0.
  /// The first row with n = 0, d > 0: 0 <= -d is false.
  std::optional<std::size_t> impossible_row;

  /// Appends the next row, which may be of any of these three kinds.
  void add(const RationalVector3& normal, const Rational& offset);
  std::size_t row_count() const { return row_count_; }

 private:
  std::size_t row_count_ = 0;
};

// ---- A bounded solid: its vertices, facets, planes and edges.

/// A convex polytope of dimension 3, the only primal type. `facets[f]` lists the corners of facet f
/// as indices into `vertices`, counter-clockwise from outside, at least three, no repeats;
/// `planes[f]` bounds it. Facets are maximal and stand in canonical order of their planes.
struct Polytope {
  std::vector<RationalPoint> vertices;
  std::vector<std::vector<std::uint32_t>> facets;
  std::vector<Halfspace> planes;
};

/// The directed edge from vertex `tail` to vertex `head`; seen from outside, facet `left` lies to
/// its left and facet `right` to its right.
struct Edge {
  std::uint32_t tail, head;
  std::uint32_t left, right;
};

/// Every edge once, directed so that tail < head, ascending by (tail, head). V - E + F = 2.
/// @throws Error InvalidArgument if the facets do not form a closed surface.
/// @par Cost  O(E log E)
[[nodiscard]] std::vector<Edge> edges(const Polytope& polytope);

// ---- Boxes

/// low <= x <= high in each coordinate; exact.
struct BoundingBox {
  RationalPoint low, high;

  RationalVector3 size() const { return high - low; }
  RationalPoint middle() const { return (low + high) / Rational(2); }
  /// Square of the diagonal, which the project calls the diameter of an input.
  Rational squared_diameter() const { return size().squaredNorm(); }
  /// The largest absolute value of any coordinate of a point in the box.
  Rational largest_coordinate() const {
    return std::max<Rational>(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff());
  }
};

/// The smallest box around n >= 1 points. @throws Error InvalidArgument if there is none.
[[nodiscard]] BoundingBox bounding_box(std::span<const RationalPoint> points);
[[nodiscard]] BoundingBox bounding_box(const PointSet& points);

// ---- Exact signs for points in doubles: on which side of a plane a point lies. For rational
// points the sign is that of halfspace(point).

/// The sign of det[a-d; b-d; c-d], exactly, for all finite doubles. With a, b, c counter-clockwise
/// seen from +z and d far up +z it is Negative: orient3d((0,0,0), (1,0,0), (0,1,0), (0,0,1)) is the
/// sign of det[(0,0,-1); (1,0,-1); (0,1,-1)] = -1. Most callers want is_beyond().
/// @par Cost    About 30 flops when the points are far from coplanar, else up to some microseconds.
/// @par Source  [Shewchuk1997]
[[nodiscard]] Sign orient3d(const Point& a, const Point& b, const Point& c, const Point& d);

/// Whether p lies strictly beyond the plane through a, b, c, which look counter-clockwise from
/// beyond: orient3d(a, b, c, p) < 0.
[[nodiscard]] inline bool is_beyond(const Point& a, const Point& b, const Point& c,
                                    const Point& p) {
  return orient3d(a, b, c, p) == Sign::Negative;
}

/// The sign of n.x + d: Negative strictly inside, Zero on the plane. x is finite.
/// @par Cost  Three products of integers; no fractions, which take several times as long.
[[nodiscard]] Sign side_of(const Halfspace& halfspace, const Point& x);

}  // namespace convexact
