// SPDX-License-Identifier: MIT
// Splitting surfaces that are hardly any, and what is refused.
#include <doctest/doctest.h>

#include <atomic>
#include <cmath>
#include <numbers>

#include "assembled_meshes.hpp"
#include "cells.hpp"
#include "convexact/cluster.hpp"
#include "expect_error.hpp"
#include "split_laws.hpp"
#include "sweep.hpp"

using namespace convexact;
using namespace support;

namespace {

constexpr std::array kBridges{BridgeChoice::Farther, BridgeChoice::Region, BridgeChoice::Nearer};

// Laws at every limit, by every choice; the tree at 1% by the first choice.
SplitTree split_lawfully(const Mesh& mesh, Orient orient = Orient::Auto) {
  const Surface surface = make_surface(mesh, {orient});
  SplitTree first;
  for (const Rational& share : {Rational(1, 100), Rational(0), Rational(1, 5)}) {
    for (const BridgeChoice bridge : kBridges) {
      for (const Connect connect : {Connect::Edge, Connect::Overlap, Connect::Touching}) {
        SplitOptions options;
        options.limit.value = share;
        options.bridge = bridge;
        options.connect = connect;
        SplitTree made = split(surface, options);
        CHECK(SplitLaws(surface, options, made).broken() == "");
        if (first.nodes.empty()) first = std::move(made);
      }
    }
  }
  return first;
}

Mesh closed_by_gluing(int columns, int rows, bool is_turned, bool is_strip) {
  // A torus, or a bottle if the last column meets the first one turned; a strip if its rows do not
  // close. Points are those of a figure 8 or of a circle that turns by half a turn on the way.
  std::vector<Point> points;
  const auto angle = [](double k, int n) { return 2 * std::numbers::pi * k / n; };
  for (int i = 0; i < columns; ++i) {
    const double u = angle(i, columns), half = is_turned ? u / 2 : 0;
    for (int j = 0; j < rows; ++j) {
      const double v = angle(j + 0.5, rows);
      const double along = is_strip ? j - (rows - 1) / 2.0 : std::sin(v);
      const double aside = is_strip ? 0 : is_turned ? std::sin(2 * v) : std::cos(v);
      const double r = 4 + std::cos(half) * along - std::sin(half) * aside;
      points.emplace_back(r * std::cos(u), r * std::sin(u),
                          std::sin(half) * along + std::cos(half) * aside);
    }
  }
  const auto at = [&](int i, int j) {
    j %= rows;
    if (i == columns) j = is_turned ? rows - 1 - j : j;
    return std::uint32_t(i % columns * rows + j);
  };
  std::vector<std::vector<std::uint32_t>> faces;
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < (is_strip ? rows - 1 : rows); ++j) {
      faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh_of(std::move(points), std::move(faces));
}

Mesh moved_by(Mesh mesh, const Point& by) {
  std::vector<Point> points;
  for (const Point& p : mesh.points.doubles()) points.push_back(p + by);
  mesh.points = PointSet(points);
  return mesh;
}

const std::vector<Point> kCube{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                               {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};

}  // namespace

TEST_CASE("split: surfaces with one side, or with a hole" * sweep) {
  CHECK(split_lawfully(closed_by_gluing(7, 2, true, true)).nodes.size() > 1);
  CHECK(split_lawfully(closed_by_gluing(9, 4, true, true)).nodes.size() > 1);
  CHECK(split_lawfully(closed_by_gluing(8, 5, true, false)).nodes.size() > 1);
  CHECK(split_lawfully(closed_by_gluing(8, 6, false, false)).nodes.size() > 1);
  CHECK(split_lawfully(mesh_of_cells(ring_cells())).nodes.size() > 1);
  split_lawfully(closed_by_gluing(8, 5, true, false), Orient::Keep);
}

TEST_CASE("split: one triangle, and sheets, are flat leaves") {
  const auto is_leaf = [](const Mesh& mesh) {
    const SplitTree made = split_lawfully(mesh);
    CHECK(made.leaves.size() == 1);
    CHECK(made.nodes[0].concavity.squared == 0);
    CHECK(made.leaves[0].least_squared_concavity == 0);
  };
  is_leaf(mesh_of(kCube, {{0, 1, 2}}));
  is_leaf(mesh_of(kCube, {{0, 1, 2}, {0, 2, 1}}));
  is_leaf(mesh_of(kCube, {{0, 1, 2, 3}, {3, 2, 1, 0}}));
  is_leaf(mesh_of(kCube, {{0, 1, 2}, {0, 1, 2}, {0, 1, 2}}));
  is_leaf(mesh_of(kCube, {{0, 1, 0}}));
  is_leaf(mesh_of(kCube, {{4, 4, 4}}));
  // A star in a plane: far from convex, and flat.
  std::vector<Point> star;
  for (int k = 0; k < 10; ++k) {
    const double angle = std::numbers::pi * k / 5, radius = k % 2 == 0 ? 4 : 1;
    star.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 2);
  }
  is_leaf(mesh_of(star, {{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}}));
  // A bent sheet, doubled: two flat sheets of a hull with a volume, and no plane between opposites.
  split_lawfully(mesh_of({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 1}, {1, 1, 3}},
                         {{0, 1, 4}, {1, 0, 4}, {1, 3, 4}, {3, 1, 4}, {3, 2, 4}, {2, 3, 4}}));
}

