// SPDX-License-Identifier: MIT
// What every tree of split() is: a partition into connected parts, always of the worst one; closed
// forms; and changes of the input that change nothing.
#include "split_laws.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <numeric>

#include "assembled_meshes.hpp"
#include "convexact/io.hpp"
#include "small_surfaces.hpp"
#include "sweep.hpp"

using namespace convexact;
using namespace support;

namespace {

SplitTree lawful(const Surface& surface, const SplitOptions& options = {}) {
  SplitTree made = split(surface, options);
  CHECK(SplitLaws(surface, options, made).broken() == "");
  return made;
}

SplitOptions with(const Rational& share, BridgeChoice bridge = BridgeChoice::Farther) {
  SplitOptions options;
  options.limit.value = share;
  options.bridge = bridge;
  return options;
}

constexpr std::array kChoices{BridgeChoice::Farther, BridgeChoice::Region, BridgeChoice::Nearer};
constexpr std::array kConnections{Connect::Edge, Connect::Overlap, Connect::Touching};

Mesh mesh_with(const Mesh& mesh, const std::vector<RationalPoint>& points) {
  return {PointSet(points), mesh.polygons, {}};
}

}  // namespace

TEST_CASE("split: laws, on terrains, soups, cells and pieces of meshes" * sweep) {
  std::mt19937 random(1);
  for (unsigned round = 0; round < 60; ++round) {
    CAPTURE(round);
    SplitOptions options =
        with(std::array{Rational(0), Rational(1, 50), Rational(1, 8)}[round / 3 % 3],
             kChoices[round % 3]);
    options.connect = kConnections[round / 2 % 3];
    lawful(make_surface(terrain(6, 5, 1 + round % 4, round % 9, random)), options);
    lawful(make_surface(soup(12, 24, 4, random)), options);
    lawful(make_surface(mesh_of_cells(random_cells(2 + round % 7, random))), options);
  }
  const char* folder = std::getenv("CONVEXACT_TEST_DATA");
  REQUIRE(folder != nullptr);
  for (const char* mesh : {"spot.obj", "teapot.obj", "bunny.obj"}) {
    const Surface whole = make_surface(read_mesh(std::string(folder) + "/" + mesh));
    for (const BridgeChoice choice : kChoices) {
      lawful(first_triangles(whole, 400), with(Rational(1, 100), choice));
    }
    CHECK(lawful(whole, with(Rational(1, 10))).leaves.size() > 1);
  }
}

TEST_CASE("split: what is asked for besides the tree does not change it") {
  std::mt19937 random(5);
  for (unsigned round = 0; round < 20; ++round) {
    CAPTURE(round);
    const Surface surface = make_surface(terrain(5, 4, 3, round % 5, random));
    SplitOptions options = with(Rational(1, 100), kChoices[round % 3]);
    const SplitTree plain = lawful(surface, options);
    options.associations = true;
    const SplitTree full = split(surface, options);
    CHECK(difference_in_place(plain, full) == "");
    for (const SplitNode& node : plain.nodes) CHECK_FALSE(node.association);
    for (const SplitLeaf& leaf : full.leaves) {
      const SplitNode& node = full.nodes[leaf.node];
      const BridgeMeasure measure = measure_by_bridges(surface, leaf.triangles, options);
      CHECK(measure.concavity.squared == node.concavity.squared);
      CHECK(measure.concavity.leaves == node.concavity.leaves);
      CHECK(measure.least_squared_concavity == leaf.least_squared_concavity);
      REQUIRE(node.association);
      CHECK(difference(measure.association, *node.association) == "");
    }
  }
}

TEST_CASE("split: the first splits do not depend on the number of parts") {
  std::mt19937 random(4);
  for (unsigned round = 0; round < 6; ++round) {
    CAPTURE(round);
    const Surface surface = make_surface(terrain(6, 6, 3, round % 2 * 8, random));
    SplitOptions options = with(round < 3 ? Rational(0) : Rational(1, 20), kChoices[round % 3]);
    const SplitTree whole = lawful(surface, options);
    REQUIRE(whole.leaves.size() > 3);
    for (std::size_t most = whole.roots; most <= whole.leaves.size() + 1; ++most) {
      options.max_parts = most;
      const SplitTree made = lawful(surface, options);
      CHECK(made.leaves.size() == std::min(most, whole.leaves.size()));
      // At the end, leaves that no plane splits may be left; if allowed one more, it is found out.
      if (most != whole.leaves.size()) {
        CHECK(made.stopped_by_count == (most < whole.leaves.size()));
      }
      REQUIRE(made.splits.size() <= whole.splits.size());
      for (std::size_t k = 0; k < made.splits.size(); ++k) {
        CHECK(made.splits[k].node == whole.splits[k].node);
        CHECK(made.splits[k].plane == whole.splits[k].plane);
        CHECK(made.splits[k].moved == whole.splits[k].moved);
        CHECK(made.splits[k].islands == whole.splits[k].islands);
      }
      for (std::size_t n = 0; n < made.nodes.size(); ++n) {
        CHECK(made.nodes[n].concavity.squared == whole.nodes[n].concavity.squared);
      }
    }
  }
}

