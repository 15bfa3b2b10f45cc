// SPDX-License-Identifier: MIT
// edges.hpp - the edges of triangles, each with all the triangles that have it.
#pragma once
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "surface/flat_polygon.hpp"

namespace convexact {

/// A triangle along an edge.
struct EdgeUse {
  PointId low, high;  ///< The ends.
  std::uint32_t triangle;
  bool is_forward;  ///< Whether the triangle runs from `low` to `high`.
};

/// The edges of some triangles. Those with two equal corners have none: each of their edges would
/// cancel itself.
class EdgeTable {
 public:
  /// @par Cost  O(n log n)
  explicit EdgeTable(std::span<const Triangle> triangles) {
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
      const auto& [a, b, c] = triangles[t];
      if (a == b || b == c || c == a) continue;
      for (const auto& [tail, head] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
        uses_.push_back({std::min(tail, head), std::max(tail, head), t, tail < head});
      }
    }
    std::sort(uses_.begin(), uses_.end(), [](const EdgeUse& x, const EdgeUse& y) {
      return std::tie(x.low, x.high, x.triangle) < std::tie(y.low, y.high, y.triangle);
    });
  }

  /// Calls look(uses) for each edge, by its ends; its triangles are ascending.
  template <class Look>
  void for_each(const Look& look) const {
    for (std::size_t first = 0; first < uses_.size();) {
      std::size_t last = first + 1;
      while (last < uses_.size() && uses_[last].low == uses_[first].low &&
             uses_[last].high == uses_[first].high) {
        ++last;
      }
      look(std::span<const EdgeUse>(uses_).subspan(first, last - first));
      first = last;
    }
  }

 private:
  std::vector<EdgeUse> uses_;
};

}  // namespace convexact
