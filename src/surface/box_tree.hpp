// SPDX-License-Identifier: MIT
// box_tree.hpp - boxes of doubles, and a tree that finds those that meet a box.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "convexact/point_set.hpp"
#include "surface/flat_polygon.hpp"

namespace convexact {

/// A closed box; empty at first.
struct NearBox {
  Point low = Point::Constant(1e308), high = Point::Constant(-1e308);

  void include(const Point& p) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  void include(const NearBox& box) {
    low = low.cwiseMin(box.low);
    high = high.cwiseMax(box.high);
  }
  bool meets(const NearBox& other) const {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }
  bool holds(const Point& p) const {
    return (low.array() <= p.array()).all() && (p.array() <= high.array()).all();
  }
};

/// Holds the triangle. Coordinates that are no doubles were rounded to nearest, so they are between
/// the neighbours.
[[nodiscard]] NearBox box_of(const PointSet& points, const Triangle& triangle);

/// A binary tree over boxes, halved at the median of their middles along the longest side.
class BoxTree {
 public:
  explicit BoxTree(std::vector<NearBox> boxes);

  /// The indices of the boxes that meet `box`, ascending.
  void find(const NearBox& box, std::vector<std::uint32_t>& found) const;
  const NearBox& box(std::size_t index) const { return boxes_[index]; }
  std::size_t size() const { return boxes_.size(); }

 private:
  // The boxes order_[first], ..., order_[last - 1]; the first child follows its parent.
  struct Node {
    NearBox box;
    std::uint32_t first, last, second_child = 0;  // 0: a leaf
  };
  void build(std::uint32_t first, std::uint32_t last);

  std::vector<NearBox> boxes_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace convexact
