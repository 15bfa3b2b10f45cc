// SPDX-License-Identifier: MIT
// Walks around the vertices of a hull and cuts the polygons found there into triangles.
#include "dual_faces.hpp"

#include "convexact/error.hpp"
#include "convexact/fast/half_edge_mesh.hpp"

namespace convexact {
namespace {

void zigzag(std::span<const HalfspaceId> polygon, std::vector<DualTriangle>& triangles) {
  std::size_t low = 0, high = polygon.size() - 1;
  for (bool left = true; high - low >= 2; left = !left) {
    if (left) {
      triangles.push_back({polygon[low], polygon[low + 1], polygon[high]});
      ++low;
    } else {
      triangles.push_back({polygon[low], polygon[high - 1], polygon[high]});
      --high;
    }
  }
}

}  // namespace

std::vector<DualTriangle> triangulate_dual_faces(const FacetList& facets, std::size_t point_count) {
  // Half-edge h runs from corner tail[h] along facet[h]; those of one facet are consecutive.
  std::vector<std::uint32_t> tail, head, previous, facet_of;
  tail.reserve(facets.corner_count());
  head.reserve(facets.corner_count());
  previous.reserve(facets.corner_count());
  facet_of.reserve(facets.corner_count());
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const auto corners = facets[f];
    const auto first = static_cast<std::uint32_t>(tail.size());
    const auto count = static_cast<std::uint32_t>(corners.size());
    for (std::uint32_t c = 0; c < count; ++c) {
      tail.push_back(corners[c].value);
      head.push_back(corners[c + 1 == count ? 0 : c + 1].value);
      previous.push_back(first + (c == 0 ? count - 1 : c - 1));
      facet_of.push_back(static_cast<std::uint32_t>(f));
    }
  }
  std::vector<std::uint32_t> out(point_count, kNone);
  for (std::uint32_t h = 0; h < tail.size(); ++h) out[tail[h]] = h;
  const std::vector<std::uint32_t> twin = match_twins(tail, head, point_count);

  std::vector<DualTriangle> triangles;
  triangles.reserve(2 * facets.size() - 4);
  std::vector<HalfspaceId> polygon;
  for (std::size_t v = 0; v < point_count; ++v) {
    if (out[v] == kNone) continue;
    // The facet to the left of v -> w, then the one across its edge into v: counter-clockwise.
    polygon.clear();
    std::uint32_t h = out[v];
    do {
      polygon.push_back(HalfspaceId(facet_of[h]));
      h = twin[previous[h]];
    } while (h != out[v]);
    zigzag(polygon, triangles);
  }
  CONVEXACT_ASSERT(triangles.size() == 2 * facets.size() - 4);
  return triangles;
}

}  // namespace convexact
