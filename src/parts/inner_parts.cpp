// SPDX-License-Identifier: MIT
#include "parts/inner_parts.hpp"

#include <algorithm>
#include <optional>
#include <span>

#include "number/arithmetic.hpp"

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

// By part: the first of those that it lies in and that lie in no other one themselves. Nothing for
// those that stay; of equal parts the first one does.
std::vector<std::optional<std::size_t>> find_holders(std::span<const ConvexPart* const> parts,
                                                     const Watch& watch) {
  std::vector<RoundedBox> boxes;
  for (const ConvexPart* part : parts) boxes.emplace_back(part->box);
  std::vector<std::vector<std::size_t>> holders(parts.size());  // but for later equal ones
  for (std::size_t k = 0; k < parts.size(); ++k) {
    watch.at(k, parts.size());
    for (std::size_t j = 0; j < parts.size(); ++j) {
      if (j == k || !boxes[j].may_hold(boxes[k]) || !lies_in(*parts[k], *parts[j])) continue;
      if (j < k || !lies_in(*parts[j], *parts[k])) holders[k].push_back(j);
    }
  }
  // This relation is transitive and has no circle, so that one of the holders has none of its own.
  std::vector<std::optional<std::size_t>> first(parts.size());
  for (std::size_t k = 0; k < parts.size(); ++k) {
    for (const std::size_t j : holders[k]) {
      if (!first[k] && holders[j].empty()) first[k] = j;
    }
  }
  return first;
}

}  // namespace

std::vector<bool> give_up_inner_parts(Decomposition& made,
                                      const std::vector<const ConvexPart*>& solids,
                                      const Watch& watch) {
  std::vector<bool> stays(solids.size(), true);
  const auto holder = find_holders(solids, watch);
  std::vector<std::size_t> place(solids.size(), 0);  // of those that stay
  for (std::size_t k = 0, next = 0; k < solids.size(); ++k) {
    stays[k] = !holder[k];
    if (stays[k]) place[k] = next++;
  }
  for (InnerCluster& inner : made.inner) {
    inner.part = place[holder[inner.part].value_or(inner.part)];
  }
  for (std::size_t k = 0; k < solids.size(); ++k) {
    if (stays[k]) continue;
    const std::vector<TriangleId> owns = std::move(made.parts[k].owns);
    const std::vector<std::uint32_t> leaves = std::move(made.parts[k].leaves);
    Part& other = made.parts[*holder[k]];
    other.leaves.insert(other.leaves.end(), leaves.begin(), leaves.end());
    std::sort(other.leaves.begin(), other.leaves.end());
    if (!made.parts[k].cluster.empty()) {
      made.inner.push_back({made.parts[k].cluster.front(), place[*holder[k]]});
    }
    for (const TriangleId lowest : made.parts[k].merged) {
      made.inner.push_back({lowest, place[*holder[k]]});
    }
    other.owns.insert(other.owns.end(), owns.begin(), owns.end());
    const std::vector<PointId> loose = std::move(made.parts[k].loose);
    other.loose.insert(other.loose.end(), loose.begin(), loose.end());
  }
  keep_those(stays, made.parts);
  for (Part& part : made.parts) std::sort(part.owns.begin(), part.owns.end());
  std::sort(made.inner.begin(), made.inner.end(),
            [](const InnerCluster& a, const InnerCluster& b) { return a.lowest < b.lowest; });
  return stays;
}

}  // namespace convexact
