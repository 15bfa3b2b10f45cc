// SPDX-License-Identifier: MIT
// What the methods propose: judged by the definition of containment, by closed forms, and where a
// method is known to fail.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "compared_hulls.hpp"
#include "convexact/shapes.hpp"
#include "shapes/makers.hpp"
#include "sweep.hpp"
using namespace convexact;
using support::ComparedHull;
using support::method;
using support::refit_of;

namespace {

// The solids of the families with volume, small enough for every method.
std::vector<std::pair<std::string, std::vector<Point>>> small_shapes() {
  std::vector<std::pair<std::string, std::vector<Point>>> list;
  for (const shapes::Family& family : shapes::families()) {
    if (family.dimension != 3) continue;
    std::vector<double> values = shapes::usual_values(family);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::string_view name = family.parameters[i].name;
      if (name == "points" || name == "k") values[i] = std::min(values[i], 24.0);
    }
    list.emplace_back(family.name, shapes::generate(family, values, 5));
  }
  return list;
}

bool is_removal(const Method& method) {
  return method.name == "random" || method.name == "search" || method.name.starts_with("greedy");
}

bool is_bounded_without(const Normals& normals, std::size_t left_out) {
  std::vector<Halfspace> halfspaces;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    if (i != left_out) halfspaces.emplace_back(normals[i], Rational(-1));
  }
  return std::holds_alternative<BoundedProof>(find_recession(halfspaces));
}

// The directions without their lengths.
std::vector<Halfspace> directions(const Normals& normals) {
  std::vector<Halfspace> list;
  for (const RationalVector3& normal : normals) list.emplace_back(normal, Rational(0));
  return list;
}

// 60 points spread over the unit sphere and, if asked for, 2,000 within 20 degrees of +z.
std::vector<Point> sphere_with_patch(bool with_patch) {
  std::vector<Point> points = shapes::fibonacci_sphere(60);
  if (!with_patch) return points;
  const double lowest = std::cos(20 * std::acos(-1.0) / 180);
  for (int i = 0; i < 2000; ++i) {
    const double z = 1 - (1 - lowest) * (i + 0.5) / 2000, r = std::sqrt(1 - z * z);
    const double angle = 2.39996322972865332 * i;  // the golden angle
    points.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
  }
  return points;
}

}  // namespace

TEST_CASE("methods: every solid holds every point, in at most so many planes" * sweep) {
  for (const auto& shape : small_shapes()) {
    const std::vector<Point>& points = shape.second;
    CAPTURE(shape.first);
    const ComparedHull compared(points);
    for (const Method& each : methods()) {
      CAPTURE(std::string(each.name));
      for (const std::size_t faces : {6u, 12u, 19u}) {
        if (!each.takes_faces && faces != 6) continue;
        const bool is_large = compared.solid.polytope.facets.size() > 40;
        if (each.name == "search" && (faces != 12 || is_large)) continue;  // takes the most time
        CAPTURE(faces);
        const Normals normals = each.propose(compared.hull, faces, 3);
        // Linear programs without a solution may keep edges.
        if (each.takes_faces && normals.size() > faces && each.name != "tlg") {
          // Only where no removal is bounded any more.
          CHECK(is_removal(each));
          for (std::size_t i = 0; i < normals.size(); ++i) {
            CHECK_FALSE(is_bounded_without(normals, i));
          }
        }
        const auto outcome = compared.fit(normals);
        const auto* refit = std::get_if<Refit>(&outcome);
        if (refit == nullptr) {
          CHECK_FALSE(is_bounded_without(normals, normals.size()));
          continue;
        }
        CHECK(refit->solid.planes.size() <= normals.size());
        CHECK(refit->volume_ratio >= 1);
        bool holds_all = true;
        for (const Point& p : points) {
          for (const Halfspace& plane : refit->solid.planes) {
            holds_all = holds_all && plane(to_rational(p)) <= 0;
          }
        }
        CHECK(holds_all);
      }
    }
  }
}

TEST_CASE("methods: the same seed proposes the same, and the hull's place and size do not matter") {
  std::vector<Point> points = shapes::fibonacci_sphere(80), moved = points;
  for (Point& p : points)
    p = Point(std::round(p.x() * 512), std::round(p.y() * 512), std::round(p.z() * 512));
  for (std::size_t i = 0; i < points.size(); ++i)
    moved[i] = points[i] * 0x1p-20 + Point(1024, 7, -3);
  const ComparedHull here(points), there(moved);
  for (const Method& each : methods()) {
    CAPTURE(std::string(each.name));
    const Normals first = each.propose(here.hull, 10, 4);
    CHECK(first == each.propose(here.hull, 10, 4));
    CHECK(directions(first) == directions(each.propose(there.hull, 10, 4)));
  }
  for (const Method& each : inner_methods()) {
    CAPTURE(std::string(each.name));
    CHECK(each.select(here.hull, 10, 4) == each.select(there.hull, 10, 4));
  }
  CHECK(method("random").propose(here.hull, 10, 4) != method("random").propose(here.hull, 10, 5));
}

