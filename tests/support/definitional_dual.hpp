// SPDX-License-Identifier: MIT
// definitional_dual.hpp - the dual hull of a few points straight from the definition: every plane
// through three points is tried, and the planes through a vertex are sorted around it.
#pragma once
#include <algorithm>
#include <set>

#include "convexact/dual/dual_hull.hpp"

namespace definition {

using namespace convexact;

/// The facets' halfspaces in canonical order: planes through three points with none beyond.
inline std::vector<Halfspace> facets_of(const std::vector<RationalPoint>& points) {
  std::set<Halfspace> facets;
  for (std::size_t a = 0; a < points.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      for (std::size_t c = 0; c < b; ++c) {
        const RationalVector3 u = points[b] - points[a], v = points[c] - points[a];
        const RationalVector3 n = u.cross(v);
        if (n == RationalVector3::Zero()) continue;
        int below = 0, above = 0;
        for (const RationalPoint& p : points) {
          const Rational height = n.dot(p - points[a]);
          below += height < 0;
          above += height > 0;
        }
        const Rational offset = -n.dot(points[a]);
        if (above == 0) facets.emplace(n, offset);
        if (below == 0) facets.emplace(RationalVector3(-n), Rational(-offset));
      }
    }
  }
  return {facets.begin(), facets.end()};
}

/// The dual hull of points that span a volume; repeats allowed.
inline DualHull dual_of_points(std::vector<RationalPoint> points) {
  std::sort(points.begin(), points.end(), [](const RationalPoint& a, const RationalPoint& b) {
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  DualHull dual;
  dual.halfspaces = facets_of(points);
  dual.witness.resize(dual.halfspaces.size());
  const auto normal = [&](HalfspaceId i) -> const IntegerVector3& {
    return dual.halfspaces[i.index()].normal();
  };
  for (const RationalPoint& p : points) {
    std::vector<HalfspaceId> around;
    for (std::size_t i = 0; i < dual.halfspaces.size(); ++i) {
      if (dual.halfspaces[i](p) == 0) around.emplace_back(i);
    }
    if (around.size() < 3) continue;  // inside a facet or an edge
    std::sort(around.begin() + 1, around.end(), [&](HalfspaceId a, HalfspaceId b) {
      return normal(around[0]).dot(normal(a).cross(normal(b))) > 0;
    });
    for (const HalfspaceId i : around) {
      dual.witness[i.index()] = static_cast<std::uint32_t>(dual.vertices.size());
    }
    dual.vertices.push_back(p);
    for (std::size_t t = 2; t < around.size(); ++t) {
      dual.triangles.push_back({around[0], around[t - 1], around[t]});
    }
  }
  return dual;
}

}  // namespace definition
