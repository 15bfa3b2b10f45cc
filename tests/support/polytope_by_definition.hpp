// SPDX-License-Identifier: MIT
// polytope_by_definition.hpp - the hull of a few dozen points as a polytope, from the definition.
#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "convexact/geometry.hpp"
#include "supporting_planes.hpp"

/// The vertices on a plane, counter-clockwise from outside. All others lie within half a turn as
/// seen from any one of them, and no three are collinear.
inline std::vector<std::uint32_t> corners_on(const convexact::Polytope& polytope,
                                             const convexact::Halfspace& plane) {
  using namespace convexact;
  std::vector<std::uint32_t> list;
  for (std::uint32_t v = 0; v < polytope.vertices.size(); ++v) {
    if (plane(polytope.vertices[v]) == 0) list.push_back(v);
  }
  const RationalPoint& first = polytope.vertices[list.front()];
  const RationalVector3 normal = plane.normal().cast<Rational>();
  std::sort(list.begin() + 1, list.end(), [&](std::uint32_t a, std::uint32_t b) {
    const RationalVector3 u = polytope.vertices[a] - first, v = polytope.vertices[b] - first;
    return normal.dot(u.cross(v)) > 0;
  });
  return list;
}

/// Precondition: the points span a volume. Vertices in the order of the points, repeats dropped.
inline convexact::Polytope polytope_by_definition(const convexact::PointSet& points) {
  using namespace convexact;
  std::vector<RationalPoint> list;
  for (std::size_t i = 0; i < points.size(); ++i) list.push_back(points[PointId(i)]);
  Polytope polytope;
  polytope.planes = supporting_planes(list);
  for (const std::size_t i : extreme_points(list, polytope.planes)) {
    polytope.vertices.push_back(list[i]);
  }
  for (const Halfspace& plane : polytope.planes) {
    polytope.facets.push_back(corners_on(polytope, plane));
  }
  return polytope;
}

/// The polytope of points, by the definition.
inline convexact::Polytope solid(const std::vector<convexact::Point>& points) {
  return polytope_by_definition(convexact::PointSet(points));
}
