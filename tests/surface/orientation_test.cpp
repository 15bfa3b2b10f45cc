// SPDX-License-Identifier: MIT
// Which triangles are turned, and how faces with holes are cut. Volumes are those that the files
// were made with (tests/data/cases/README.md), found by the definition of the solid.
#include "surface/orientation.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <random>
#include <set>

#include "cells.hpp"
#include "defined_solid_volume.hpp"
#include "surface/flat_polygon.hpp"

using namespace convexact;

namespace {

Surface surface_of_case(const std::string& name) {
  const char* folder = std::getenv("CONVEXACT_TEST_DATA");
  REQUIRE(folder != nullptr);
  return make_surface(read_mesh(std::string(folder) + "/cases/" + name));
}

Rational area_of_triangles(const PointSet& points, const std::vector<Triangle>& triangles) {
  Rational twice = 0;
  for (const Triangle& t : triangles) twice += area_vector(points, t)[2];
  return twice / 2;
}

// A polygon in the plane z = 0 by its corners' places in a list of points, which is sorted first.
std::variant<std::vector<Triangle>, NotCut> cut(std::vector<Point> points,
                                                const std::vector<std::size_t>& loop,
                                                Rational* area = nullptr) {
  std::vector<std::size_t> order(points.size()), place(points.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::lexicographical_compare(points[a].begin(), points[a].end(), points[b].begin(),
                                        points[b].end());
  });
  std::vector<Point> sorted;
  for (std::size_t k = 0; k < order.size(); ++k) {
    place[order[k]] = k;
    sorted.push_back(points[order[k]]);
  }
  const PointSet set(sorted);
  std::vector<PointId> corners;
  for (const std::size_t k : loop) corners.emplace_back(place[k]);
  auto clipped = clip_ears(set, corners);
  if (area != nullptr) *area = area_of_triangles(set, std::get<0>(clipped));
  return clipped;
}

// A square of side 4 about one of side 2, and two more points.
const std::vector<Point> kFrame = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {1, 1, 0},
                                   {1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {2, 0, 0}, {2, 1, 0}};

}  // namespace

TEST_CASE("clip_ears: a loop that goes to a hole and back leaves the hole open") {
  Rational area;
  const auto frame = cut(kFrame, {0, 1, 2, 3, 0, 4, 5, 6, 7, 4}, &area);
  CHECK(std::get<0>(frame).size() == 8);
  CHECK(area == 12);
  // The other way around, and from another corner.
  (void)cut(kFrame, {4, 7, 6, 5, 4, 0, 3, 2, 1, 0}, &area);
  CHECK(area == -12);
  (void)cut(kFrame, {5, 6, 7, 4, 0, 1, 2, 3, 0, 4}, &area);
  CHECK(area == 12);
}

TEST_CASE("clip_ears: rings that touch at a corner, and two holes") {
  Rational area;
  // Two triangles that have one corner in common, both counter-clockwise.
  const std::vector<Point> bow = {{0, 0, 0}, {2, -1, 0}, {2, 1, 0}, {-2, 1, 0}, {-2, -1, 0}};
  (void)cut(bow, {0, 1, 2, 0, 3, 4}, &area);
  CHECK(area == 4);
  // From the first corner to the first hole, from that to the second, and back.
  const std::vector<Point> points = {{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0},
                                     {1, 2, 0}, {1, 4, 0}, {2, 4, 0}, {2, 2, 0},
                                     {5, 2, 0}, {5, 4, 0}, {6, 4, 0}, {6, 2, 0}};
  (void)cut(points, {0, 1, 2, 3, 0, 4, 5, 6, 7, 8, 9, 10, 11, 8, 7, 4}, &area);
  CHECK(area == 81 - 4);
}

TEST_CASE("clip_ears: what crosses, winds twice, or bounds nothing is not cut") {
  const auto refused = [](const std::vector<Point>& points, const std::vector<std::size_t>& loop) {
    const auto clipped = cut(points, loop);
    REQUIRE(clipped.index() == 1);
    return std::get<NotCut>(clipped);
  };
  CHECK(refused(kFrame, {0, 2, 1, 3}) == NotCut::Crossed);
  CHECK(refused(kFrame, {0, 1, 2, 3, 0, 1, 2, 3}) == NotCut::Crossed);
  // The inner square the same way around: twice inside.
  CHECK(refused(kFrame, {0, 1, 2, 3, 0, 4, 7, 6, 5, 4}) == NotCut::Crossed);
  // The bridge crosses the hole.
  CHECK(refused(kFrame, {0, 1, 2, 3, 0, 6, 7, 4, 5, 6}) == NotCut::Crossed);
  // An antenna that lies on itself: to (2, 2), back to (1, 1), and home.
  const std::vector<Point> antenna = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0},
                                      {0, 4, 0}, {2, 2, 0}, {1, 1, 0}};
  CHECK(refused(antenna, {0, 1, 2, 3, 0, 4, 5}) == NotCut::Crossed);
  // A bow tie: its triangles turn differently.
  CHECK(refused({{0, 0, 0}, {2, -1, 0}, {2, 1, 0}, {-2, 1, 0}, {-2, -3, 0}}, {0, 1, 2, 0, 4, 3}) ==
        NotCut::Crossed);
  std::vector<Point> bent = kFrame;
  bent[2].z() = 1;
  CHECK(refused(bent, {0, 1, 2, 3, 0, 4, 5, 6, 7, 4}) == NotCut::Bent);
}

