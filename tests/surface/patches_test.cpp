// SPDX-License-Identifier: MIT
// Which triangles cross others, by the definition, and the volumes of boxes that overlap, by
// counting cells.
#include "surface/patches.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>

#include "cells.hpp"
#include "convexact/overlay.hpp"
#include "number/random.hpp"
#include "surface/common_point.hpp"
using namespace convexact;

namespace {

// Two triangles have a common point iff the origin is a difference of two of their points: in the
// hull of the differences of their corners.
bool have_common_point_by_definition(const PointSet& points, const Triangle& s, const Triangle& t) {
  std::vector<RationalPoint> differences;
  for (const PointId a : s) {
    for (const PointId b : t) differences.emplace_back(points[a] - points[b]);
  }
  return holds(convex_part(PointSet(differences)), RationalPoint::Zero());
}

Triangle any_triangle(Random& random, std::size_t points) {
  Triangle t;
  for (PointId& p : t) p = PointId(uniform_below(random, points));
  return t;
}

// Distinct points of a small grid, so that triangles are often coplanar, touch or have no area.
PointSet grid_points(Random& random) {
  std::vector<Point> points;
  for (int k = 0; k < 8; ++k) {
    const auto x = [&] { return static_cast<double>(uniform_below(random, 4)); };
    const Point p(x(), x(), k % 2 == 0 ? 0 : x());
    if (std::find(points.begin(), points.end(), p) == points.end()) points.push_back(p);
  }
  return PointSet(points);
}

struct BoxWorld {
  Mesh mesh;
  std::size_t cells;  // that are held
};

// Boxes of a small grid; some of them are copies of others.
BoxWorld boxes_of_cells(Random& random, std::size_t count) {
  std::vector<support::Box> boxes;
  for (std::size_t k = 0; k < count; ++k) {
    if (k % 4 == 3) {
      boxes.push_back(boxes[uniform_below(random, k)]);
      continue;
    }
    support::Box& box = boxes.emplace_back();
    for (int axis = 0; axis < 3; ++axis) {
      box.low[axis] = static_cast<double>(uniform_below(random, 4));
      box.high[axis] = box.low[axis] + 1 + static_cast<double>(uniform_below(random, 3));
    }
  }
  BoxWorld world{{}, 0};
  std::vector<Point> points;
  for (const support::Box& box : boxes) {
    const auto first = static_cast<std::uint32_t>(points.size());
    for (const Point& corner : support::box_corners(box)) points.push_back(corner);
    for (std::vector<std::uint32_t> face : support::box_faces()) {
      for (std::uint32_t& corner : face) corner += first;
      world.mesh.polygons.push_back(std::move(face));
    }
  }
  world.mesh.points = PointSet(points);
  for (int cell = 0; cell < 6 * 6 * 6; ++cell) {
    const std::array<double, 3> low = {double(cell % 6), double(cell / 6 % 6), double(cell / 36)};
    world.cells += std::any_of(boxes.begin(), boxes.end(), [&](const support::Box& box) {
      return box.low[0] <= low[0] && low[0] < box.high[0] && box.low[1] <= low[1] &&
             low[1] < box.high[1] && box.low[2] <= low[2] && low[2] < box.high[2];
    });
  }
  return world;
}

}  // namespace

TEST_CASE("common points: by the hull of differences, for triangles of a small grid") {
  Random random(7);
  std::size_t meet = 0, coplanar = 0;
  for (int round = 0; round < 1500; ++round) {
    const PointSet points = grid_points(random);
    const Triangle s = any_triangle(random, points.size()), t = any_triangle(random, points.size());
    const bool expected = have_common_point_by_definition(points, s, t);
    CHECK(have_common_point(points, s, t) == expected);
    CHECK(have_common_point(points, t, s) == expected);
    meet += expected;
    coplanar += std::all_of(s.begin(), s.end(), [&](PointId p) {
      return orient(points, t[0], t[1], t[2], p) == Sign::Zero;
    });
  }
  CHECK(meet > 300);
  CHECK(meet < 1200);
  CHECK(coplanar > 100);
}

TEST_CASE("patches: a triangle is crossed iff it meets one elsewhere than at common corners") {
  Random random(8);
  std::size_t crossed = 0, plain = 0;
  for (int round = 0; round < 60; ++round) {
    const Surface surface = make_surface(boxes_of_cells(random, 1 + round % 5).mesh);
    const Patches patches = find_patches(surface);
    for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
      bool expected = false;
      for (std::uint32_t s = 0; s < surface.triangles.size() && !expected; ++s) {
        expected = s != t && cross(surface.points, surface.triangles[s], surface.triangles[t]);
      }
      CHECK(patches.is_crossed[t] == expected);
      ++(expected ? crossed : plain);
    }
  }
  CHECK(crossed > 100);
  CHECK(plain > 100);
}

TEST_CASE("solid_volume: overlapping, touching and repeated boxes, by counting cells") {
  Random random(9);
  for (int round = 0; round < 40; ++round) {
    const BoxWorld world = boxes_of_cells(random, 1 + round % 8);
    const Surface surface = make_surface(world.mesh, {.orient = Orient::Keep});
    CHECK(*solid_volume(surface, 64, true).exact == Rational(world.cells));
  }
}