TEST_CASE("obb: a rotated box is found but for rounding") {
  // Sides 2, 4, 6 along the columns of two rotations with entries in fifths, times 25: integers.
  const int axes[3][3] = {{15, 20, 0}, {-16, 12, 15}, {12, -9, 20}};
  std::vector<Point> points;
  for (const int a : {-1, 1}) {
    for (const int b : {-2, 2}) {
      for (const int c : {-3, 3}) {
        points.emplace_back(a * axes[0][0] + b * axes[1][0] + c * axes[2][0],
                            a * axes[0][1] + b * axes[1][1] + c * axes[2][1],
                            a * axes[0][2] + b * axes[1][2] + c * axes[2][2]);
      }
    }
  }
  const ComparedHull box(points);
  const Refit refit = refit_of(box, "obb");
  CHECK(refit.volume_ratio >= 1);
  CHECK(refit.volume_ratio <= parse_rational("1.000001"));
  CHECK(refit_of(box, "aabb").volume_ratio > 2);
  // Exactly at right angles.
  const Normals axis = method("obb").propose(box.hull, 6, 1);
  CHECK(axis[0].dot(axis[2]) == 0);
  CHECK(axis[2].dot(axis[4]) == 0);
  CHECK(axis[4].dot(axis[0]) == 0);
}

TEST_CASE("mck: with room for every vertex it is the hull") {
  for (const auto& points : {shapes::octahedron(), shapes::fibonacci_sphere(40)}) {
    const ComparedHull hull(points);
    CHECK(refit_of(hull, "mck", 2 * points.size()).volume_ratio == 1);
    // Triangles all: 2 n - 4 of them, and not one more is needed.
    CHECK(refit_of(hull, "mck", 2 * points.size() - 4).volume_ratio == 1);
  }
}

TEST_CASE("mck: planes and lines of vertices at the start are no tetrahedron's, nor a failure") {
  // A square pyramid: the extreme pair, the farthest vertex and one more are coplanar at first.
  const ComparedHull pyramid(
      std::vector<Point>{{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}, {0, 0, 1}});
  CHECK(refit_of(pyramid, "mck", 6).volume_ratio == 1);
}

TEST_CASE("stl: with a cluster for every facet it is the hull but for rounding") {
  const ComparedHull hull(shapes::fibonacci_sphere(30));
  const Rational ratio = refit_of(hull, "stl", 100).volume_ratio;
  CHECK(ratio >= 1);
  CHECK(ratio <= parse_rational("1.000001"));
}

TEST_CASE("stl: a dense patch draws its planes, greedy by volume ignores it") {
  const ComparedHull even(sphere_with_patch(false)), dense(sphere_with_patch(true));
  const auto growth = [](const ComparedHull& hull, const char* name) {
    return to_double(refit_of(hull, name).volume_ratio, Rounding::Nearest) - 1;
  };
  const double stl_even = growth(even, "stl"), stl_dense = growth(dense, "stl");
  const double greedy_even = growth(even, "greedy"), greedy_dense = growth(dense, "greedy");
  CHECK(stl_dense > 1.5 * stl_even);
  CHECK(greedy_dense < 1.1 * greedy_even);
}

TEST_CASE("removals: greedy is least by its own measure, search is not above it, random is above") {
  const ComparedHull hull(shapes::fibonacci_sphere(100));
  const Refit by_volume = refit_of(hull, "greedy"), by_area = refit_of(hull, "greedy-area"),
              by_width = refit_of(hull, "greedy-mean-width");
  CHECK(refit_of(hull, "search").volume_ratio <= by_volume.volume_ratio);
  CHECK(by_volume.volume_ratio < refit_of(hull, "random").volume_ratio);
  CHECK(by_volume.solid.planes.size() == 18);
  CHECK(by_area.solid.planes.size() == 18);
  CHECK(by_width.solid.planes.size() == 18);
}

TEST_CASE("inner methods: at most so many vertices of the hull, whose hull lies inside") {
  for (const auto& shape : small_shapes()) {
    CAPTURE(shape.first);
    const ComparedHull compared(shape.second);
    const Polytope& hull = compared.solid.polytope;
    for (const Method& each : inner_methods()) {
      CAPTURE(std::string(each.name));
      for (const std::size_t vertices : {4u, 9u, 18u}) {
        CAPTURE(vertices);
        const HullCorners corners = each.select(compared.hull, vertices, 3);
        CHECK(corners.size() == std::min(vertices, hull.vertices.size()));
        const auto outcome = compared.inside(corners);
        const auto* inside = std::get_if<Refit>(&outcome);
        if (inside == nullptr) {
          CHECK(each.name == "qem-ends");  // a removal that leaves a flat set costs all the volume
          continue;
        }
        CHECK(inside->volume_ratio <= 1);
        CHECK((inside->volume_ratio == 1) == (vertices >= hull.vertices.size()));
        for (const RationalPoint& p : inside->solid.vertices) {
          CHECK(std::count(hull.vertices.begin(), hull.vertices.end(), p) == 1);
          for (const Halfspace& plane : hull.planes) CHECK(plane(p) <= 0);
        }
      }
    }
  }
}

// Each removal of a corner of a cube loses a sixth, if none of its neighbours went before: a third
// is left of it.
TEST_CASE("drop: of a cube the corners of a regular tetrahedron are left") {
  const ComparedHull cube(shapes::cube());
  for (const std::size_t vertices : {4u, 5u, 6u, 7u, 8u}) {
    const auto outcome = cube.inside(inner_methods()[0].select(cube.hull, vertices, 1));
    CHECK(std::get<Refit>(outcome).volume_ratio == 1 - Rational(8 - vertices) / 6);
  }
}