TEST_CASE("make_surface: solids of cases have their volumes") {
  const struct {
    const char* name;
    int volume;
  } cases[] = {{"keyhole.obj", 10}, {"h8.obj", 26}, {"edge_inv.obj", 2}, {"big_inv2.obj", 17}};
  for (const auto& c : cases) {
    CAPTURE(c.name);
    const Surface surface = surface_of_case(c.name);
    CHECK(surface.is_closed);
    CHECK(surface.fans.empty());
    CHECK(surface.contradictions == 0);
    CHECK(surface.ambiguous_edges == 0);
    CHECK(support::defined_solid_volume(surface) == c.volume);
  }
}

TEST_CASE("count_near_corners: a file that rounds the corners of each face differently") {
  // Every corner of an L has another one 1e-7 away.
  const Surface surface = surface_of_case("near_corners.obj");
  CHECK(count_near_corners(surface) == surface.points.size());
  CHECK(count_near_corners(surface_of_case("dome.obj")) == 0);
  CHECK(count_near_corners(surface_of_case("h8.obj")) == 0);
}

TEST_CASE("weld: near corners are joined, each once, and none moves farther") {
  // Four on a line, each 2 from the next; within 3 the first takes the second, the third the
  // fourth.
  const std::vector<Point> points = {{6, 0, 0}, {2, 0, 0}, {4, 0, 0}, {0, 0, 0}, {0, 9, 0}};
  const Mesh mesh{PointSet(points), {{3, 1, 4}, {2, 0, 4}}, {}};
  const WeldedMesh joined = weld(mesh, 9);
  CHECK(joined.mesh.polygons == std::vector<std::vector<std::uint32_t>>{{3, 3, 4}, {2, 2, 4}});
  CHECK(joined.moved == 2);
  CHECK(joined.squared_move == 4);
  CHECK(joined.mesh.points.size() == 5);
  // Exactly 2 is within 2, and less is not.
  CHECK(weld(mesh, 4).moved == 2);
  CHECK(weld(mesh, Rational(399, 100)).moved == 0);
  CHECK(weld(mesh, 0).mesh.polygons == mesh.polygons);
  // 1 / 3 and points that are no doubles.
  const std::vector<RationalPoint> thirds = {{0, 0, 0}, {Rational(1, 3), 0, 0}, {0, 1, 0}};
  const Mesh of_thirds{PointSet(thirds), {{0, 1, 2}}, {}};
  CHECK(weld(of_thirds, Rational(1, 9)).moved == 1);
  CHECK(weld(of_thirds, Rational(1, 9) - Rational(1, 1000000000)).moved == 0);
}

TEST_CASE("weld: an L whose corners differ by 1e-7 is one component") {
  const char* folder = std::getenv("CONVEXACT_TEST_DATA");
  REQUIRE(folder != nullptr);
  const Mesh mesh = read_mesh(std::string(folder) + "/cases/near_corners.obj");
  CHECK(make_surface(mesh).components.size() == 14);
  const Rational reach(1, 1000000);
  const Surface surface = make_surface(weld(mesh, reach * reach).mesh);
  CHECK(surface.components.size() == 1);
  CHECK(surface.is_closed);
  CHECK(surface.points.size() == 16);
  // Three unit cubes, each corner of which is off by at most 1e-6.
  const double volume = to_double(support::defined_solid_volume(surface), Rounding::Nearest);
  CHECK(volume == doctest::Approx(3).epsilon(1e-4));
}

TEST_CASE("make_surface: triangles that repeat an earlier one are counted") {
  const std::vector<Point> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Mesh mesh{PointSet(points), {{0, 1, 2}, {1, 2, 0}, {2, 1, 0}, {0, 1, 3}}, {}};
  CHECK(make_surface(mesh).repeated_triangles == 2);
}

