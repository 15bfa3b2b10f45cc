// SPDX-License-Identifier: MIT
// box_tree.hpp - boxes of doubles, and a tree that finds those that meet a box.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "convexact/geometry.hpp"
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
  /// From p to the box, off by roundings.
  double distance(const Point& p) const {
    return (low - p).cwiseMax(p - high).cwiseMax(0.0).norm();
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
  void find(const NearBox& box, std::vector<std::uint32_t>& found) const {
    find_if(
        box, [](const NearBox&) { return true; }, found);
  }
  /// Those of them that `may_hold` does not rule out, alone or by a box that holds them.
  template <class MayHold>
  void find_if(const NearBox& box, const MayHold& may_hold,
               std::vector<std::uint32_t>& found) const;
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

template <class MayHold>
void BoxTree::find_if(const NearBox& box, const MayHold& may_hold,
                      std::vector<std::uint32_t>& found) const {
  found.clear();
  if (nodes_.empty()) return;
  std::vector<std::uint32_t> open{0};
  while (!open.empty()) {
    const std::uint32_t n = open.back();
    open.pop_back();
    const Node& node = nodes_[n];
    if (!node.box.meets(box) || !may_hold(node.box)) continue;
    if (node.second_child != 0) {
      open.push_back(n + 1);
      open.push_back(node.second_child);
      continue;
    }
    for (std::uint32_t i = node.first; i < node.last; ++i) {
      if (boxes_[order_[i]].meets(box) && may_hold(boxes_[order_[i]])) found.push_back(order_[i]);
    }
  }
  std::sort(found.begin(), found.end());
}

}  // namespace convexact
