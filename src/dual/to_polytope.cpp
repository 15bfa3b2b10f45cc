// SPDX-License-Identifier: MIT
// From a triangulated dual surface back to the solid.
#include <algorithm>
#include <numeric>

#include "convexact/dual.hpp"

namespace convexact {
namespace {

bool precedes(const RationalPoint& a, const RationalPoint& b) {
  for (int k = 0; k < 3; ++k) {
    if (const int order = a[k].compare(b[k]); order != 0) return order < 0;
  }
  return false;
}

// Merges equal points; returns the distinct ones ascending and, per point, which one it is.
std::pair<std::vector<RationalPoint>, std::vector<std::uint32_t>> merge_equal(
    const std::vector<RationalPoint>& points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return precedes(points[a], points[b]); });
  std::vector<RationalPoint> distinct;
  std::vector<std::uint32_t> index(points.size());
  for (const std::size_t p : order) {
    if (distinct.empty() || points[p] != distinct.back()) distinct.push_back(points[p]);
    index[p] = static_cast<std::uint32_t>(distinct.size() - 1);
  }
  return {std::move(distinct), std::move(index)};
}

}  // namespace

Polytope to_polytope(std::span<const Halfspace> halfspaces,
                     std::span<const DualTriangle> triangles) {
  std::vector<RationalPoint> corners;
  AdjacencyMatrix dual(halfspaces.size());
  for (const auto& [a, b, c] : triangles) {
    corners.push_back(meet(halfspaces[a.index()], halfspaces[b.index()], halfspaces[c.index()]));
    dual.add({a, b, c});
  }
  auto [vertices, vertex_of] = merge_equal(corners);

  // The triangles at dual point i, in the order of its ring, are the corners of facet i.
  std::vector<std::vector<std::pair<HalfspaceId, std::uint32_t>>> star(halfspaces.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (int e = 0; e < 3; ++e) {
      star[triangles[t][e].index()].push_back({triangles[t][(e + 1) % 3], vertex_of[t]});
    }
  }
  Polytope polytope;
  polytope.vertices = std::move(vertices);
  for (std::size_t i = 0; i < halfspaces.size(); ++i) {
    std::sort(star[i].begin(), star[i].end());
    std::vector<std::uint32_t> facet;
    for (const HalfspaceId j : dual.one_ring(HalfspaceId(i))) {
      const auto corner = std::lower_bound(star[i].begin(), star[i].end(), std::pair(j, 0u));
      // Planes that share a point leave several triangles with one vertex, all in a row.
      if (facet.empty() || facet.back() != corner->second) facet.push_back(corner->second);
    }
    if (facet.empty()) continue;
    if (facet.front() == facet.back()) facet.pop_back();
    std::rotate(facet.begin(), std::min_element(facet.begin(), facet.end()), facet.end());
    polytope.facets.push_back(std::move(facet));
    polytope.planes.push_back(halfspaces[i]);
  }
  return polytope;
}

}  // namespace convexact
