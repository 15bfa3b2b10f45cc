// SPDX-License-Identifier: MIT
// Refits by closed forms, k-DOPs of the shipped meshes against a prototype in rationals, and
// proposals that bound nothing.
#include <doctest/doctest.h>

#include <array>

#include "compared_hulls.hpp"
#include "convexact/io.hpp"
#include "expect_error.hpp"
#include "process.hpp"
#include "shapes/makers.hpp"
using namespace convexact;
using support::ComparedHull;
using support::refit_of;

TEST_CASE("refit: every box and k-DOP of a cube is the cube") {
  const ComparedHull cube(shapes::cube());
  for (const char* name : {"aabb", "kdop14", "kdop18", "kdop26", "obb"}) {
    CAPTURE(name);
    const Refit refit = refit_of(cube, name);
    CHECK(refit.volume_ratio == 1);
    CHECK(refit.area_ratio.contains(1));
    CHECK(refit.mean_width_ratio.contains(1));
    CHECK(refit.squared_distance_ratio == 0);
    CHECK(refit.solid.planes.size() == 6);  // what touches edges and corners is redundant
  }
}

TEST_CASE("refit: boxes and k-DOPs of an octahedron have the volumes of closed forms") {
  const ComparedHull octahedron(shapes::octahedron());
  // The cube, 8 over 4/3. From its corner to the plane x + y + z = 1 it is 2/sqrt(3), over a
  // diameter of sqrt(12).
  const Refit cube = refit_of(octahedron, "aabb");
  CHECK(cube.volume_ratio == 6);
  CHECK(cube.squared_distance_ratio == Rational(1) / 9);
  // 24 over 8 triangles with edges sqrt(2): sqrt(12) in all.
  CHECK(ratios_of(cube).area == doctest::Approx(24 / std::sqrt(48.0)).epsilon(1e-14));
  CHECK(refit_of(octahedron, "kdop14").volume_ratio == 1);  // its own facets
  // |x| + |y|, |y| + |z|, |z| + |x| <= 1: the rhombic dodecahedron with volume 2.
  const Refit rhombic = refit_of(octahedron, "kdop18");
  CHECK(rhombic.volume_ratio == Rational(3) / 2);
  CHECK(rhombic.solid.planes.size() == 12);
}

TEST_CASE("refit: k-DOPs of the shipped meshes have the printed volumes of a prototype") {
  // From a prototype in rationals that shares no code with the program; half a unit of the last of
  // its digits.
  struct Printed {
    const char* mesh;
    std::array<const char*, 4> ratios;
  };
  const Rational half_a_unit = parse_rational("0.000005");
  const Printed printed[] = {{"spot.obj", {"2.15737", "1.45869", "1.43889", "1.33176"}},
                             {"teapot.obj", {"2.49164", "1.54937", "1.44181", "1.33887"}},
                             {"bunny.obj", {"2.32015", "1.63394", "1.54269", "1.43332"}}};
  for (const Printed& of : printed) {
    CAPTURE(of.mesh);
    const ComparedHull hull(read_mesh(support::data(of.mesh)).points);
    std::size_t k = 0;
    for (const char* name : {"aabb", "kdop14", "kdop18", "kdop26"}) {
      CAPTURE(name);
      const Rational gap = refit_of(hull, name).volume_ratio - parse_rational(of.ratios[k++]);
      CHECK(abs(gap) <= half_a_unit);
    }
  }
}

TEST_CASE("refit: directions that bound nothing are told with a way out, and zero is refused") {
  const ComparedHull cube(shapes::cube());
  const Normals corner{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const auto open = cube.fit(corner);
  REQUIRE(std::holds_alternative<RecessionRay>(open));
  const RationalVector3 way = std::get<RecessionRay>(open).direction;
  CHECK_FALSE(way.isZero());
  for (const RationalVector3& normal : corner) CHECK(normal.dot(way) <= 0);
  CHECK(std::holds_alternative<RecessionRay>(cube.fit({})));
  CHECK(error_of([&] { return cube.fit({{0, 0, 0}}); }).code() == ErrorCode::InvalidArgument);
}

TEST_CASE("refit: repeats and lengths of directions do not matter") {
  const ComparedHull cube(shapes::cube());
  Normals normals;
  for (const RationalVector3& normal : support::method("aabb").propose(cube.hull, 6, 1)) {
    normals.push_back(normal);
    normals.push_back(normal * parse_rational("7/3"));
  }
  const auto outcome = cube.fit(normals);
  CHECK(std::get<Refit>(outcome).volume_ratio == 1);
}

TEST_CASE("refit: the hull of selected corners, by closed forms") {
  const ComparedHull cube(shapes::cube());
  const std::vector<RationalPoint>& vertices = cube.solid.polytope.vertices;
  HullCorners even, all, side;
  for (std::uint32_t v = 0; v < 8; ++v) {
    const RationalPoint& p = vertices[v];
    all.push_back(v);
    if (p.x() * p.y() * p.z() > 0) even.push_back(v);
    if (p.x() > 0) side.push_back(v);
  }
  // A corner is 2/sqrt(3) away from the regular tetrahedron of the others, over sqrt(12).
  const Refit tetrahedron = std::get<Refit>(cube.inside(even));
  CHECK(tetrahedron.volume_ratio == Rational(1) / 3);
  CHECK(tetrahedron.squared_distance_ratio == Rational(1) / 9);
  CHECK(ratios_of(tetrahedron).area == doctest::Approx(1 / std::sqrt(3.0)).epsilon(1e-14));
  CHECK(tetrahedron.solid.vertices.size() == 4);
  all.push_back(0);  // repeats do not matter
  CHECK(std::get<Refit>(cube.inside(all)).volume_ratio == 1);
  CHECK(std::holds_alternative<FlatSelection>(cube.inside(side)));
  CHECK(std::holds_alternative<FlatSelection>(cube.inside({0, 3, 5})));
  CHECK(error_of([&] { return cube.inside({0, 1, 2, 8}); }).code() == ErrorCode::InvalidArgument);
}

TEST_CASE("refit: rational input is held exactly") {
  // A tetrahedron whose corners are no doubles, in a box with sides 1/3, 1/7 and 1/11.
  const Rational x = parse_rational("1/3"), y = parse_rational("1/7"), z = parse_rational("1/11");
  const ComparedHull hull(
      PointSet(std::vector<RationalPoint>{{0, 0, 0}, {x, 0, 0}, {0, y, 0}, {0, 0, z}}));
  CHECK(refit_of(hull, "aabb").volume_ratio == 6);
}
