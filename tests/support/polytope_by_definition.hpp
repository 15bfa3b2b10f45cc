// SPDX-License-Identifier: MIT
// polytope_by_definition.hpp - the hull of a few dozen points as a polytope, from the definition.
#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "affine_dimension.hpp"
#include "convexact/geometry/polytope.hpp"
#include "hull_by_definition.hpp"

namespace by_definition {

// Extreme: three facets with independent normals pass through the point.
inline bool is_extreme(const convexact::RationalPoint& x,
                       const std::vector<convexact::Halfspace>& planes) {
  using namespace convexact;
  std::vector<RationalPoint> normals{RationalPoint::Zero()};
  for (const Halfspace& plane : planes) {
    if (plane(x) == 0) normals.push_back(plane.normal().cast<Rational>());
  }
  return affine_dimension(normals) == 3;
}

// The vertices on a plane, counter-clockwise from outside. All others lie within half a turn as
// seen from any one of them, and no three are collinear.
inline std::vector<std::uint32_t> corners(const convexact::Polytope& polytope,
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

}  // namespace by_definition

/// Precondition: the points span a volume. Vertices in the order of the points, repeats dropped.
inline convexact::Polytope polytope_by_definition(const convexact::PointSet& points) {
  using namespace convexact;
  Polytope polytope;
  const std::set<Halfspace> planes = facets_by_definition(points);
  polytope.planes.assign(planes.begin(), planes.end());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const RationalPoint x = points[PointId(i)];
    const auto& known = polytope.vertices;
    if (std::find(known.begin(), known.end(), x) != known.end()) continue;
    if (by_definition::is_extreme(x, polytope.planes)) polytope.vertices.push_back(x);
  }
  for (const Halfspace& plane : polytope.planes) {
    polytope.facets.push_back(by_definition::corners(polytope, plane));
  }
  return polytope;
}
