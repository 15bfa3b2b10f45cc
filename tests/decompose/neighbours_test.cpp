// SPDX-License-Identifier: MIT
// Neighbours by edges, by parts of edges, and by points, on surfaces where they can be counted.
#include <doctest/doctest.h>

#include "convexact/cluster.hpp"
#include "small_surfaces.hpp"

using namespace convexact;
using namespace support;

namespace {

Surface triangles(std::vector<Point> points, std::vector<std::vector<std::uint32_t>> faces) {
  return make_surface({PointSet(std::move(points)), std::move(faces), {}});
}

std::size_t count(const Surface& surface, Connect connect) {
  return neighbours(surface, connect).size();
}

std::size_t groups(const Surface& surface, Connect connect) {
  return count_groups(surface, neighbours(surface, connect));
}

}  // namespace

TEST_CASE("every triangle of a closed surface has three neighbours over its edges") {
  const Surface box = make_surface(mesh_of_cells({{0, 0, 0}}));
  CHECK(box.triangles.size() == 12);
  CHECK(count(box, Connect::Edge) == 18);
  CHECK(count(box, Connect::Overlap) == 18);
  CHECK(groups(box, Connect::Edge) == 1);
}

TEST_CASE("four triangles at an edge are all neighbours") {
  const Surface fan =
      triangles({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}},
                {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}, {0, 1, 5}});
  CHECK(count(fan, Connect::Edge) == 6);
}

TEST_CASE("at a T-junction triangles overlap along a part of an edge") {
  // One triangle above the x axis, and below it two that share its edge from 0 to 2 in halves.
  const Surface surface =
      triangles({{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, -1, 0}, {2, -1, 0}},
                {{0, 1, 2}, {0, 4, 3}, {3, 5, 1}});
  CHECK(count(surface, Connect::Edge) == 0);
  CHECK(groups(surface, Connect::Edge) == 3);
  CHECK(count(surface, Connect::Overlap) == 2);
  CHECK(groups(surface, Connect::Overlap) == 1);
  // The two below touch at the middle, and belong to different components.
  CHECK(count(surface, Connect::Touching) == 3);
}

TEST_CASE("edges of one line that meet in a point, or of two parallel lines, do not overlap") {
  const Surface end_to_end =
      triangles({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}}, {{0, 1, 2}, {1, 3, 4}});
  CHECK(count(end_to_end, Connect::Overlap) == 0);
  CHECK(count(end_to_end, Connect::Touching) == 1);
  const double close = 1 + 0x1p-52;
  const Surface apart =
      triangles({{0, 1, 0}, {1, 1, 0}, {0, 2, 0}, {0, close, 1}, {1, close, 1}, {0, 2, 1}},
                {{0, 1, 2}, {3, 4, 5}});
  CHECK(count(apart, Connect::Touching) == 0);
}

TEST_CASE("an edge beside a line by less than an ulp of its length does not overlap") {
  const double big = 1e8, ulp = 0x1p-30;
  for (const double off : {0.0, ulp}) {
    CAPTURE(off);
    const Surface surface = triangles(
        {{0, 0, 0}, {3 * big, 0, 0}, {0, big, 0}, {big, off, 0}, {2 * big, 0, 0}, {big, -big, 0}},
        {{0, 1, 2}, {3, 4, 5}});
    CHECK(count(surface, Connect::Overlap) == (off == 0 ? 1 : 0));
  }
}

TEST_CASE("two boxes at an edge or at a corner touch, and are two groups") {
  for (const Cell& second : {Cell{1, 1, 0}, Cell{1, 1, 1}}) {
    // Each box on its own points: a common edge by its points would join the triangles there.
    Mesh mesh = mesh_of_cells({{0, 0, 0}});
    const Mesh other = mesh_of_cells({second});
    std::vector<Point> points(mesh.points.doubles().begin(), mesh.points.doubles().end());
    for (const Point& p : other.points.doubles()) points.push_back(p);
    for (auto face : other.polygons) {
      for (auto& corner : face) corner += 8;
      mesh.polygons.push_back(face);
    }
    mesh.points = PointSet(points);
    const Surface surface = make_surface(mesh);
    const bool at_edge = second[2] == 0;
    CHECK(groups(surface, Connect::Edge) == (at_edge ? 1 : 2));
    CHECK(groups(surface, Connect::Touching) == 1);
  }
}

TEST_CASE("a triangle with two equal corners has no edges, and touches what it lies on") {
  const Surface surface = triangles({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 0, 1}});
  CHECK(count(surface, Connect::Edge) == 0);
  CHECK(count(surface, Connect::Touching) == 1);
}
