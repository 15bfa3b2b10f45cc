// SPDX-License-Identifier: MIT
#include "scene/inner_part.hpp"

#include <algorithm>

namespace convexact {
namespace {

// The box of a part, rounded to nearest: rounding is monotone, so that the rounded boxes of two
// parts hold each other if the parts do.
struct RoundedBox {
  explicit RoundedBox(const BoundingBox& box) {
    for (int k = 0; k < 3; ++k) {
      low[k] = to_double(box.low[k], Rounding::Nearest);
      high[k] = to_double(box.high[k], Rounding::Nearest);
    }
  }
  bool may_hold(const RoundedBox& other) const {
    return (low.array() <= other.low.array()).all() && (high.array() >= other.high.array()).all();
  }
  Point low, high;
};

}  // namespace

bool lies_in(const ConvexPart& inner, const ConvexPart& outer) {
  for (int k = 0; k < 3; ++k) {
    if (inner.box.low[k] < outer.box.low[k] || inner.box.high[k] > outer.box.high[k]) return false;
  }
  return std::all_of(inner.vertices.begin(), inner.vertices.end(),
                     [&](const RationalPoint& v) { return holds(outer, v); });
}

std::vector<std::optional<std::size_t>> find_holders(std::span<const ConvexPart* const> parts,
                                                     const Watch& watch) {
  std::vector<RoundedBox> boxes;
  for (const ConvexPart* part : parts) boxes.emplace_back(part->box);
  std::vector<std::vector<std::size_t>> holders(parts.size());  // except later equal ones
  for (std::size_t k = 0; k < parts.size(); ++k) {
    watch.at(k, parts.size());
    for (std::size_t j = 0; j < parts.size(); ++j) {
      if (j == k || !boxes[j].may_hold(boxes[k]) || !lies_in(*parts[k], *parts[j])) continue;
      if (j < k || !lies_in(*parts[j], *parts[k])) holders[k].push_back(j);
    }
  }
  // This relation is transitive and has no cycle, so that one of the holders is not held by
  // another.
  std::vector<std::optional<std::size_t>> first(parts.size());
  for (std::size_t k = 0; k < parts.size(); ++k) {
    for (const std::size_t j : holders[k]) {
      if (!first[k] && holders[j].empty()) first[k] = j;
    }
  }
  return first;
}

}  // namespace convexact
