// SPDX-License-Identifier: MIT
// union_distance_triangles.hpp - bounds in doubles of distances to the triangles of a surface,
// found by a tree of boxes.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "convexact/surface.hpp"
#include "overlay/union_distance_near.hpp"

namespace convexact {

class NearTriangles {
 public:
  /// @param frame  The frame that the surface lies in.
  NearTriangles(const Surface& surface, const NearFrame& frame);

  /// A point of the surface in the frame.
  const Point& point(PointId p) const { return points_[p.index()]; }

  /// Bounds of the distance of y to the surface, and a triangle that is about as near.
  struct Nearest {
    NearBounds distance;
    std::uint32_t triangle = 0;
  };
  /// @param start  A triangle to begin with: the search is quick if it is near.
  Nearest nearest(const Point& y, std::uint32_t start = 0) const;
  NearBounds to_triangle(std::uint32_t triangle, const Point& y) const;
  /// The triangles that may be at most this far from y, ascending.
  std::vector<std::uint32_t> within(const Point& y, double distance) const;

  /// Whether it is certain that no triangle has a common point with the hull of at most four
  /// points.
  bool misses(std::span<const Point> corners) const;

  /// The corners of a triangle in the frame.
  std::array<Point, 3> corners(std::uint32_t triangle) const {
    const auto& [a, b, c] = triangles_[triangle];
    return {points_[a], points_[b], points_[c]};
  }

  /// Whether `holds` is true of all triangles, and their corners, whose boxes meet a box; it is
  /// asked until it is false once.
  template <class Holds>
  bool all_meeting(const NearBox& box, const Holds& holds) const;

 private:
  // A node of the tree: triangles order_[first, first + count), or two nodes, `left` and the next.
  struct Node {
    NearBox box;
    std::uint32_t first = 0, count = 0, left = 0;
  };

  void divide(std::uint32_t node, std::vector<Point>& middles);

  std::vector<Point> points_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

template <class Holds>
bool NearTriangles::all_meeting(const NearBox& box, const Holds& holds) const {
  std::vector<std::uint32_t> stack{0};
  while (!stack.empty()) {
    const Node& node = nodes_[stack.back()];
    stack.pop_back();
    if (!box.meets(node.box)) continue;
    if (node.left != 0) {
      stack.push_back(node.left);
      stack.push_back(node.left + 1);
      continue;
    }
    for (std::uint32_t k = node.first; k < node.first + node.count; ++k) {
      const std::array<Point, 3> triangle = corners(order_[k]);
      NearBox around;
      for (const Point& y : triangle) around.include(y);
      if (box.meets(around) && !holds(order_[k], triangle)) return false;
    }
  }
  return true;
}

}  // namespace convexact
