// SPDX-License-Identifier: MIT
#include <algorithm>
#include <numeric>

#include "convexact/cluster.hpp"
#include "surface/edges.hpp"

namespace convexact {

std::vector<std::pair<TriangleId, TriangleId>> neighbours(const Surface& surface, Connect connect,
                                                          const Watch& watch) {
  watch.ask();
  (void)connect;
  std::vector<std::pair<TriangleId, TriangleId>> pairs;
  EdgeTable(surface.triangles).for_each([&](std::span<const EdgeUse> uses) {
    for (std::size_t i = 0; i < uses.size(); ++i) {
      for (std::size_t j = i + 1; j < uses.size(); ++j) {
        pairs.emplace_back(TriangleId(uses[i].triangle), TriangleId(uses[j].triangle));
      }
    }
  });
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

std::size_t count_groups(const Surface& surface,
                         std::span<const std::pair<TriangleId, TriangleId>> pairs) {
  std::vector<std::uint32_t> parent(surface.triangles.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](std::uint32_t t) {
    while (parent[t] != t) t = parent[t] = parent[parent[t]];
    return t;
  };
  std::size_t groups = parent.size();
  for (const auto& [a, b] : pairs) {
    const std::uint32_t x = root(a.value), y = root(b.value);
    if (x == y) continue;
    parent[std::max(x, y)] = std::min(x, y);
    --groups;
  }
  return groups;
}

}  // namespace convexact