TEST_CASE("split: triangles without area only") {
  std::vector<Point> line;
  for (int k = 0; k < 6; ++k) line.emplace_back(k, 2 * k, -k);
  CHECK(split_lawfully(mesh_of(line, {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}})).leaves.size() == 1);
  // Three lines that span a volume, and a corner in their midst.
  const std::vector<Point> lines{{0, 0, 0}, {1, 0, 0}, {4, 0, 0}, {0, 1, 0}, {0, 4, 0},
                                 {0, 0, 1}, {0, 0, 4}, {1, 1, 1}, {2, 2, 2}};
  split_lawfully(
      mesh_of(lines, {{0, 1, 2}, {0, 3, 4}, {0, 5, 6}, {0, 7, 8}, {7, 7, 8}, {7, 8, 7}}));
}

TEST_CASE("split: boxes without a lid, inside out, and through one another") {
  const auto is_convex = [](const Mesh& mesh, Orient orient) {
    const SplitTree made = split_lawfully(mesh, orient);
    CHECK(made.leaves.size() == made.roots);
    for (const SplitNode& node : made.nodes) CHECK(node.concavity.squared == 0);
    return made.roots;
  };
  const std::vector<std::vector<std::uint32_t>> open{
      {0, 1, 2, 3}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  CHECK(is_convex(mesh_of(kCube, open), Orient::Auto) == 1);
  Mesh inside_out = mesh_of_cells({{0, 0, 0}});
  for (auto& face : inside_out.polygons) std::reverse(face.begin(), face.end());
  CHECK(is_convex(inside_out, Orient::Auto) == 1);
  CHECK(is_convex(inside_out, Orient::Keep) == 1);
  const Mesh box = box_mesh({{0, 0, 0}, {2, 2, 2}});
  CHECK(is_convex(joined({box, moved_by(box, {1, 1, 1})}), Orient::Auto) == 2);
  CHECK(is_convex(joined({box, moved_by(box, {2, 2, 2})}), Orient::Auto) == 2);
  Mesh ring = mesh_of_cells(l_cells());
  const SplitTree outward = split_lawfully(ring, Orient::Keep);
  for (auto& face : ring.polygons) std::reverse(face.begin(), face.end());
  CHECK(difference_in_place(outward, split_lawfully(ring, Orient::Auto)) == "");
  split_lawfully(ring, Orient::Keep);
}

TEST_CASE("split: bow ties, fans at an edge, and repeated triangles") {
  split_lawfully(mesh_of(kCube, {{0, 1, 4}, {4, 6, 7}}));
  // Two cones with a common tip; the surface of each is concave there.
  split_lawfully(mesh_of({{0, 0, 0},
                          {3, 0, 3},
                          {0, 3, 3},
                          {-3, 0, 3},
                          {0, -3, 3},
                          {3, 0, -3},
                          {0, 3, -3},
                          {-3, 0, -3},
                          {0, -3, -3},
                          {9, 0, 1}},
                         {{0, 1, 2},
                          {0, 2, 3},
                          {0, 3, 4},
                          {0, 4, 1},
                          {0, 5, 6},
                          {0, 6, 7},
                          {0, 7, 8},
                          {0, 8, 5},
                          {1, 5, 9},
                          {1, 9, 2},
                          {5, 9, 6}}));
  // Four triangles at an edge whose ends lie deep in the hull.
  const std::vector<Point> cross{{0, 0, -1}, {0, 0, 1}, {4, 0, 0},  {-4, 0, 0}, {0, 4, 0},
                                 {0, -4, 0}, {4, 1, 6}, {-4, 1, 6}, {1, 4, -6}, {1, -4, -6}};
  const std::vector<std::vector<std::uint32_t>> fans{{0, 1, 2}, {0, 1, 3}, {1, 0, 4}, {0, 1, 5},
                                                     {1, 2, 6}, {1, 3, 7}, {0, 4, 8}, {0, 5, 9}};
  CHECK(split_lawfully(mesh_of(cross, fans)).splits.size() > 0);
  auto repeated = fans;
  for (const auto& face : fans) repeated.push_back({face[1], face[2], face[0]});
  for (const auto& face : fans) repeated.push_back({face[1], face[0], face[2]});
  split_lawfully(mesh_of(cross, repeated));
}

TEST_CASE("split: at T-junctions, by each way to connect") {
  // A roof of one triangle on each side of a ridge, cut in halves on one of them.
  const Mesh roof = mesh_of(
      {{0, 0, 0}, {4, 0, 0}, {2, 0, -1}, {0, 3, 2}, {4, 3, 2}, {2, -3, 2}, {2, 0, 0}, {0, -3, 2}},
      {{0, 1, 3}, {1, 4, 3}, {0, 6, 7}, {6, 1, 5}, {7, 6, 5}});
  const Surface surface = make_surface(roof);
  std::vector<std::size_t> roots;
  for (const Connect connect : {Connect::Edge, Connect::Overlap, Connect::Touching}) {
    SplitOptions options;
    options.connect = connect;
    options.limit.value = 0;
    const SplitTree made = split(surface, options);
    CHECK(SplitLaws(surface, options, made).broken() == "");
    roots.push_back(made.roots);
  }
  CHECK(roots == std::vector<std::size_t>{2, 1, 1});
  split_lawfully(roof);
  // Components that only touch: at a point, and a point in a triangle.
  const Mesh touching = mesh_of({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 0}, {1, 2, 3}, {2, 1, 3}},
                                {{0, 1, 2}, {3, 4, 5}});
  split_lawfully(touching);
}

