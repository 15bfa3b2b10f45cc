// SPDX-License-Identifier: MIT
#include <algorithm>
#include <numeric>

#include "convexact/run.hpp"
#include "measure/vertex_determinants.hpp"

namespace convexact {
namespace {

// The ids of the extreme points in canonical order.
std::vector<PointId> in_canonical_order(std::vector<PointId> ids, const PointSet& points) {
  const auto before = [](const auto& p, const auto& q) {
    for (int k = 0; k < 3; ++k) {
      if (p[k] != q[k]) return p[k] < q[k];
    }
    return false;
  };
  if (points.is_binary()) {
    const auto p = points.doubles();
    std::sort(ids.begin(), ids.end(),
              [&](PointId a, PointId b) { return before(p[a.index()], p[b.index()]); });
    return ids;
  }
  const PointSet extreme = subset(points, ids);
  std::vector<RationalPoint> p;
  for (std::size_t i = 0; i < ids.size(); ++i) p.push_back(extreme[PointId(i)]);
  std::vector<std::size_t> order(ids.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return before(p[a], p[b]); });
  std::vector<PointId> sorted;
  for (const std::size_t i : order) sorted.push_back(ids[i]);
  return sorted;
}

}  // namespace

VertexHull vertex_hull(const Hull& hull, const PointSet& points) {
  VertexHull start;
  start.ids = in_canonical_order(hull.vertices, points);
  start.points = subset(points, start.ids);
  std::vector<VertexId> vertex(points.size());
  for (std::size_t v = 0; v < start.ids.size(); ++v) {
    vertex[start.ids[v].index()] = VertexId(v);
  }
  for (std::size_t f = 0; f < hull.facets.size(); ++f) {
    const auto corners = hull.facets[f];
    std::size_t low = 0, high = corners.size() - 1;
    for (bool left = true; high - low >= 2; left = !left) {
      const std::size_t middle = left ? low + 1 : high - 1;
      start.triangles.push_back({vertex[corners[low].index()], vertex[corners[middle].index()],
                                 vertex[corners[high].index()]});
      (left ? low : high) = middle;
    }
  }
  return start;
}

std::vector<VertexId> vertices_left(const InnerRun& run, std::size_t count) {
  std::vector<VertexId> removed;
  for (const Step& step : run.steps) removed.push_back(step.removed);
  return all_but(removed, count);
}

InnerRun with_costs(const VertexHull& hull, InnerRun run) {
  const VertexDeterminants determinants(hull.points);
  for (Step& step : run.steps) {
    if (step.cost) continue;
    Integer six_volumes = 0;
    for (const VertexTriangle& t : step.triangles) {
      six_volumes +=
          determinants.height(t[0].index(), t[1].index(), t[2].index(), step.removed.index());
    }
    step.cost = determinants.volume(six_volumes);
  }
  return run;
}

}  // namespace convexact
