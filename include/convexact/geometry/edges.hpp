// SPDX-License-Identifier: MIT
// edges.hpp - the edges of a polytope, with the facets on both sides.
#pragma once
#include <cstdint>
#include <vector>

#include "convexact/geometry/polytope.hpp"

namespace convexact {

/// The directed edge from vertex `tail` to vertex `head`; seen from outside, facet `left` lies to
/// its left and facet `right` to its right.
struct Edge {
  std::uint32_t tail, head;
  std::uint32_t left, right;
};

/// Every edge once, directed so that tail < head, ascending by (tail, head). V - E + F = 2.
/// @throws Error InvalidArgument if the facets do not form a closed surface.
/// @par Cost  O(E log E)
[[nodiscard]] std::vector<Edge> edges(const Polytope& polytope);

}  // namespace convexact
