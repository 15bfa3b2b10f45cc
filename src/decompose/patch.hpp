// SPDX-License-Identifier: MIT
// patch.hpp - some triangles of a surface as a separate mesh: its points, the edges between
// them with their lengths, and its borders.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "convexact/surface.hpp"
#include "overlay/union_distance_near.hpp"

namespace convexact {

/// The points of a surface in doubles, for bounds.
struct NearSurface {
  explicit NearSurface(const Surface& surface);

  NearFrame frame;
  std::vector<Point> points;
};

/// Lengths of edges as integers: rounded up to multiples of a power of two that is near 2^-40 of
/// the diameter of the surface. So lengths of paths are exact sums, the same on every machine.
class EdgeLengths {
 public:
  /// Keeps references.
  EdgeLengths(const PointSet& points, const NearSurface& near) : points_(points), near_(near) {}

  /// Less than 2^42, and at least 1 for distinct points.
  std::uint64_t operator()(PointId a, PointId b) const;

  /// The length from one point of the frame to another in the same unit, off by less than 2^-9.
  static double unrounded(const Point& a, const Point& b);

 private:
  const PointSet& points_;
  const NearSurface& near_;
};

/// A mesh of k triangles and n points, both with local numbers from 0 that ascend with the ids.
class Patch {
 public:
  /// @param triangles  Of the surface, ascending.
  /// @par Cost         O(k log k)
  Patch(const Surface& surface, std::span<const TriangleId> triangles, const EdgeLengths& lengths);

  std::span<const TriangleId> triangles() const { return triangles_; }
  std::span<const PointId> points() const { return points_; }
  /// Corners of a triangle as numbers of points.
  const std::array<std::uint32_t, 3>& corners(std::uint32_t triangle) const {
    return corners_[triangle];
  }
  std::uint32_t number_of(PointId point) const;

  struct Way {
    std::uint32_t to;
    std::uint64_t length;
  };
  /// The points at the other ends of the edges at a point, ascending.
  std::span<const Way> ways(std::uint32_t point) const {
    return {ways_.data() + first_way_[point], first_way_[point + 1] - first_way_[point]};
  }
  /// Whether an edge of the mesh joins two points.
  bool is_edge(std::uint32_t a, std::uint32_t b) const;

  /// The edges at a point, by their other ends, each with its triangles, ascending.
  struct Spoke {
    std::uint32_t to;
    std::vector<std::uint32_t> triangles;
  };
  std::vector<Spoke> spokes(std::uint32_t point) const;
  std::span<const std::uint32_t> triangles_at(std::uint32_t point) const {
    return {fans_.data() + first_fan_[point], first_fan_[point + 1] - first_fan_[point]};
  }

  /// The closed walks along borders, each once: along edges with one triangle, in the direction of
  /// that triangle, so that the hole lies to the right. At a point a walk goes on in the same fan
  /// of triangles; among several ways, to the lowest point. Walks that do not return to their start
  /// are left out. Each walk is the list of its points, with the first one once.
  std::span<const std::vector<std::uint32_t>> border_loops() const { return loops_; }

 private:
  struct BorderStep {
    std::uint32_t from, to, triangle;
  };
  std::vector<std::uint32_t> fans_at(std::uint32_t point) const;
  void find_loops(std::vector<BorderStep> steps);

  std::vector<TriangleId> triangles_;
  std::vector<PointId> points_;
  std::vector<std::array<std::uint32_t, 3>> corners_;
  std::vector<Way> ways_;
  std::vector<std::size_t> first_way_;
  std::vector<std::uint32_t> fans_;
  std::vector<std::size_t> first_fan_;
  std::vector<std::vector<std::uint32_t>> loops_;
};

}  // namespace convexact
