// SPDX-License-Identifier: MIT
// Locating points over the triangles of a hull. By definition a point is outside if and only if it
// is strictly beyond the plane of a facet; facet_halfspaces() and rationals decide that here.
#include <doctest/doctest.h>

#include <algorithm>

#include "oracle/solid/second_way.hpp"
#include "shapes/makers.hpp"

using namespace convexact;
using oracle::ConeLocation;

namespace {

void check_all(const PointSet& mesh, const PointSet& points) {
  const HullOutcome outcome = convex_hull(mesh);
  const Hull& hull = std::get<Hull>(outcome);
  const std::vector<Halfspace> planes = facet_halfspaces(hull, mesh);
  std::uint32_t triangles = 0;
  for (std::size_t f = 0; f < hull.facets.size(); ++f) {
    triangles += static_cast<std::uint32_t>(hull.facets[f].size() - 2);
  }
  const ConeLocation cones(hull, mesh, points);
  for (std::size_t p = 0; p < points.size(); ++p) {
    const bool is_outside = std::any_of(planes.begin(), planes.end(), [&](const Halfspace& plane) {
      return plane(points[PointId(p)]) > 0;
    });
    for (std::uint32_t start = 0; start < triangles; start += 1 + triangles / 5) {
      CHECK(cones.is_outside(p, cones.locate(p, start)) == is_outside);
    }
  }
}

std::vector<Point> together(std::vector<Point> a, const std::vector<Point>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

}  // namespace

TEST_CASE("cone location: every point has its verdict, from every start (#13)") {
  const std::vector<Point> around = shapes::lattice(80, 2, 5);
  for (const auto& mesh : {shapes::cube(), shapes::tetrahedron(), shapes::prism(40),
                           shapes::rounded_dodecahedron(), shapes::lattice(30, 2, 3)}) {
    check_all(PointSet(mesh), PointSet(together(around, mesh)));
  }
}

TEST_CASE("cone location: thin, tiny, huge and far solids, and points an ulp away (#13)") {
  for (const auto& mesh :
       {shapes::needle(30, 1e300, 1), shapes::slab(30, 1e16, 1), shapes::subnormal(20, 9, 1),
        shapes::huge(20, 1), shapes::offset_ball(30, 1e15, 1), shapes::nearly_flat(20, 1, 1),
        shapes::wide_exponents(20, 200, 1)}) {
    std::vector<Point> points = mesh;
    for (const Point& p : mesh) {
      for (const double towards : {0.0, p.x() > 0 ? 1e308 : -1e308}) {
        points.emplace_back(std::nextafter(p.x(), towards), p.y(), p.z());
      }
    }
    check_all(PointSet(mesh), PointSet(points));
  }
}

TEST_CASE("cone location: coordinates that are no doubles (#13)") {
  std::vector<RationalPoint> thirds;
  for (const Point& p : shapes::lattice(25, 4, 1)) thirds.push_back(to_rational(p) / Rational(3));
  const PointSet mesh(thirds);
  check_all(mesh, mesh);
  check_all(mesh, PointSet(shapes::lattice(40, 1, 2)));
  check_all(PointSet(shapes::cube()), mesh);
}
