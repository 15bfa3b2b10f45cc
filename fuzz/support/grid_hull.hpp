// SPDX-License-Identifier: MIT
// grid_hull.hpp - the convex hull of a few points with small integer coordinates, from the
// definition and in machine integers: no difference is above 2^16, so no determinant overflows.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <vector>

#include "convexact/geometry.hpp"

namespace grid_hull {

using Vector = std::array<std::int64_t, 3>;

inline Vector minus(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline std::int64_t dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline constexpr Vector kZero{0, 0, 0};

/// The hull that convex_hull() must find.
struct Expected {
  explicit Expected(const std::vector<convexact::Point>& grid);

  int dimension = -1;
  std::vector<std::uint32_t> vertices;  ///< Extreme points, ascending; of equal ones the first.
  /// Corners counter-clockwise from outside, the lowest one first.
  std::set<std::vector<std::uint32_t>> facets;

 private:
  void find_dimension();
  void try_plane(std::uint32_t a, std::uint32_t b, std::uint32_t c);
  std::vector<std::uint32_t> corners(std::vector<std::uint32_t> on, const Vector& normal) const;

  std::vector<Vector> points_;
  std::vector<std::uint32_t> distinct_;
};

inline Expected::Expected(const std::vector<convexact::Point>& grid) {
  for (const convexact::Point& p : grid) {
    points_.push_back({std::int64_t(p[0]), std::int64_t(p[1]), std::int64_t(p[2])});
    const bool is_new =
        std::find(points_.begin(), points_.end() - 1, points_.back()) == points_.end() - 1;
    if (is_new) distinct_.push_back(static_cast<std::uint32_t>(points_.size() - 1));
  }
  find_dimension();
  if (dimension < 3) return;
  for (std::size_t i = 0; i < distinct_.size(); ++i) {
    for (std::size_t j = i + 1; j < distinct_.size(); ++j) {
      for (std::size_t k = j + 1; k < distinct_.size(); ++k) {
        try_plane(distinct_[i], distinct_[j], distinct_[k]);
      }
    }
  }
  std::set<std::uint32_t> extreme;  // every vertex is a corner of a facet
  for (const auto& facet : facets) extreme.insert(facet.begin(), facet.end());
  vertices.assign(extreme.begin(), extreme.end());
}

inline void Expected::find_dimension() {
  if (distinct_.empty()) return;
  dimension = 0;
  const Vector& origin = points_[distinct_[0]];
  Vector line = kZero, normal = kZero;
  for (const std::uint32_t i : distinct_) {
    const Vector v = minus(points_[i], origin);
    if (dimension == 0 && v != kZero) {
      dimension = 1;
      line = v;
    } else if (dimension == 1 && cross(line, v) != kZero) {
      dimension = 2;
      normal = cross(line, v);
    } else if (dimension == 2 && dot(normal, v) != 0) {
      dimension = 3;
    }
  }
}

// A plane that has all points on one side.
inline void Expected::try_plane(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  const Vector& origin = points_[a];
  Vector normal = cross(minus(points_[b], origin), minus(points_[c], origin));
  if (normal == kZero) return;
  std::vector<std::uint32_t> on;
  bool above = false, below = false;
  for (const std::uint32_t i : distinct_) {
    const std::int64_t height = dot(normal, minus(points_[i], origin));
    above = above || height > 0;
    below = below || height < 0;
    if (above && below) return;
    if (height == 0) on.push_back(i);
  }
  if (above) normal = minus(kZero, normal);
  facets.insert(corners(std::move(on), normal));
}

// The extreme ones of points in a plane: those around which the others leave a gap of half a turn
// or more. They are found by walking from the lowest extreme one to the next in counter-clockwise
// order.
inline std::vector<std::uint32_t> Expected::corners(std::vector<std::uint32_t> on,
                                                    const Vector& normal) const {
  // The lexicographically least point is extreme.
  std::uint32_t at = *std::min_element(on.begin(), on.end(), [&](std::uint32_t i, std::uint32_t j) {
    return points_[i] < points_[j];
  });
  const std::uint32_t start = at;
  std::vector<std::uint32_t> walk;
  do {
    walk.push_back(at);
    std::uint32_t next = at;  // no point is to the right of at -> next; among several the farthest
    for (const std::uint32_t i : on) {
      if (i == at) continue;
      const Vector u = minus(points_[next], points_[at]), v = minus(points_[i], points_[at]);
      const std::int64_t turn = dot(normal, cross(u, v));
      if (next == at || turn < 0 || (turn == 0 && dot(v, v) > dot(u, u))) next = i;
    }
    at = next;
  } while (at != start);
  std::rotate(walk.begin(), std::min_element(walk.begin(), walk.end()), walk.end());
  return walk;
}

}  // namespace grid_hull
