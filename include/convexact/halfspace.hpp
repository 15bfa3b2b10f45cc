// SPDX-License-Identifier: MIT
// halfspace.hpp - halfspaces as primitive integer vectors, and lists of them as a file gives them.
#pragma once
#include <compare>
#include <cstddef>
#include <optional>
#include <vector>

#include "convexact/number.hpp"
#include "convexact/point_set.hpp"

namespace convexact {

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

}  // namespace convexact
