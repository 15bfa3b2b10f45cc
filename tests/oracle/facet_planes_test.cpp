// SPDX-License-Identifier: MIT
// Faces in facet planes of a hull; expected from which corners the facets have.
#include "oracle/solid/facet_planes.hpp"

#include <doctest/doctest.h>

#include "convexact/geometry.hpp"
#include "geometry/area_vector.hpp"
#include "oracle/solid/mesh_surface.hpp"
#include "shapes/makers.hpp"

using namespace convexact;

namespace {

struct Found {
  bool surely, by_plane;
};

Found find(const PointSet& points, const std::vector<std::uint32_t>& corners) {
  const HullOutcome outcome = convex_hull(points);
  const Hull& hull = std::get<Hull>(outcome);
  const std::vector<Halfspace> planes = facet_halfspaces(hull, points);
  FacetPlanes facet_planes(hull, planes);
  const RationalVector3 n = area_vector(points, corners);
  const Rational offset = -n.dot(points[PointId(corners[0])]);
  return {facet_planes.surely_have(corners, n), facet_planes.have(Halfspace(n, offset))};
}

// Of side 2, point 4 x + 2 y + z.
PointSet cube() {
  std::vector<Point> points;
  for (int i = 0; i < 8; ++i) points.push_back(2 * Point(i >> 2 & 1, i >> 1 & 1, i & 1));
  return PointSet(points);
}

}  // namespace

TEST_CASE("facet planes: a square, and the triangles of its corners") {
  for (const std::vector<std::uint32_t>& face :
       {std::vector<std::uint32_t>{4, 6, 7, 5}, {6, 7, 5, 4}, {4, 6, 7}, {7, 5, 4}}) {
    const Found found = find(cube(), face);
    CHECK(found.surely);
    CHECK(found.by_plane);
  }
  // A triangle that begins with a diagonal is left to its plane.
  CHECK_FALSE(find(cube(), {4, 7, 5}).surely);
  CHECK(find(cube(), {4, 7, 5}).by_plane);
}

TEST_CASE("facet planes: inward, along two facets, and through the solid") {
  for (const std::vector<std::uint32_t>& face :
       {std::vector<std::uint32_t>{5, 7, 6, 4}, {4, 6, 2, 3}, {4, 6, 3, 1}, {1, 2, 4}, {4, 6, 3}}) {
    const Found found = find(cube(), face);
    CHECK_FALSE(found.surely);
    CHECK_FALSE(found.by_plane);
  }
}

TEST_CASE("facet planes: polygons of many corners are left to their plane") {
  std::vector<Point> points;
  std::vector<std::uint32_t> top;
  constexpr int kSides = 12;
  for (int k = 0; k < kSides; ++k) {  // on a parabola, so convex in integers
    for (const int z : {0, 1}) points.push_back(Point(k, k * k, z));
    top.push_back(static_cast<std::uint32_t>(2 * k + 1));
  }
  const Found found = find(PointSet(points), top);
  CHECK_FALSE(found.surely);
  CHECK(found.by_plane);
}
