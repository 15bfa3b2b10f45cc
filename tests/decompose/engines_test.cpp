// SPDX-License-Identifier: MIT
// The engines make the same merges: the exact one by the definitions, the filtered one by bounds.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>

#include "convexact/cluster.hpp"
#include "convexact/io.hpp"
#include "fractions.hpp"
#include "small_surfaces.hpp"
#include "sweep.hpp"

using namespace convexact;
using namespace support;

namespace {

struct Compared {
  std::size_t runs = 0, merges = 0, ties = 0, beyond = 0, several = 0;
};

void compare_engines(const Surface& surface, ClusterOptions options, Compared& all) {
  options.engine = Engine::Exact;
  const Clustering exact = cluster(surface, options);
  options.engine = Engine::Filtered;
  const Clustering filtered = cluster(surface, options);
  CHECK(exact.merges == filtered.merges);
  CHECK(exact.clusters == filtered.clusters);
  CHECK(exact.united == filtered.united);
  CHECK(exact.stopped_by_count == filtered.stopped_by_count);
  ++all.runs;
  all.several += exact.clusters.size() > 1;
  for (const Merge& merge : exact.merges) {
    ++all.merges;
    all.ties += merge.ties > 0;
    all.beyond += merge.beyond_limit;
  }
}

ClusterOptions options_of(unsigned round) {
  const std::array<Rational, 6> limits{Rational(0),     Rational(1, 1000), Rational(3, 100),
                                       Rational(1, 10), Rational(3, 10),   Rational(1)};
  ClusterOptions options;
  options.limit.value = limits[round % limits.size()];
  options.measure = round % 2 == 0 ? ConcavityMeasure::Surface : ConcavityMeasure::Vertices;
  if (round % 5 == 0) options.max_parts = 1 + round % 3;
  options.connect = std::array{Connect::Edge, Connect::Overlap, Connect::Touching}[round / 3 % 3];
  return options;
}

}  // namespace

TEST_CASE("the filtered engine merges as the exact one does, on terrains and cells" * sweep) {
  // CONVEXACT_ENGINE_RUNS=5000 for a long night.
  const char* wanted = std::getenv("CONVEXACT_ENGINE_RUNS");
  const unsigned runs = wanted != nullptr ? unsigned(std::atoi(wanted)) : 160;
  std::mt19937 random(2009);
  Compared all;
  for (unsigned round = 0; round < runs; ++round) {
    CAPTURE(round);
    ClusterOptions options = options_of(round);
    const bool is_terrain = random() % 3 != 0;
    const auto columns = std::uint32_t(2 + random() % 3), rows = std::uint32_t(1 + random() % 3);
    const Surface surface =
        is_terrain ? make_surface(terrain(columns, rows, random() % 4, random() % 4, random))
                   : make_surface(mesh_of_cells(random_cells(1 + random() % 3, random)));
    const auto pairs = neighbours(surface, options.connect);
    if (options.max_parts)
      options.max_parts = std::max(*options.max_parts, count_groups(surface, pairs));
    compare_engines(surface, options, all);
  }
  MESSAGE(all.runs << " surfaces, " << all.merges << " merges, " << all.ties << " with ties, "
                   << all.beyond << " beyond the limit");
  CHECK(all.ties > all.runs);
  CHECK(all.beyond > 0);
  CHECK(all.several > all.runs / 4);
}

TEST_CASE("the filtered engine merges as the exact one does, on the first triangles of meshes" *
          sweep) {
  const char* folder = std::getenv("CONVEXACT_TEST_DATA");
  REQUIRE(folder != nullptr);
  Compared all;
  for (const char* mesh : {"spot.obj", "teapot.obj", "bunny.obj"}) {
    const Surface whole = make_surface(read_mesh(std::string(folder) + "/" + mesh));
    for (const auto measure : {ConcavityMeasure::Surface, ConcavityMeasure::Vertices}) {
      ClusterOptions options;
      options.measure = measure;
      compare_engines(first_triangles(whole, 100), options, all);
    }
  }
  CHECK(all.merges > 500);
}

TEST_CASE("points that are fractions are clustered as their multiples are") {
  std::mt19937 random(3);
  for (unsigned round = 0; round < 6; ++round) {
    const Mesh mesh = terrain(4, 3, 3, 0, random);
    Mesh thirds = mesh;
    std::vector<RationalPoint> points;
    for (std::uint32_t p = 0; p < mesh.points.size(); ++p) {
      points.push_back(mesh.points[PointId(p)] / Rational(3));
    }
    thirds.points = PointSet(std::move(points));
    REQUIRE_FALSE(thirds.points.is_binary());
    ClusterOptions options = options_of(round);
    options.connect = Connect::Edge;
    options.max_parts.reset();
    const Clustering whole = cluster(make_surface(mesh), options);
    const Clustering scaled = cluster(make_surface(thirds), options);
    CHECK(whole.merges == scaled.merges);
    CHECK(whole.clusters == scaled.clusters);
  }
}