TEST_CASE("split: a run with a larger limit is a prefix of one with a smaller limit") {
  std::mt19937 random(14);
  for (unsigned round = 0; round < 12; ++round) {
    CAPTURE(round);
    const Surface surface = make_surface(terrain(6, 6, 4, round % 4 * 4, random));
    const SplitTree whole = lawful(surface, with(0, kChoices[round % 3]));
    for (const int share : {1, 5, 10, 20}) {
      const SplitTree made = lawful(surface, with(Rational(share, 100), kChoices[round % 3]));
      REQUIRE(made.splits.size() <= whole.splits.size());
      for (std::size_t k = 0; k < made.splits.size(); ++k) {
        CHECK(made.splits[k].node == whole.splits[k].node);
        CHECK(made.splits[k].moved == whole.splits[k].moved);
        CHECK(made.splits[k].islands == whole.splits[k].islands);
      }
    }
  }
}

TEST_CASE("split: convex shapes are one leaf of concavity 0 at every limit") {
  const Mesh ball_mesh = ball({0, 0, 0}, 60);
  const Mesh flat{PointSet(std::vector<Point>{{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}}),
                  {{0, 1, 2}, {0, 2, 3}},
                  {}};
  for (const Mesh& mesh :
       {mesh_of_cells({{0, 0, 0}}), mesh_of_cells({{0, 0, 0}, {1, 0, 0}}),
        mesh_of_cells({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}), ball_mesh, flat}) {
    const Surface surface = make_surface(mesh);
    for (const Rational& limit : {Rational(0), Rational(1, 100), Rational(1)}) {
      for (const BridgeChoice choice : kChoices) {
        const SplitTree made = lawful(surface, with(limit, choice));
        REQUIRE(made.leaves.size() == 1);
        CHECK(made.nodes[0].concavity.squared == 0);
        CHECK(made.leaves[0].status == LeafStatus::WithinLimit);
      }
    }
  }
}

TEST_CASE("split: the depth of a pit in a box, by each choice of bridges") {
  for (const int depth : {1, 2, 5}) {
    const Mesh box{PointSet(std::vector<Point>{{0, 0, 0},
                                               {8, 0, 0},
                                               {8, 8, 0},
                                               {0, 8, 0},
                                               {4, 4, -double(depth)},
                                               {0, 0, -9},
                                               {8, 0, -9},
                                               {8, 8, -9},
                                               {0, 8, -9}}),
                   {{0, 1, 4},
                    {1, 2, 4},
                    {2, 3, 4},
                    {3, 0, 4},
                    {5, 8, 7, 6},
                    {0, 5, 6, 1},
                    {1, 6, 7, 2},
                    {2, 7, 8, 3},
                    {3, 8, 5, 0}},
                   {}};
    const Surface surface = make_surface(box);
    // All four corners around the pit have the lid among their bridges, and each has two of the
    // sides, which are 4 away. The lowest corner is as near as the others.
    const std::array<int, 3> squares{std::max(16, depth * depth), depth * depth,
                                     std::min(16, depth * depth)};
    for (std::size_t k = 0; k < kChoices.size(); ++k) {
      const SplitTree made = lawful(surface, with(1, kChoices[k]));
      REQUIRE(made.leaves.size() == 1);
      CHECK(made.nodes[0].concavity.squared == squares[k]);
      CHECK(made.nodes[0].concavity.at == RationalPoint(4, 4, -depth));
      CHECK(made.leaves[0].least_squared_concavity == std::min(16, depth * depth));
    }
  }
}