TEST_CASE("patches: in a mesh without crossings, a single patch for each component") {
  const Mesh cubes = support::mesh_of_cells({{0, 0, 0}, {5, 0, 0}, {5, 1, 0}});
  const Surface surface = make_surface(cubes);
  const Patches patches = find_patches(surface);
  std::vector<std::uint32_t> roots = patches.patch;
  std::sort(roots.begin(), roots.end());
  roots.erase(std::unique(roots.begin(), roots.end()), roots.end());
  CHECK(roots.size() == 2);
  CHECK(std::count(patches.is_crossed.begin(), patches.is_crossed.end(), true) == 0);
}

TEST_CASE(
    "without_inner_triangles: of cubes around one center the outermost is left, sheets stay") {
  Mesh mesh;
  std::vector<Point> points;
  const auto add = [&](const support::Box& box) {
    const auto first = static_cast<std::uint32_t>(points.size());
    for (const Point& corner : support::box_corners(box)) points.push_back(corner);
    for (std::vector<std::uint32_t> face : support::box_faces()) {
      for (std::uint32_t& corner : face) corner += first;
      mesh.polygons.push_back(std::move(face));
    }
    mesh.points = PointSet(points);
  };
  for (const double half : {1.0, 2.0, 3.0}) add({{-half, -half, -half}, {half, half, half}});
  const Surface nested = make_surface(mesh, {.orient = Orient::Keep});
  const std::vector<std::uint32_t> left = without_inner_triangles(nested, Winding(nested));
  CHECK(left.size() == 12);
  for (const std::uint32_t t : left) {
    for (const PointId p : nested.triangles[t]) {
      CHECK(nested.points.doubles()[p.index()].cwiseAbs() == Point(3, 3, 3));
    }
  }
  // A cavity bounds the solid, too; a sheet that the surface passes there and back bounds nothing,
  // and is not inside.
  for (std::size_t f = 0; f < 6; ++f)
    std::reverse(mesh.polygons[f].begin(), mesh.polygons[f].end());
  for (std::size_t f = 6; f < 12; ++f)
    std::reverse(mesh.polygons[f].begin(), mesh.polygons[f].end());
  points.insert(points.end(), {{5, 0, 0}, {6, 0, 0}, {5, 1, 0}});
  mesh.points = PointSet(points);
  mesh.polygons.push_back({24, 25, 26});
  mesh.polygons.push_back({26, 25, 24});
  const Surface hollow = make_surface(mesh, {.orient = Orient::Keep});
  REQUIRE(hollow.is_closed);
  // Winding numbers from outside: 1, 0, -1. Nothing is inside of the solid.
  CHECK(without_inner_triangles(hollow, Winding(hollow)).size() == hollow.triangles.size());
}

TEST_CASE("patches: they end at edges with more than two triangles") {
  // Tetrahedra around a common edge, some inside out: the winding numbers beside their triangles
  // differ. Their other corners are at different distances, so that neighbours in the order of
  // triangles are none around the edge.
  Random random(10);
  for (int round = 0; round < 60; ++round) {
    Mesh mesh;
    std::vector<Point> points{{0, 0, 0}, {0, 0, 1}};
    std::size_t tetrahedra = 0;
    const double kDirections[6][2] = {{4, 1}, {1, 4}, {-2, 3}, {-4, -1}, {-1, -4}, {3, -3}};
    for (std::uint32_t k = 0; k < 6; k += 2) {
      const auto first = static_cast<std::uint32_t>(points.size());
      for (std::uint32_t j = k; j < k + 2; ++j) {
        const double far = 1 + static_cast<double>(uniform_below(random, 8));
        points.emplace_back(far * kDirections[j][0], far * kDirections[j][1], 0.5);
      }
      std::vector<std::vector<std::uint32_t>> faces = {
          {0, 1, first}, {1, 0, first + 1}, {0, first, first + 1}, {1, first + 1, first}};
      const bool is_reversed = uniform_below(random, 2) == 0;
      for (std::vector<std::uint32_t>& face : faces) {
        if (is_reversed) std::reverse(face.begin(), face.end());
        mesh.polygons.push_back(std::move(face));
      }
      ++tetrahedra;
    }
    mesh.points = PointSet(points);
    const Surface surface = make_surface(mesh, {.orient = Orient::Keep});
    REQUIRE(surface.is_closed);
    const Patches patches = find_patches(surface);
    const Winding winding(surface);
    std::map<std::uint32_t, std::pair<long, long>> beside;
    for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
      RationalPoint middle = RationalPoint::Zero();
      for (const PointId p : surface.triangles[t]) middle += surface.points[p] / Rational(3);
      const auto found = winding.beside(TriangleId(t), middle);
      CHECK(beside.try_emplace(patches.patch[t], found).first->second == found);
    }
    CHECK(beside.size() == tetrahedra);
  }
}
