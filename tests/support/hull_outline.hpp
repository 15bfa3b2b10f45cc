// SPDX-License-Identifier: MIT
// hull_outline.hpp - the data in which two hull programs must agree: the planes of the facets, and
// the points where three of them meet.
#pragma once
#include <algorithm>
#include <array>
#include <vector>

#include "convexact/hull.hpp"

/// Both sorted, each entry once.
struct HullOutline {
  std::vector<convexact::Halfspace> planes;
  std::vector<std::array<convexact::Rational, 3>> vertices;
};

inline HullOutline outline_of(const convexact::Hull& hull, const convexact::PointSet& points) {
  using namespace convexact;
  HullOutline outline;
  outline.planes = facet_halfspaces(hull, points);
  std::sort(outline.planes.begin(), outline.planes.end());
  for (const PointId id : hull.vertices) {
    const RationalPoint p = points[id];
    outline.vertices.push_back({p[0], p[1], p[2]});
  }
  std::sort(outline.vertices.begin(), outline.vertices.end());
  return outline;
}
