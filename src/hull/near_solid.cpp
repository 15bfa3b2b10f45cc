// SPDX-License-Identifier: MIT
#include "hull/near_solid.hpp"

#include "convexact/hull.hpp"

namespace convexact {
namespace {

// Of a polygon, twice.
struct Area {
  Point vector = Point::Zero();
  /// With u = 2^-53 and n corners, the vector is off by at most (n + 4) u spread.
  double spread = 0;
};

// Newell's. A component of the cross product of differences a and b is off by at most 4 u times the
// sum of the two products; so the vector is off by less than 6 u |a| |b|, and the n - 2 of them by
// n - 3 times u times the sum of all |a| |b| when they are added.
Area area_of(std::span<const PointId> facet, std::span<const Point> points) {
  Area area;
  const Point& first = points[facet[0].index()];
  for (std::size_t k = 2; k < facet.size(); ++k) {
    const Point a = points[facet[k - 1].index()] - first, b = points[facet[k].index()] - first;
    area.vector += a.cross(b);
    area.spread += a.norm() * b.norm();
  }
  return area;
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
    const Area area = area_of(hull->facets[f], points);
    made.volume += area.vector.dot(points[hull->facets[f][0].index()] - origin) / 6;
    const double length = area.vector.norm();
    if (!(length > 0)) continue;
    const Point normal = area.vector / length;
    // A vertex is less than 7 away from the facet, and beyond it by as much times the error of the
    // vector over its length. All other roundings are of numbers up to 4, and fewer than 64.
    const double error =
        0x1p-50 * static_cast<double>(hull->facets[f].size() + 4) * area.spread / length + 0x1p-45;
    made.planes.push_back({normal, -normal.dot(points[hull->facets[f][0].index()]), error});
  }
  return made;
}

}  // namespace convexact
