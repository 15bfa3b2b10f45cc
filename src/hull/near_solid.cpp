// SPDX-License-Identifier: MIT
#include "hull/near_solid.hpp"

#include "convexact/hull.hpp"

namespace convexact {
namespace {

// Newell's: twice the area vector of a polygon.
Point area_of(std::span<const PointId> facet, std::span<const Point> points) {
  Point sum = Point::Zero();
  const Point& first = points[facet[0].index()];
  for (std::size_t k = 2; k < facet.size(); ++k) {
    const Point a = points[facet[k - 1].index()] - first, b = points[facet[k].index()] - first;
    sum += a.cross(b);
  }
  return sum;
}

}  // namespace

NearSolid near_solid(std::span<const Point> points) {
  const PointSet set(std::vector<Point>(points.begin(), points.end()));
  NearSolid made;
  const HullOutcome outcome = convex_hull(set);
  const auto* hull = std::get_if<Hull>(&outcome);
  if (hull == nullptr) {
    made.vertices.assign(points.begin(), points.end());
    return made;
  }
  for (const PointId p : hull->vertices) made.vertices.push_back(points[p.index()]);
  const Point origin = made.vertices.front();
  for (std::size_t f = 0; f < hull->facets.size(); ++f) {
    const Point area = area_of(hull->facets[f], points);
    made.volume += area.dot(points[hull->facets[f][0].index()] - origin) / 6;
    const double length = area.norm();
    if (!(length > 0)) continue;
    const Point normal = area / length;
    // With u = 2^-53: a cross product of differences of at most 4 is off by 100 u, so the normal is
    // off by as much for each triangle, over the length; and vertices are at most 8 away.
    const double error = 0x1p-43 * static_cast<double>(hull->facets[f].size()) / length;
    made.planes.push_back({normal, -normal.dot(points[hull->facets[f][0].index()]), error});
  }
  return made;
}

}  // namespace convexact