TEST_CASE("the filtered engine merges as the exact one does, where rounding moves the points") {
  std::mt19937 random(44);
  Compared all;
  for (unsigned round = 0; round < 60; ++round) {
    CAPTURE(round);
    Mesh mesh = terrain(3, 1 + round % 3, round % 4, round % 2, random);
    mesh.points = as_fractions(mesh.points, kFractions[round % std::size(kFractions)]);
    REQUIRE_FALSE(mesh.points.is_binary());
    ClusterOptions options = options_of(round);
    options.max_parts.reset();
    compare_engines(make_surface(mesh), options, all);
  }
  CHECK(all.merges > 200);
  CHECK(all.several > 5);
}

TEST_CASE("the float engine is classified, not trusted: on meshes without ties it agrees here") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> height(0, 1);
  for (int round = 0; round < 5; ++round) {
    Mesh mesh = terrain(8, 8, 1, 0, random);
    std::vector<Point> points(mesh.points.doubles().begin(), mesh.points.doubles().end());
    for (Point& p : points) p += Point(0.3 * height(random), 0.3 * height(random), height(random));
    mesh.points = PointSet(std::move(points));
    const Surface surface = make_surface(mesh);
    ClusterOptions options;
    const Clustering filtered = cluster(surface, options);
    options.engine = Engine::Float;
    const Clustering by_doubles = cluster(surface, options);
    CHECK(filtered.clusters == by_doubles.clusters);
  }
}

TEST_CASE("similar shapes of different sizes cost the same by a proof") {
  // Two components: a square of two triangles, and the same three times as large.
  const Mesh mesh{PointSet(std::vector<Point>{{0, 0, 0},
                                              {1, 0, 0},
                                              {1, 2, 0},
                                              {0, 1, 0},
                                              {10, 0, 5},
                                              {13, 0, 5},
                                              {13, 6, 5},
                                              {10, 3, 5}}),
                  {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}},
                  {}};
  const Surface surface = make_surface(mesh);
  for (const Engine engine : {Engine::Exact, Engine::Filtered}) {
    ClusterOptions options;
    options.engine = engine;
    const Clustering made = cluster(surface, options);
    REQUIRE(made.merges.size() == 2);
    CHECK(made.merges[0].ties == 1);
    REQUIRE(made.merges[0].tie_evidence.proof);
    CHECK(*made.merges[0].tie_evidence.proof == TieProof::SquareClasses);
  }
}

TEST_CASE("costs that doubles cannot tell apart are told apart") {
  // A rectangle of 1 and 1 + e, and a square. Both cost (1 / 10) of the limit times their
  // perimeter^2 / (4 pi area), which is 16 + 4 e^2 / (1 + e) and 16, over 4 pi.
  const double longer = 1 + 0x1p-30;
  const Mesh mesh{PointSet(std::vector<Point>{{0, 0, 0},
                                              {1, 0, 0},
                                              {1, longer, 0},
                                              {0, longer, 0},
                                              {5, 0, 3},
                                              {6, 0, 3},
                                              {6, 1, 3},
                                              {5, 1, 3}}),
                  {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}},
                  {}};
  const Surface surface = make_surface(mesh);
  for (const Engine engine : {Engine::Exact, Engine::Filtered}) {
    ClusterOptions options;
    options.engine = engine;
    const Clustering made = cluster(surface, options);
    REQUIRE(made.merges.size() == 2);
    CHECK(made.merges[0].kept == TriangleId(2));
    CHECK(made.merges[0].ties == 0);
  }
}

TEST_CASE("the filtered engine merges as the exact one does, on needles") {
  const char* folder = std::getenv("CONVEXACT_TEST_DATA");
  REQUIRE(folder != nullptr);
  Compared all;
  ClusterOptions options;
  options.limit.value = 0;
  options.max_parts = 2;
  compare_engines(make_surface(read_mesh(std::string(folder) + "/faults/m6.obj")), options, all);
  // Terrains on a line, so thin that the normals of hulls in doubles are mostly rounding.
  std::mt19937 random(6);
  const Point along(-0.43, 0.4835, -0.0301);
  for (int exponent = -50; exponent <= -30; exponent += 2) {
    const Mesh wide = terrain(3, 2, 3, 0, random);
    std::vector<Point> points;
    for (const Point& p : wide.points.doubles()) {
      points.emplace_back((p[0] + 4 * p[1]) * along + std::ldexp(1.0, exponent) * p);
    }
    const Surface surface = make_surface({PointSet(points), wide.polygons, {}});
    for (const auto measure : {ConcavityMeasure::Surface, ConcavityMeasure::Vertices}) {
      options.measure = measure;
      options.max_parts =
          std::max<std::size_t>(2, count_groups(surface, neighbours(surface, options.connect)));
      compare_engines(surface, options, all);
    }
  }
  CHECK(all.merges > 100);
}
