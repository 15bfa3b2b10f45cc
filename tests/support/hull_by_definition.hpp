// SPDX-License-Identifier: MIT
// hull_by_definition.hpp - the facets of a small hull straight from the definition, O(n^4).
#pragma once
#include <array>
#include <set>
#include <vector>

#include "convexact/geometry/halfspace.hpp"
#include "convexact/geometry/point_set.hpp"

/// Every plane through three points that has all points on one side, as an outward halfspace.
/// Rationals only.
inline std::set<convexact::Halfspace> facets_by_definition(const convexact::PointSet& points) {
  using namespace convexact;
  std::vector<RationalPoint> p;
  for (std::size_t i = 0; i < points.size(); ++i) p.push_back(points[PointId(i)]);
  std::set<Halfspace> facets;
  for (std::size_t a = 0; a < p.size(); ++a) {
    for (std::size_t b = a + 1; b < p.size(); ++b) {
      for (std::size_t c = b + 1; c < p.size(); ++c) {
        const RationalVector3 u = p[b] - p[a], v = p[c] - p[a];
        RationalVector3 normal = u.cross(v);
        bool below = false, beyond = false;
        for (const RationalPoint& x : p) {
          const Rational height = normal.dot(RationalVector3(x - p[a]));
          below = below || height < 0;
          beyond = beyond || height > 0;
          if (below && beyond) break;
          if (below && beyond) break;
        }
        if (below == beyond) continue;  // both: no facet; neither: collinear or flat
        if (beyond) normal = -normal;
        facets.emplace(normal, Rational(-normal.dot(p[a])));
      }
    }
  }
  return facets;
}
