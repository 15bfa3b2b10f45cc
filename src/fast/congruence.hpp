// SPDX-License-Identifier: MIT
// congruence.hpp - caps that are equally large because a symmetry of the axes carries one to the
// other.
#pragma once
#include <vector>

#include "fast/fast_dual.hpp"

namespace convexact {

/// What a cap depends on: the plane of its facet and those of all facets that share an edge with
/// it, counter-clockwise from outside. Planes that only pass through a vertex of the facet bound
/// nothing beyond it: without dual point i, the dual face they share with i keeps its other points.
struct CapOutline {
  HalfspaceId facet;
  std::vector<HalfspaceId> neighbours;
};

/// Whether some isometry x -> S x + t, S one of the 48 signed permutations of the axes, carries the
/// planes of `a` to those of `b`. True proves that both caps have the same volume, as it is with
/// mirror images in modelled shapes; false proves nothing.
/// @par Cost  Comparisons of integers, mostly of the first few; k - 2 determinants if t != 0.
[[nodiscard]] bool are_congruent(const FastDual& dual, const CapOutline& a, const CapOutline& b);

}  // namespace convexact
