// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "convexact/cluster.hpp"
#include "decompose/near_facets.hpp"
#include "number/groups.hpp"
#include "surface/box_tree.hpp"
#include "surface/common_point.hpp"
#include "surface/edges.hpp"

namespace convexact {
namespace {

using TrianglePairs = std::vector<std::pair<TriangleId, TriangleId>>;

void add_pair(std::uint32_t a, std::uint32_t b, TrianglePairs& pairs) {
  if (a != b) pairs.emplace_back(std::minmax(TriangleId(a), TriangleId(b)));
}

// The edges of a surface with their triangles.
struct SharedEdge {
  PointId low, high;
  std::vector<std::uint32_t> triangles;
};

std::vector<SharedEdge> shared_edges(const Surface& surface) {
  std::vector<SharedEdge> edges;
  EdgeTable(surface.triangles).for_each([&](std::span<const EdgeUse> uses) {
    edges.push_back({uses[0].low, uses[0].high, {}});
    for (const EdgeUse& use : uses) edges.back().triangles.push_back(use.triangle);
  });
  return edges;
}

// By doubles, if these are the points.
bool are_collinear(const PointSet& points, PointId a, PointId b, PointId c) {
  if (points.is_binary()) {
    const auto near = points.doubles();
    const NearNormal normal = near_normal(near[a.index()], near[b.index()], near[c.index()], 0);
    if (normal.value.cwiseAbs().maxCoeff() > normal.error && std::isfinite(normal.error)) {
      return false;
    }
  }
  return has_no_area(points, {a, b, c});
}

// Whether they have a common segment of positive length. Ids of points are in lexicographic order,
// which along a line is one of its two directions.
bool overlap(const PointSet& points, const SharedEdge& a, const SharedEdge& b) {
  return std::max(a.low, b.low) < std::min(a.high, b.high) &&
         are_collinear(points, a.low, a.high, b.low) &&
         are_collinear(points, a.low, a.high, b.high);
}

// Calls look(i, j), i < j, for each pair of boxes that meet.
template <class Look>
void for_each_meeting(std::vector<NearBox> boxes, const Watch& watch, const Look& look) {
  const BoxTree tree(std::move(boxes));
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = 0; i < tree.size(); ++i) {
    watch.ask();
    found.clear();
    tree.find(tree.box(i), found);
    for (const std::uint32_t j : found) {
      if (i < j) look(i, j);
    }
  }
}

void add_overlapping(const Surface& surface, const std::vector<SharedEdge>& edges,
                     const Watch& watch, TrianglePairs& pairs) {
  std::vector<NearBox> boxes;
  for (const SharedEdge& edge : edges) {
    boxes.push_back(box_of(surface.points, {edge.low, edge.high, edge.high}));
  }
  for_each_meeting(std::move(boxes), watch, [&](std::uint32_t i, std::uint32_t j) {
    if (!overlap(surface.points, edges[i], edges[j])) return;
    for (const std::uint32_t a : edges[i].triangles) {
      for (const std::uint32_t b : edges[j].triangles) add_pair(a, b, pairs);
    }
  });
}

void add_touching(const Surface& surface, const Watch& watch, TrianglePairs& pairs) {
  if (surface.components.size() < 2) return;
  std::vector<NearBox> boxes;
  for (const auto& triangle : surface.triangles) boxes.push_back(box_of(surface.points, triangle));
  for_each_meeting(std::move(boxes), watch, [&](std::uint32_t i, std::uint32_t j) {
    if (surface.component[i] != surface.component[j] &&
        have_common_point(surface.points, surface.triangles[i], surface.triangles[j])) {
      add_pair(i, j, pairs);
    }
  });
}

}  // namespace

TrianglePairs neighbours(const Surface& surface, Connect connect, const Watch& watch) {
  watch.ask();
  TrianglePairs pairs;
  const std::vector<SharedEdge> edges = shared_edges(surface);
  for (const SharedEdge& edge : edges) {
    for (std::size_t i = 0; i < edge.triangles.size(); ++i) {
      for (std::size_t j = i + 1; j < edge.triangles.size(); ++j) {
        add_pair(edge.triangles[i], edge.triangles[j], pairs);
      }
    }
  }
  if (connect != Connect::Edge) add_overlapping(surface, edges, watch, pairs);
  if (connect == Connect::Touching) add_touching(surface, watch, pairs);
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

std::size_t count_groups(const Surface& surface,
                         std::span<const std::pair<TriangleId, TriangleId>> pairs) {
  Groups groups(surface.triangles.size());
  std::size_t count = surface.triangles.size();
  for (const auto& [a, b] : pairs) {
    if (groups.join(a.value, b.value)) --count;
  }
  return count;
}

}  // namespace convexact
