// SPDX-License-Identifier: MIT
// definitional_dual.hpp - the dual hull of a few points straight from the definition: the
// supporting planes, sorted around each vertex.
#pragma once
#include <algorithm>
#include <vector>

#include "convexact/dual.hpp"
#include "supporting_planes.hpp"

namespace definition {

using namespace convexact;

/// The dual hull of points that span a volume; repeats allowed.
inline DualHull dual_of_points(std::vector<RationalPoint> points) {
  std::sort(points.begin(), points.end(), [](const RationalPoint& a, const RationalPoint& b) {
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  DualHull dual;
  dual.halfspaces = supporting_planes(points);
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