TEST_CASE("split: slivers") {
  split_lawfully(mesh_of({{0, 0, 0}, {1, 0, 0}, {0.5, 1e-16, 0}, {0.5, 1, 1}},
                         {{0, 1, 2}, {0, 2, 3}, {2, 1, 3}}));
  // A strip of slivers that goes up and down by far less than its length.
  std::vector<Point> points;
  std::vector<std::vector<std::uint32_t>> faces;
  for (std::uint32_t k = 0; k < 12; ++k) {
    points.emplace_back(k, k % 3 * 1e-16, k % 4 * 1e-18);
    points.emplace_back(k, 1, k % 2 * 0.25);
    if (k == 0) continue;
    const std::uint32_t a = 2 * k;
    faces.push_back({a - 2, a, a - 1});
    faces.push_back({a, a + 1, a - 1});
  }
  CHECK(split_lawfully(mesh_of(points, faces)).splits.size() > 0);
  for (Point& p : points) p[1] *= 0x1p-52;
  split_lawfully(mesh_of(points, faces));
  for (Point& p : points) p[2] = std::ldexp(p[2], -1000);  // below the range of doubles
  split_lawfully(mesh_of(points, faces));
}

TEST_CASE("split: fewer parts than components are refused, and their number is named") {
  const Mesh box = box_mesh({{0, 0, 0}, {1, 1, 1}});
  const Surface surface =
      make_surface(joined({box, moved_by(box, {3, 0, 0}), moved_by(box, {0, 3, 0})}));
  SplitOptions options;
  options.max_parts = 2;
  const Error refused = error_of([&] { return split(surface, options); });
  CHECK(refused.code() == ErrorCode::InvalidArgument);
  CHECK(std::string(refused.what()).find("3 components") != std::string::npos);
  options.max_parts = 3;
  const SplitTree made = split(surface, options);
  CHECK(made.leaves.size() == 3);
  CHECK_FALSE(made.stopped_by_count);
}

TEST_CASE("split: what cannot be asked for is refused") {
  const Surface surface = make_surface(mesh_of_cells(l_cells()));
  const std::vector<TriangleId> one{TriangleId(0)};
  const auto refuse = [&](auto change, bool is_measured = false) {
    SplitOptions options;
    change(options);
    CHECK(error_of([&] { return split(surface, options); }).code() == ErrorCode::InvalidArgument);
    if (!is_measured) return;
    CHECK(error_of([&] { return measure_by_bridges(surface, one, options); }).code() ==
          ErrorCode::InvalidArgument);
  };
  refuse([](SplitOptions& options) { options.limit.value = -1; });
  refuse([](SplitOptions& options) { options.limit.value = Rational(11, 10); });
  refuse([](SplitOptions& options) { options.limit = {Rational(-1, 2), false}; });
  refuse([](SplitOptions& options) { options.max_parts = 0; });
  refuse([](SplitOptions& options) { options.coplanar = 0; }, true);
  refuse([](SplitOptions& options) { options.coplanar = Rational(-1, 2); }, true);
  refuse([](SplitOptions& options) { options.coplanar = Rational(1000001, 1000000); }, true);
  SplitOptions allowed;
  allowed.coplanar = 1;
  CHECK(split(surface, allowed).leaves.size() > 1);
  allowed.limit = {Rational(5), false};  // a length, longer than the diameter
  CHECK(split(surface, allowed).leaves.size() == 1);
}

TEST_CASE("split: a length as a limit is the same as its share of the diameter") {
  const Surface surface = make_surface(mesh_of_cells({{0, 0, 0}, {0, 1, 0}, {0, 1, 1}}));
  SplitOptions share, length;
  share.limit = {Rational(1, 20), true};
  length.limit = {Rational(3, 20), false};  // of a diagonal of 3
  CHECK(difference_in_place(split(surface, share), split(surface, length)) == "");
}

TEST_CASE("split: a flag ends the run") {
  const Surface surface = make_surface(mesh_of_cells(l_cells()));
  const std::atomic<bool> stop = true;
  SplitOptions options;
  options.watch = Watch(&stop);
  CHECK(error_of([&] { return split(surface, options); }).code() == ErrorCode::Stopped);
}
