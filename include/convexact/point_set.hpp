// SPDX-License-Identifier: MIT
// point_set.hpp - finite points with exact coordinates, and ids.
#pragma once
#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "convexact/number.hpp"

namespace convexact {

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

}  // namespace convexact
