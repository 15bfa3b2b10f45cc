// SPDX-License-Identifier: MIT
// polytope.hpp - a bounded solid: its vertices, facets, planes and edges.
#pragma once
#include <cstdint>
#include <vector>

#include "convexact/halfspace.hpp"

namespace convexact {

/// A convex polytope of dimension 3, the only primal type. `facets[f]` lists the corners of facet f
/// as indices into `vertices`, counter-clockwise from outside, at least three, no repeats;
/// `planes[f]` bounds it. Facets are maximal and stand in canonical order of their planes.
struct Polytope {
  std::vector<RationalPoint> vertices;
  std::vector<std::vector<std::uint32_t>> facets;
  std::vector<Halfspace> planes;
};

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
