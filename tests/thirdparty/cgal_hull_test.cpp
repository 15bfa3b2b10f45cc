// SPDX-License-Identifier: MIT
// Hulls against CGAL's convex_hull_3 with exact constructions, third-party truth: the same planes
// and the same vertices on the shipped meshes and on every family of solids. CGAL may cut a facet
// into coplanar triangles; equal planes merge here.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>
#include <doctest/doctest.h>

#include <map>
#include <set>

#include "convexact/io.hpp"
#include "convexact/shapes.hpp"
#include "hull_outline.hpp"
#include "shapes/makers.hpp"
#include "shipped_meshes.hpp"
using namespace convexact;

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;

// CGAL's vertices are input points, so their coordinates are doubles.
RationalPoint to_rational_point(const Kernel::Point_3& p) {
  RationalPoint x;
  for (int k = 0; k < 3; ++k) x[k] = to_rational(CGAL::to_double(p[k]));
  return x;
}

HullOutline hull_of_cgal(const PointSet& points) {
  std::vector<Kernel::Point_3> input;
  for (const Point& p : points.doubles()) input.emplace_back(p[0], p[1], p[2]);
  SurfaceMesh mesh;
  CGAL::convex_hull_3(input.begin(), input.end(), mesh);
  std::set<Halfspace> planes;
  std::map<SurfaceMesh::Vertex_index, std::set<Halfspace> > planes_at;
  for (const auto face : mesh.faces()) {
    std::vector<SurfaceMesh::Vertex_index> corners;
    for (const auto v : CGAL::vertices_around_face(mesh.halfedge(face), mesh)) corners.push_back(v);
    const auto corner = [&](std::size_t i) { return to_rational_point(mesh.point(corners[i])); };
    const Halfspace plane = Halfspace::through(corner(0), corner(1), corner(2));
    planes.insert(plane);
    for (const auto v : corners) planes_at[v].insert(plane);
  }
  HullOutline outline;
  outline.planes.assign(planes.begin(), planes.end());
  for (const auto& [v, at] : planes_at) {
    if (at.size() < 3) continue;  // inside a facet or an edge that CGAL has cut
    const RationalPoint p = to_rational_point(mesh.point(v));
    outline.vertices.push_back({p[0], p[1], p[2]});
  }
  std::sort(outline.vertices.begin(), outline.vertices.end());
  return outline;
}

void check_same_hull(const PointSet& points) {
  const HullOutline ours = outline_of(std::get<Hull>(convex_hull(points)), points);
  const HullOutline theirs = hull_of_cgal(points);
  CHECK(ours.planes.size() == theirs.planes.size());
  CHECK(ours.planes == theirs.planes);
  CHECK(ours.vertices.size() == theirs.vertices.size());
  CHECK(ours.vertices == theirs.vertices);
}

}  // namespace

TEST_CASE("convex_hull: the planes and vertices of CGAL on every shipped mesh") {
  for (const std::string& path : shipped_meshes()) {
    CAPTURE(path);
    check_same_hull(read_mesh(path).points);
  }
}

TEST_CASE("convex_hull: the planes and vertices of CGAL on every family of solids") {
  for (const shapes::Family& family : shapes::families()) {
    if (family.dimension < 3) continue;
    CAPTURE(family.name);
    check_same_hull(PointSet(shapes::generate(family, shapes::usual_values(family))));
  }
}

TEST_CASE("convex_hull: the planes and vertices of CGAL on random lattice points") {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    CAPTURE(seed);
    check_same_hull(PointSet(shapes::lattice(30, 1 + seed % 4, seed)));
  }
}
