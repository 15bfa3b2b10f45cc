// SPDX-License-Identifier: MIT
#include "fast/check_surface.hpp"

#include <algorithm>
#include <vector>

#include "fast/dual_signs.hpp"

namespace convexact {
namespace {

// A directed edge and the third corner of its triangle.
struct Edge {
  HalfspaceId from, to, apex;

  friend bool operator<(const Edge& a, const Edge& b) {
    return std::pair(a.from, a.to) < std::pair(b.from, b.to);
  }
};

std::vector<Edge> edges_of(std::span<const DualTriangle> triangles) {
  std::vector<Edge> edges;
  for (const DualTriangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) edges.push_back({t[k], t[(k + 1) % 3], t[(k + 2) % 3]});
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

// Each directed edge once and its opposite too; convex or flat there.
bool is_closed_and_convex(const DualSigns& signs, const std::vector<Edge>& edges) {
  const auto same = [](const Edge& a, const Edge& b) { return a.from == b.from && a.to == b.to; };
  if (std::adjacent_find(edges.begin(), edges.end(), same) != edges.end()) return false;
  for (const Edge& e : edges) {
    const auto opposite = std::lower_bound(edges.begin(), edges.end(), Edge{e.to, e.from, {}});
    if (opposite == edges.end() || opposite->from != e.to || opposite->to != e.from) return false;
    if (e.from < e.to && signs.height(e.from, e.to, e.apex, opposite->apex) == Sign::Positive) {
      return false;
    }
  }
  return true;
}

// A ray through the first triangle meets no other: the surface surrounds the center once.
bool is_met_once(const FastDual& dual, std::span<const DualTriangle> triangles) {
  const auto normal = [&](HalfspaceId i) -> const IntegerVector3& {
    return dual.exact(i).normal();
  };
  const auto& [a, b, c] = triangles[0];
  const IntegerVector3 ray = normal(a) + normal(b) + normal(c);
  return std::all_of(triangles.begin() + 1, triangles.end(), [&](const DualTriangle& t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const IntegerVector3 side = normal(t[k]).cross(normal(t[(k + 1) % 3]));
      if (ray.dot(side) < 0) return true;
    }
    return false;
  });
}

}  // namespace

bool is_dual_hull(const FastDual& dual, std::span<const DualTriangle> triangles) {
  const DualSigns signs(dual);
  return triangles.size() >= 4 &&
         std::all_of(triangles.begin(), triangles.end(),
                     [&](const DualTriangle& t) {
                       return signs.determinant(t[0], t[1], t[2]) == Sign::Positive;
                     }) &&
         is_closed_and_convex(signs, edges_of(triangles)) && is_met_once(dual, triangles);
}

}  // namespace convexact
