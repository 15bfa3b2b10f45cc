// SPDX-License-Identifier: MIT
#include "surface/box_tree.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace convexact {

NearBox box_of(const PointSet& points, const Triangle& triangle) {
  NearBox box;
  for (const PointId p : triangle) {
    const Point near = points.doubles()[p.index()];
    box.include(near);
    if (points.is_binary()) continue;
    for (const double side : {-HUGE_VAL, HUGE_VAL}) {
      box.include(Point(near.unaryExpr([&](double x) { return std::nextafter(x, side); })));
    }
  }
  return box;
}

BoxTree::BoxTree(std::vector<NearBox> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
  std::iota(order_.begin(), order_.end(), 0u);
  if (!boxes_.empty()) build(0, static_cast<std::uint32_t>(boxes_.size()));
}

void BoxTree::build(std::uint32_t first, std::uint32_t last) {
  constexpr std::uint32_t kLeaf = 4;
  const std::size_t own = nodes_.size();
  nodes_.push_back({NearBox{}, first, last});
  for (std::uint32_t i = first; i < last; ++i) nodes_[own].box.include(boxes_[order_[i]]);
  if (last - first <= kLeaf) return;
  int axis = 0;
  const Point size = nodes_[own].box.high - nodes_[own].box.low;
  size.maxCoeff(&axis);
  const std::uint32_t middle = first + (last - first) / 2;
  std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                   [&](std::uint32_t a, std::uint32_t b) {
                     const double x = boxes_[a].low[axis] / 2 + boxes_[a].high[axis] / 2,
                                  y = boxes_[b].low[axis] / 2 + boxes_[b].high[axis] / 2;
                     return x != y ? x < y : a < b;
                   });
  build(first, middle);
  nodes_[own].second_child = static_cast<std::uint32_t>(nodes_.size());
  build(middle, last);
}

}  // namespace convexact
