// SPDX-License-Identifier: MIT
// Reads the dual hull off a primal hull: facets become dual vertices, vertices dual faces.
#include <algorithm>
#include <numeric>

#include "convexact/dual.hpp"
#include "convexact/error.hpp"

namespace convexact {
namespace {

// One corner of a facet, seen from its vertex: the facet lies between the edges to `next`
// (clockwise side) and `previous` (counter-clockwise side).
struct Corner {
  PointId next;
  PointId previous;
  HalfspaceId facet;
};

// The facets around a vertex, counter-clockwise from outside, starting at the lowest id.
std::vector<HalfspaceId> facets_around(std::vector<Corner> corners) {
  std::sort(corners.begin(), corners.end(),
            [](const Corner& a, const Corner& b) { return a.next < b.next; });
  const auto following = [&](const Corner& corner) {
    const auto place = std::lower_bound(
        corners.begin(), corners.end(), corner.previous,
        [](const Corner& candidate, PointId next) { return candidate.next < next; });
    CONVEXACT_ASSERT(place != corners.end() && place->next == corner.previous);
    return place;
  };
  auto corner =
      std::min_element(corners.begin(), corners.end(),
                       [](const Corner& a, const Corner& b) { return a.facet < b.facet; });
  std::vector<HalfspaceId> around;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    around.push_back(corner->facet);
    corner = following(*corner);
  }
  return around;
}

}  // namespace

DualHull dual_of(const Hull& hull, const PointSet& points) {
  // (1) Dual vertices: the facets, renumbered by canonical order.
  const std::vector<Halfspace> halfspaces = facet_halfspaces(hull, points);
  std::vector<std::size_t> order(halfspaces.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return halfspaces[a] < halfspaces[b]; });
  DualHull dual;
  dual.witness.resize(halfspaces.size());

  // (2) Collect the corners of each vertex.
  std::vector<std::uint32_t> vertex_of(points.size());
  for (std::size_t v = 0; v < hull.vertices.size(); ++v) {
    vertex_of[hull.vertices[v].index()] = static_cast<std::uint32_t>(v);
    dual.vertices.push_back(points[hull.vertices[v]]);
  }
  std::vector<std::vector<Corner>> corners(hull.vertices.size());
  for (std::size_t id = 0; id < order.size(); ++id) {
    const auto facet = hull.facets[order[id]];
    dual.halfspaces.push_back(halfspaces[order[id]]);
    dual.witness[id] = vertex_of[facet[0].index()];
    for (std::size_t c = 0; c < facet.size(); ++c) {
      corners[vertex_of[facet[c].index()]].push_back({facet[(c + 1) % facet.size()],
                                                      facet[(c + facet.size() - 1) % facet.size()],
                                                      HalfspaceId(id)});
    }
  }

  // (3) Dual faces: the facets around a vertex form a convex polygon, so any fan triangulates it.
  for (std::vector<Corner>& of_vertex : corners) {
    const std::vector<HalfspaceId> around = facets_around(std::move(of_vertex));
    for (std::size_t k = 2; k < around.size(); ++k) {
      dual.triangles.push_back({around[0], around[k - 1], around[k]});
    }
  }
  CONVEXACT_ASSERT(dual.triangles.size() == 2 * dual.halfspaces.size() - 4);
  return dual;
}

}  // namespace convexact
