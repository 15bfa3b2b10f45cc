// SPDX-License-Identifier: MIT
// Third-party truth: the facets of CGAL's convex_hull_3 in exact rationals. Exits with 77 (skipped)
// where CGAL is not installed.
#include <cstdio>

#ifndef CONVEXACT_HAVE_CGAL
int main() {
  std::puts("skipped: CGAL not installed");
  return 77;
}
#else
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cstdlib>
#include <set>
#include <string>

#include "checked_hull.hpp"
#include "convexact/io/read_mesh.hpp"
#include "convexact/shapes/boxes.hpp"
#include "convexact/shapes/extreme.hpp"
#include "convexact/shapes/prisms.hpp"
#include "convexact/shapes/random_points.hpp"

using namespace convexact;

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;

RationalPoint to_ours(const Kernel::Point_3& p) {
  // The points of a hull are input points, so doubles.
  return to_rational(Point(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())));
}

// CGAL's facets are triangles or coplanar pieces; as halfspaces they merge.
std::set<Halfspace> facets_of_cgal(const PointSet& points) {
  std::vector<Kernel::Point_3> list;
  for (const Point& p : points.doubles()) list.emplace_back(p.x(), p.y(), p.z());
  CGAL::Surface_mesh<Kernel::Point_3> mesh;
  CGAL::convex_hull_3(list.begin(), list.end(), mesh);
  std::set<Halfspace> facets;
  for (const auto face : mesh.faces()) {
    std::vector<RationalPoint> corners;
    for (const auto v : vertices_around_face(mesh.halfedge(face), mesh))
      corners.push_back(to_ours(mesh.point(v)));
    facets.insert(Halfspace::through(corners[0], corners[1], corners[2]));
  }
  return facets;
}

void compare(const std::vector<Point>& list) {
  const PointSet points(list);
  CHECK(facet_set(checked_hull(points), points) == facets_of_cgal(points));
}

}  // namespace

TEST_CASE("convex_hull and CGAL: families of shapes") {
  compare(shapes::grid(6));
  compare(shapes::lattice(500, 8, 1));
  compare(shapes::in_ball(2000, 1));
  compare(shapes::fibonacci_sphere(2000));
  compare(shapes::rounded_box(Point(1, 2, 3), 0.25, 6));
  compare(shapes::prism(500));
  compare(shapes::cylinder(100, 3));
  compare(shapes::needle(500, 1e12, 1));
  compare(shapes::offset_ball(500, 1e8, 1));
  compare(shapes::nearly_coplanar(500, 1));
  compare(shapes::nearly_flat(500, 1));
}

TEST_CASE("convex_hull and CGAL: the shipped meshes") {
  for (const char* name : {"bunny.obj", "spot.obj", "teapot.obj"}) {
    CAPTURE(name);
    const Mesh mesh = read_mesh(std::string(std::getenv("CONVEXACT_TEST_DATA")) + "/" + name);
    CHECK(facet_set(checked_hull(mesh.points), mesh.points) == facets_of_cgal(mesh.points));
  }
}
#endif