TEST_CASE("make_surface: one triangle that is turned is turned back, and no other") {
  const Surface plain = surface_of_case("dome.obj"), flipped = surface_of_case("dome_flip.obj");
  CHECK(plain.triangles == flipped.triangles);
  CHECK(plain.components[0].turned == 0);
  CHECK(flipped.components[0].turned == 1);
  CHECK(surface_of_case("h8.obj").components[1].turned +
            surface_of_case("h8.obj").components[0].turned ==
        1);
}

TEST_CASE(
    "make_surface: the larger area keeps its direction, then more triangles, then the lowest") {
  const std::vector<Point> points = {{0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {2, 3, 0}, {9, 1, 0}};
  const auto turned = [&](std::vector<std::vector<std::uint32_t>> faces) {
    return make_surface({PointSet(points), std::move(faces), {}}).components[0].turned;
  };
  CHECK(turned({{0, 1, 2}, {3, 2, 1}}) == 0);
  // 3 against 3: the lowest stays; with a third of area 10.5 beside it, the other two.
  const Surface equal = make_surface({PointSet(points), {{0, 1, 2}, {1, 2, 3}}, {}});
  CHECK(equal.components[0].turned == 1);
  CHECK(equal.triangles[0] == std::array{PointId(0), PointId(2), PointId(1)});
  CHECK(turned({{0, 1, 2}, {1, 2, 3}, {3, 1, 4}}) == 1);
}

TEST_CASE("make_surface: of equal areas the direction of more triangles stays") {
  // Area 2 against 1 + 1, which are turned.
  const std::vector<Point> points = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 1, 0}, {2, 2, 0}};
  const Mesh mesh{PointSet(points), {{0, 1, 2}, {1, 2, 3}, {3, 2, 4}}, {}};
  CHECK(make_surface(mesh).components[0].turned == 1);
}

TEST_CASE("make_surface: a void that shares an edge with the surface around it stays a void") {
  // An L of three cells, and in it a tetrahedron of volume 1/32 on the edge where it is hollow.
  Mesh mesh = support::mesh_of_cells(support::l_cells());
  std::vector<Point> points(mesh.points.doubles().begin(), mesh.points.doubles().end());
  const auto first = static_cast<std::uint32_t>(points.size());
  for (const Point& p :
       {Point(1, 1, 0), Point(1, 1, 1), Point(0.5, 0.75, 0.5), Point(0.75, 0.5, 0.5)})
    points.push_back(p);
  const auto with_faces = [&](bool is_void) {
    Mesh both{PointSet(points), mesh.polygons, {}};
    for (std::array<std::uint32_t, 3> f :
         {std::array{0u, 1u, 2u}, {0u, 3u, 1u}, {0u, 2u, 3u}, {1u, 3u, 2u}}) {
      if (!is_void) std::swap(f[1], f[2]);
      both.polygons.push_back({first + f[0], first + f[1], first + f[2]});
    }
    return support::defined_solid_volume(make_surface(both));
  };
  CHECK(std::set{with_faces(true), with_faces(false)} == std::set{Rational(95, 32), Rational(3)});
}

TEST_CASE("make_surface: sheets at an edge of four, which nothing tells how they belong together") {
  // Four half planes around the z axis: any two may go on in each other.
  const std::vector<Point> points = {{0, 0, 0}, {0, 0, 1},  {1, 0, 0},
                                     {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  const Mesh sheets{PointSet(points), {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}, {0, 1, 5}}, {}};
  CHECK(make_surface(sheets).ambiguous_edges == 1);
  CHECK(make_surface(sheets).components[0].turned == 0);
}

TEST_CASE("make_surface: randomly flipped triangles of closed cells come right") {
  std::mt19937 random(7);
  int judged = 0;  // not: cells of which it is not clear how they belong together
  for (int round = 0; round < 40; ++round) {
    CAPTURE(round);
    std::set<support::Cell> cells;
    while (cells.size() < 3) {
      cells.insert({int(random() % 3), int(random() % 3), int(random() % 3)});
    }
    Mesh mesh = support::mesh_of_cells(cells);
    const Surface right = make_surface(mesh);
    for (auto& polygon : mesh.polygons) {
      if (random() % 4 == 0) std::reverse(polygon.begin(), polygon.end());
    }
    const Surface surface = make_surface(mesh);
    if (right.ambiguous_edges > 0 || surface.ambiguous_edges > 0) continue;
    ++judged;
    CHECK(surface.is_closed);
    CHECK(support::defined_solid_volume(surface) == 3);
  }
  CHECK(judged >= 30);
}
