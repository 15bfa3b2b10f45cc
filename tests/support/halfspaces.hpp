// SPDX-License-Identifier: MIT
// halfspaces.hpp - lists of halfspaces in a few small integers, written out or drawn.
#pragma once
#include <array>
#include <vector>

#include "convexact/geometry.hpp"
#include "number/random.hpp"

namespace convexact::data {

/// Each row is n1, n2, n3, d.
inline std::vector<Halfspace> halfspaces(const std::vector<std::array<int, 4>>& rows) {
  std::vector<Halfspace> list;
  for (const auto& [a, b, c, d] : rows) list.emplace_back(IntegerVector3(a, b, c), Integer(d));
  return list;
}

/// |x_k| <= half_k.
inline std::vector<Halfspace> centered_box(int x, int y, int z) {
  return halfspaces({{1, 0, 0, -x},
                     {-1, 0, 0, -x},
                     {0, 1, 0, -y},
                     {0, -1, 0, -y},
                     {0, 0, 1, -z},
                     {0, 0, -1, -z}});
}

/// Entries in [-reach, reach], offsets too.
inline std::vector<Halfspace> random_halfspaces(Random& random, std::size_t count, int reach) {
  const auto entry = [&] { return static_cast<int>(uniform_below(random, 2 * reach + 1)) - reach; };
  std::vector<Halfspace> list;
  while (list.size() < count) {
    const int a = entry(), b = entry(), c = entry(), d = entry();
    if (a != 0 || b != 0 || c != 0) list.emplace_back(IntegerVector3(a, b, c), Integer(d));
  }
  return list;
}

}  // namespace convexact::data