TEST_CASE("split: a limit of the whole diameter leaves a leaf for each component") {
  std::mt19937 random(9);
  for (unsigned round = 0; round < 15; ++round) {
    CAPTURE(round);
    const Surface surface = make_surface(terrain(6, 5, 4, 16, random));
    const SplitTree made = lawful(surface, with(1, kChoices[round % 3]));
    CHECK(made.leaves.size() == surface.components.size());
    CHECK(made.splits.empty());
  }
}

TEST_CASE("split: no order of the input, no rotation and no repeated point changes the tree") {
  std::mt19937 random(31);
  for (unsigned round = 0; round < 45; ++round) {
    CAPTURE(round);
    const Mesh mesh = round % 3 == 0   ? terrain(5, 5, 2, round % 8, random)
                      : round % 3 == 1 ? mesh_of_cells(random_cells(6, random))
                                       : soup(9, 16, 4, random);
    SplitOptions options = with(Rational(round / 3 % 3, 50), kChoices[round / 3 % 3]);
    options.connect = kConnections[round % 2];
    options.associations = true;
    const SplitTree plain = split(make_surface(mesh), options);
    std::vector<std::uint32_t> order(mesh.points.size());
    std::iota(order.begin(), order.end(), 0u);
    std::shuffle(order.begin(), order.end(), random);
    std::vector<Point> points(order.size());
    for (std::size_t p = 0; p < order.size(); ++p) points[order[p]] = mesh.points.doubles()[p];
    points.insert(points.end(), points.begin(), points.begin() + std::ptrdiff_t(order.size()));
    Mesh changed = mesh;
    for (auto& face : changed.polygons) {
      for (auto& corner : face) {
        corner = order[corner] + (random() % 2 == 0 ? 0 : std::uint32_t(order.size()));
      }
      std::rotate(face.begin(), face.begin() + random() % face.size(), face.end());
    }
    std::shuffle(changed.polygons.begin(), changed.polygons.end(), random);
    changed.points = PointSet(std::move(points));
    changed.parts.clear();
    const Surface surface = make_surface(changed);
    const SplitTree made = lawful(surface, options);
    CHECK(difference_in_place(plain, made) == "");
    for (std::size_t n = 0; n < std::min(made.nodes.size(), plain.nodes.size()); ++n) {
      CHECK(difference(*plain.nodes[n].association, *made.nodes[n].association) == "");
    }
  }
}

TEST_CASE("split: scaled by a power of two, and moved exactly, a surface is split in the same way" *
          sweep) {
  std::mt19937 random(17);
  for (unsigned round = 0; round < 24; ++round) {
    CAPTURE(round);
    Mesh mesh = round % 3 == 0   ? terrain(5, 5, 3, round % 5, random)
                : round % 3 == 1 ? mesh_of_cells(random_cells(6, random))
                                 : soup(10, 18, 7, random);
    std::vector<RationalPoint> points = points_in(mesh.points);
    if (round % 2 == 1) {  // fractions, which no double is
      for (RationalPoint& p : points) p = RationalPoint(p[0] / 3, p[1] * Rational(5, 7), p[2] / 3);
      mesh = mesh_with(mesh, points);
    }
    SplitOptions options = with(Rational(round % 4, 60), kChoices[round / 3 % 3]);
    const SplitTree plain = lawful(make_surface(mesh), options);
    for (const long exponent : {-300, -1, 1, 7, 300}) {
      std::vector<RationalPoint> scaled = points;
      for (RationalPoint& p : scaled) {
        for (Rational& x : p) x = scale_by_power_of_two(x, exponent);
      }
      const SplitTree made = split(make_surface(mesh_with(mesh, scaled)), options);
      CHECK(difference(plain, made, scale_by_power_of_two(1, 2 * exponent)) == "");
    }
    // Among these are vectors that take the box across powers of two.
    for (const RationalVector3& by :
         {RationalVector3(1, -3, 5), RationalVector3(Rational(-5, 2), -3, Rational(-3, 2)),
          RationalVector3(to_rational(0x1p40), to_rational(-0x1p45), 3),
          RationalVector3(Rational(1, 3), Rational(-1, 7), Rational(2, 3))}) {
      std::vector<RationalPoint> moved = points;
      for (RationalPoint& p : moved) p += by;
      const SplitTree made = split(make_surface(mesh_with(mesh, moved)), options);
      REQUIRE(difference(plain, made) == "");
      for (std::size_t k = 0; k < made.splits.size(); ++k) {
        CHECK(same_direction(made.splits[k].plane, plain.splits[k].plane));
      }
    }
  }
}
