// SPDX-License-Identifier: MIT
#include "overlay/union_distance_triangles.hpp"

#include <algorithm>
#include <numeric>

namespace convexact {

NearTriangles::NearTriangles(const Surface& surface, const NearFrame& frame)
    : points_(frame(surface.points)), order_(surface.triangles.size()) {
  std::vector<Point> middles;
  for (const auto& [a, b, c] : surface.triangles) {
    triangles_.push_back({a.value, b.value, c.value});
    middles.push_back(points_[a.value] + points_[b.value] + points_[c.value]);
  }
  std::iota(order_.begin(), order_.end(), 0u);
  Node root;
  root.count = static_cast<std::uint32_t>(order_.size());
  nodes_.push_back(root);
  for (std::uint32_t node = 0; node < nodes_.size(); ++node) divide(node, middles);
}

// Halves of equal size along the longest side of the box of the triangles' middles.
void NearTriangles::divide(std::uint32_t node, std::vector<Point>& middles) {
  const std::uint32_t first = nodes_[node].first, count = nodes_[node].count;
  NearBox box, of_middles;
  for (std::uint32_t k = first; k < first + count; ++k) {
    for (const Point& y : corners(order_[k])) box.include(y);
    of_middles.include(middles[order_[k]]);
  }
  nodes_[node].box = box;
  const auto begin = order_.begin() + first;
  if (count <= 4) {
    // Which triangles a half has is certain, but not their order, and the first of several at the
    // same distance is the nearest one.
    std::sort(begin, begin + count);
    return;
  }
  int axis = 0;
  (void)(of_middles.high - of_middles.low).maxCoeff(&axis);
  std::nth_element(begin, begin + count / 2, begin + count, [&](std::uint32_t a, std::uint32_t b) {
    return std::pair(middles[a][axis], a) < std::pair(middles[b][axis], b);
  });
  nodes_[node].left = static_cast<std::uint32_t>(nodes_.size());
  Node half;
  half.first = first;
  half.count = count / 2;
  nodes_.push_back(half);
  half.first = first + count / 2;
  half.count = count - count / 2;
  nodes_.push_back(half);
}

// The nearer half first. A node farther than the best upper bound cannot lower either bound.
NearTriangles::Nearest NearTriangles::nearest(const Point& y, std::uint32_t start) const {
  Nearest best{near_triangle(corners(start), y).bounds, start};
  std::vector<std::pair<double, std::uint32_t>> stack{{nodes_[0].box.distance(y), 0}};
  while (!stack.empty()) {
    const double below = stack.back().first;
    const Node& node = nodes_[stack.back().second];
    stack.pop_back();
    if (below > best.distance.high) continue;
    if (node.left == 0) {
      for (std::uint32_t k = node.first; k < node.first + node.count; ++k) {
        const NearBounds bounds = near_triangle(corners(order_[k]), y).bounds;
        best.distance.low = std::min(best.distance.low, bounds.low);
        if (bounds.high < best.distance.high) {
          best.distance.high = bounds.high;
          best.triangle = order_[k];
        }
      }
      continue;
    }
    std::pair<double, std::uint32_t> near(nodes_[node.left].box.distance(y), node.left);
    std::pair<double, std::uint32_t> far(nodes_[node.left + 1].box.distance(y), node.left + 1);
    if (far.first < near.first) std::swap(near, far);
    stack.push_back(far);
    stack.push_back(near);
  }
  best.distance = widened(best.distance, y);
  return best;
}

NearBounds NearTriangles::to_triangle(std::uint32_t triangle, const Point& y) const {
  return widened(near_triangle(corners(triangle), y).bounds, y);
}

std::vector<std::uint32_t> NearTriangles::within(const Point& y, double distance) const {
  std::vector<std::uint32_t> found, stack{0};
  while (!stack.empty()) {
    const Node& node = nodes_[stack.back()];
    stack.pop_back();
    if (widened({node.box.distance(y), 0}, y).low > distance) continue;
    if (node.left != 0) {
      stack.insert(stack.end(), {node.left, node.left + 1});
      continue;
    }
    for (std::uint32_t k = node.first; k < node.first + node.count; ++k) {
      if (to_triangle(order_[k], y).low <= distance) found.push_back(order_[k]);
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

// Two hulls have a common point iff the hull of all differences of their vertices holds 0. The
// differences have errors of a few roundings, which kDistanceError covers several times.
bool NearTriangles::misses(std::span<const Point> hull) const {
  constexpr double kMargin = 4 * kDistanceError;
  NearBox box;
  for (const Point& y : hull) box.include(y);
  box.low.array() -= kMargin;
  box.high.array() += kMargin;
  std::vector<Point> differences(3 * hull.size());
  return all_meeting(box, [&](std::uint32_t, const std::array<Point, 3>& triangle) {
    std::size_t next = 0;
    for (const Point& y : triangle) {
      for (const Point& x : hull) differences[next++] = x - y;
    }
    return near_hull(differences, Point::Zero()).bounds.low > kMargin;
  });
}

}  // namespace convexact
