// SPDX-License-Identifier: MIT
// What every clustering is: a partition into connected clusters within the limit, of which no two
// neighbours can merge; closed forms; and changes of the input that change nothing.
#include "convexact/cluster.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <numbers>
#include <numeric>

#include "convexact/io.hpp"
#include "expect_error.hpp"
#include "small_surfaces.hpp"
#include "sweep.hpp"

using namespace convexact;
using namespace support;

namespace {

using Clusters = std::vector<std::vector<TriangleId>>;

Rational concavity_of(const Surface& surface, const std::vector<TriangleId>& triangles,
                      ConcavityMeasure measure) {
  const ConvexPart hull = convex_part(subset(surface.points, points_of(surface, triangles)));
  return ExactConcavity(surface, measure)(triangles, hull).squared;
}

// The laws of a clustering that the limit ended.
void check_laws(const Surface& surface, const ClusterOptions& options) {
  const Clustering made = cluster(surface, options);
  ClusterOptions without_merges = options;
  without_merges.every_merge = false;
  CHECK(cluster(surface, without_merges).clusters == made.clusters);
  std::vector<std::uint32_t> of(surface.triangles.size(), UINT32_MAX);
  std::uint32_t last_name = 0;
  for (std::uint32_t k = 0; k < made.clusters.size(); ++k) {
    const auto& triangles = made.clusters[k];
    REQUIRE_FALSE(triangles.empty());
    CHECK(std::is_sorted(triangles.begin(), triangles.end()));
    CHECK((k == 0 || triangles.front().value > last_name));
    last_name = triangles.front().value;
    for (const TriangleId t : triangles) {
      CHECK(of[t.index()] == UINT32_MAX);
      of[t.index()] = k;
    }
    // A triangle without area may bring a concavity along, and a single triangle has one by
    // Vertices where the normal of a corner lies in its plane.
    if (surface.flat_triangles == 0 && triangles.size() > 1) {
      CHECK(concavity_of(surface, triangles, options.measure) <= made.squared_limit);
    }
  }
  CHECK(std::count(of.begin(), of.end(), UINT32_MAX) == 0);
  const auto pairs = neighbours(surface, options.connect);
  std::vector<std::pair<TriangleId, TriangleId>> inside;
  std::set<std::pair<std::uint32_t, std::uint32_t>> beside;
  for (const auto& [a, b] : pairs) {
    const auto [x, y] = std::minmax(of[a.index()], of[b.index()]);
    if (x == y) {
      inside.emplace_back(a, b);
    } else {
      beside.emplace(x, y);
    }
  }
  CHECK(count_groups(surface, inside) == made.clusters.size());  // each hangs together
  for (const auto& [x, y] : beside) {
    std::vector<TriangleId> both = made.clusters[x];
    both.insert(both.end(), made.clusters[y].begin(), made.clusters[y].end());
    std::sort(both.begin(), both.end());
    CHECK(concavity_of(surface, both, options.measure) > made.squared_limit);
  }
}

std::size_t parts(const Surface& surface, const ClusterOptions& options = {}) {
  return cluster(surface, options).clusters.size();
}

Surface cells(const std::set<Cell>& of) { return make_surface(mesh_of_cells(of)); }

std::set<Cell> plus_cells() { return {{1, 1, 0}, {0, 1, 0}, {2, 1, 0}, {1, 0, 0}, {1, 2, 0}}; }
std::set<Cell> u_cells() { return {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 1, 0}}; }

// The sum of the volumes of the hulls, if these are solid.
Rational volume_of_hulls(const Surface& surface, const Clusters& clusters) {
  Rational sum = 0;
  for (const auto& triangles : clusters) {
    const ConvexPart part = convex_part(subset(surface.points, points_of(surface, triangles)));
    if (part.solid) sum += volume(*part.solid);
  }
  return sum;
}

// A ball of rings and sectors about a center.
void add_ball(const Point& center, int rings, int sectors, Mesh& mesh) {
  std::vector<Point> points(mesh.points.doubles().begin(), mesh.points.doubles().end());
  const auto first = std::uint32_t(points.size());
  points.push_back(center + Point(0, 0, 1));
  points.push_back(center - Point(0, 0, 1));
  for (int i = 1; i < rings; ++i) {
    for (int j = 0; j < sectors; ++j) {
      const double a = std::numbers::pi * i / rings, b = 2 * std::numbers::pi * j / sectors;
      points.push_back(center +
                       Point(std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a)));
    }
  }
  const auto at = [&](int i, int j) {
    return first + 2 + std::uint32_t((i - 1) * sectors + j % sectors);
  };
  for (int j = 0; j < sectors; ++j) {
    mesh.polygons.push_back({first, at(1, j), at(1, j + 1)});
    mesh.polygons.push_back({first + 1, at(rings - 1, j + 1), at(rings - 1, j)});
    for (int i = 1; i + 1 < rings; ++i) {
      mesh.polygons.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.polygons.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  mesh.points = PointSet(std::move(points));
}

}  // namespace

TEST_CASE("laws of clusterings, on terrains, cells and pieces of meshes" * sweep) {
  std::mt19937 random(1);
  ClusterOptions options;
  for (int round = 0; round < 40; ++round) {
    CAPTURE(round);
    options.limit.value = std::array{Rational(0), Rational(1, 50), Rational(1, 8)}[round % 3];
    options.measure = round % 2 == 0 ? ConcavityMeasure::Surface : ConcavityMeasure::Vertices;
    check_laws(make_surface(terrain(5, 4, 1 + unsigned(round) % 4, 3, random)), options);
    check_laws(cells(random_cells(2 + round % 6, random)), options);
  }
  const char* folder = std::getenv("CONVEXACT_TEST_DATA");
  REQUIRE(folder != nullptr);
  options = {};
  for (const char* mesh : {"spot.obj", "teapot.obj", "bunny.obj"}) {
    const Surface whole = make_surface(read_mesh(std::string(folder) + "/" + mesh));
    for (const auto measure : {ConcavityMeasure::Surface, ConcavityMeasure::Vertices}) {
      options.measure = measure;
      check_laws(first_triangles(whole, 500), options);
    }
  }
}

TEST_CASE("concavity never falls along the forest of merges") {
  std::mt19937 random(21);
  for (int round = 0; round < 10; ++round) {
    const Surface surface = make_surface(terrain(6, 6, 3, 0, random));
    ClusterOptions options;
    options.limit.value = Rational(1, 5);
    options.costs = true;
    std::map<std::uint32_t, Rational> square;
    for (const Merge& merge : cluster(surface, options).merges) {
      REQUIRE(merge.squared_concavity);
      REQUIRE(merge.cost);
      CHECK(*merge.squared_concavity >= square[merge.kept.value]);
      CHECK(*merge.squared_concavity >= square[merge.gone.value]);
      square[merge.kept.value] = *merge.squared_concavity;
    }
  }
}

TEST_CASE("an edge of three triangles is on the boundary of their cluster") {
  // Right triangles with sides 3, 4, 5 in a plane, all with the edge from (0, 0) to (0, 4): a
  // perimeter of 3 (3 + 5) + 4 = 28 and an area of 18; (weight / 10) 28^2 / (4 pi 18) with
  // weight 1.
  const Surface surface = make_surface(
      {PointSet(std::vector<Point>{{0, 0, 0}, {0, 4, 0}, {3, 0, 0}, {-3, 0, 0}, {3, 4, 0}}),
       {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}},
       {}});
  for (const Engine engine : {Engine::Exact, Engine::Filtered}) {
    ClusterOptions options;
    options.limit = {.value = 1, .is_share = false};
    options.engine = engine;
    options.costs = true;
    const Clustering made = cluster(surface, options);
    REQUIRE(made.merges.size() == 2);
    const double cost = 784 / (720 * std::numbers::pi);
    CHECK(made.merges.back().cost->low_double() == doctest::Approx(cost).epsilon(1e-12));
    CHECK(made.merges.back().cost->high_double() == doctest::Approx(cost).epsilon(1e-12));
  }
}

TEST_CASE("closed forms: as few parts as there can be, and nothing added") {
  // None of these shapes is convex, and each is a union of that many boxes and of no fewer convex
  // sets inside it.
  const std::vector<std::pair<std::set<Cell>, std::size_t>> shapes{
      {l_cells(), 2}, {u_cells(), 3}, {plus_cells(), 3}, {ring_cells(), 4}};
  for (const auto& [shape, least] : shapes) {
    const Surface surface = cells(shape);
    const Clustering made = cluster(surface);
    CHECK(made.clusters.size() == least);
    CHECK(volume_of_hulls(surface, made.clusters) >= Rational(shape.size()));
  }
  // Measured at vertices, all of these are convex: each vertex is on the hull.
  ClusterOptions at_vertices;
  at_vertices.measure = ConcavityMeasure::Vertices;
  for (const auto& [shape, least] : shapes) CHECK(parts(cells(shape), at_vertices) == 1);
}

TEST_CASE("convex shapes are one part at every limit, and its hull is theirs") {
  Mesh ball;
  add_ball({0, 0, 0}, 6, 8, ball);
  for (const Mesh& mesh :
       {mesh_of_cells({{0, 0, 0}}), mesh_of_cells({{0, 0, 0}, {1, 0, 0}}), ball}) {
    const Surface surface = make_surface(mesh);
    for (const Rational& limit : {Rational(0), Rational(1, 100), Rational(1)}) {
      for (const auto measure : {ConcavityMeasure::Surface, ConcavityMeasure::Vertices}) {
        ClusterOptions options;
        options.limit.value = limit;
        options.measure = measure;
        // A tessellated ball may be a little concave: its quadrilaterals are bent by rounding.
        if (limit == 0 && mesh.polygons.size() > 12) continue;
        CHECK(parts(surface, options) == 1);
      }
    }
  }
}

TEST_CASE("without every merge: the same clusters, also for a number of parts and a tree") {
  Mesh mesh = mesh_of_cells({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});  // an L
  const auto add_box = [&](double x) {
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    std::vector<Point> points(mesh.points.doubles().begin(), mesh.points.doubles().end());
    for (const Point& p : box_corners({{x, 0, 0}, {x + 2, 1, 1}})) points.push_back(p);
    mesh.points = PointSet(points);
    for (std::vector<std::uint32_t> face : box_faces()) {
      for (std::uint32_t& corner : face) corner += first;
      mesh.polygons.push_back(std::move(face));
    }
  };
  add_box(5);
  add_box(9);
  const Surface surface = make_surface(mesh);
  const Rational l_concavity = concavity_of(
      surface,
      [&] {
        std::vector<TriangleId> triangles;
        for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
          if (surface.component[t] == surface.component[0]) triangles.push_back(TriangleId(t));
        }
        return triangles;
      }(),
      ConcavityMeasure::Surface);
  CHECK(l_concavity == 1);  // from the inner faces of the L to the plane that closes it
  const Rational below_one = 1 - scale_by_power_of_two(Rational(1), -200);  // not in doubles
  for (const Rational& limit :
       {Rational(0), Rational(999, 1000), below_one, Rational(1), Rational(1001, 1000)}) {
    for (const std::optional<std::size_t> most :
         {std::optional<std::size_t>(), std::optional<std::size_t>(3)}) {
      ClusterOptions options;
      options.limit = {.value = limit, .is_share = false};
      options.max_parts = most;
      options.further = true;
      const Clustering all = cluster(surface, options);
      options.every_merge = false;
      const Clustering some = cluster(surface, options);
      CHECK(some.clusters == all.clusters);
      CHECK(some.further_merges == all.further_merges);
      CHECK(some.stopped_by_count == all.stopped_by_count);
      CHECK(some.whole_groups >= (limit > 1 ? 3 : 2));  // the boxes; the L beyond its concavity
      CHECK(some.whole_groups <= (limit < 1 ? 2 : 3));
      CHECK(all.whole_groups == 0);
    }
  }
}

TEST_CASE("without every merge: a single dent in many triangles is seen" * sweep) {
  Mesh ball;
  add_ball({0, 0, 0}, 12, 16, ball);
  std::size_t seen = 0;
  for (std::size_t dented = 20; dented < 60; dented += 3) {
    // A corner in the middle of one face, pushed inwards by a third.
    Mesh mesh = ball;
    const std::vector<std::uint32_t> face = mesh.polygons[dented];
    std::vector<Point> points(mesh.points.doubles().begin(), mesh.points.doubles().end());
    Point middle = Point::Zero();
    for (const std::uint32_t corner : face) middle += points[corner] / double(face.size());
    points.push_back(middle * 2 / 3);
    mesh.points = PointSet(points);
    mesh.polygons.erase(mesh.polygons.begin() + static_cast<std::ptrdiff_t>(dented));
    for (std::size_t k = 0; k < face.size(); ++k) {
      mesh.polygons.push_back(
          {face[k], face[(k + 1) % face.size()], static_cast<std::uint32_t>(points.size() - 1)});
    }
    const Surface surface = make_surface(mesh);
    ClusterOptions options;
    options.limit.value = Rational(1, 100);
    options.every_merge = false;
    const Clustering some = cluster(surface, options);
    CHECK(some.whole_groups == 0);
    seen += some.clusters.size() > 1;
  }
  CHECK(seen == 14);
}

TEST_CASE("four balls are four parts, joined at no limit below their distance" * sweep) {
  Mesh mesh;
  for (const Point& center : {Point(0, 0, 0), Point(3, 0, 0), Point(0, 3, 0), Point(3, 3, 0)}) {
    add_ball(center, 8, 12, mesh);
  }
  const Surface surface = make_surface(mesh);
  for (const Rational& limit : {Rational(1, 1000), Rational(3, 100), Rational(1)}) {
    ClusterOptions options;
    options.limit.value = limit;
    CHECK(parts(surface, options) == 4);
  }
  ClusterOptions three;
  three.max_parts = 3;
  const Error refused = error_of([&] { return cluster(surface, three); });
  CHECK(refused.code() == ErrorCode::InvalidArgument);
  CHECK(std::string(refused.what()).find("4 components") != std::string::npos);
}

TEST_CASE("a limit of the whole diameter leaves one part for each component") {
  std::mt19937 random(9);
  for (int round = 0; round < 10; ++round) {
    const Surface surface = make_surface(terrain(6, 5, 4, 12, random));
    ClusterOptions options;
    options.limit.value = 1;
    CHECK(parts(surface, options) == surface.components.size());
  }
}

TEST_CASE("the first merges do not depend on the number of parts") {
  const Surface surface = cells(random_cells(9, *std::make_unique<std::mt19937>(4)));
  ClusterOptions options;
  options.max_parts = 1;
  const Clustering whole = cluster(surface, options);
  CHECK(whole.clusters.size() == 1);
  for (std::size_t most = 2; most < 12; ++most) {
    options.max_parts = most;
    const Clustering made = cluster(surface, options);
    CHECK(made.clusters.size() <= std::max(most, made.clusters.size()));
    REQUIRE(made.merges.size() <= whole.merges.size());
    CHECK(std::equal(made.merges.begin(), made.merges.end(), whole.merges.begin()));
    CHECK(made.stopped_by_count ==
          std::any_of(made.merges.begin(), made.merges.end(),
                      [](const Merge& merge) { return merge.beyond_limit; }));
    if (made.stopped_by_count) CHECK(made.clusters.size() == most);
  }
}

TEST_CASE("no order of the input, no power of two and no repeated point changes the clusters") {
  std::mt19937 random(31);
  for (int round = 0; round < 12; ++round) {
    CAPTURE(round);
    const Mesh mesh =
        round % 2 == 0 ? terrain(5, 5, 2, 2, random) : mesh_of_cells(random_cells(6, random));
    ClusterOptions options;
    options.measure = round % 4 < 2 ? ConcavityMeasure::Surface : ConcavityMeasure::Vertices;
    const Clustering plain = cluster(make_surface(mesh), options);
    std::vector<std::uint32_t> order(mesh.points.size());
    std::iota(order.begin(), order.end(), 0u);
    std::shuffle(order.begin(), order.end(), random);
    for (const int exponent : {0, 300, -300}) {
      std::vector<Point> points(order.size());
      for (std::size_t p = 0; p < order.size(); ++p) {
        const Point& from = mesh.points.doubles()[p];
        for (int k = 0; k < 3; ++k) points[order[p]][k] = std::ldexp(from[k], exponent);
      }
      const std::size_t distinct = points.size();
      for (std::size_t p = 0; p < distinct; ++p) points.push_back(points[p]);
      Mesh changed = mesh;
      for (auto& face : changed.polygons) {
        for (auto& corner : face) {
          corner = order[corner] + (random() % 2 == 0 ? 0 : std::uint32_t(distinct));
        }
        std::rotate(face.begin(), face.begin() + random() % face.size(), face.end());
      }
      std::shuffle(changed.polygons.begin(), changed.polygons.end(), random);
      changed.points = PointSet(std::move(points));
      changed.parts.clear();
      const Surface surface = make_surface(changed);
      const Clustering made = cluster(surface, options);
      // The direction of an open surface is that of its lowest triangle as it came.
      CHECK(made.clusters == plain.clusters);
      CHECK(made.merges == plain.merges);
    }
  }
}

TEST_CASE("triangles without area join the neighbour over their longest edge") {
  // A needle between two triangles of a square, another at the border, and one on its own.
  const Mesh mesh{
      PointSet(std::vector<Point>{
          {0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 0}, {5, 5, 5}, {6, 6, 6}, {7, 7, 7}}),
      {{0, 1, 2}, {0, 2, 4}, {0, 4, 3}, {4, 2, 3}, {5, 6, 7}},
      {}};
  const Surface surface = make_surface(mesh);
  CHECK(surface.flat_triangles == 2);
  const Clustering made = cluster(surface);
  REQUIRE(made.united.size() == 1);
  const auto [needle, into] = made.united.front();
  CHECK(convex_part(subset(surface.points, points_of(surface, std::vector{needle}))).dimension ==
        1);
  // Over the edge from (0, 0) to (2, 2), of which each other one is half: to the first triangle.
  const auto& corners = surface.triangles[into.index()];
  CHECK(std::any_of(corners.begin(), corners.end(), [&](PointId p) {
    return surface.points.doubles()[p.index()] == Point(2, 0, 0);
  }));
  CHECK(made.clusters.size() == 2);
}

TEST_CASE("surfaces that are hardly any: laws hold") {
  const auto laws = [](const Mesh& mesh) {
    const Surface surface = make_surface(mesh);
    for (const auto measure : {ConcavityMeasure::Surface, ConcavityMeasure::Vertices}) {
      ClusterOptions options;
      options.measure = measure;
      check_laws(surface, options);
    }
    return surface;
  };
  const std::vector<Point> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                  {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  laws({PointSet(square), {{0, 1, 2}}, {}});                        // one triangle
  laws({PointSet(square), {{0, 1, 2}, {0, 2, 1}}, {}});             // a doubled sheet
  laws({PointSet(square), {{0, 1, 2}, {0, 1, 2}, {0, 1, 2}}, {}});  // repeated
  laws({PointSet(square),
        {{0, 1, 2, 3}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}},
        {}});                                            // no lid
  laws({PointSet(square), {{0, 1, 4}, {2, 3, 6}}, {}});  // two components
  laws({PointSet(square), {{0, 1, 4}, {4, 6, 7}}, {}});  // a bow tie
  // A Moebius strip of five quadrilaterals.
  std::vector<Point> strip;
  for (int k = 0; k < 5; ++k) {
    const double a = 2 * std::numbers::pi * k / 5, b = std::numbers::pi * k / 5;
    for (const double side : {-1.0, 1.0}) {
      const double radius = 3 + side * std::cos(b);
      strip.emplace_back(radius * std::cos(a), radius * std::sin(a), side * std::sin(b));
    }
  }
  std::vector<std::vector<std::uint32_t>> faces;
  for (std::uint32_t k = 0; k < 5; ++k) {
    const std::uint32_t a = 2 * k, b = a + 1, c = k == 4 ? 1 : a + 2, d = k == 4 ? 0 : a + 3;
    faces.push_back({a, b, c});
    faces.push_back({b, d, c});
  }
  CHECK_FALSE(laws({PointSet(strip), faces, {}}).components.front().is_orientable);
  // Slivers: an aspect of 1e16.
  laws({PointSet(std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0.5, 1e-16, 0}, {0.5, 1, 1}}),
        {{0, 1, 2}, {0, 2, 3}, {2, 1, 3}},
        {}});
}

TEST_CASE("what cannot be asked for is refused") {
  const Surface surface = cells(l_cells());
  const auto refuse = [&](auto change) {
    ClusterOptions options;
    change(options);
    CHECK(error_of([&] { return cluster(surface, options); }).code() == ErrorCode::InvalidArgument);
  };
  refuse([](ClusterOptions& options) { options.limit.value = -1; });
  refuse([](ClusterOptions& options) { options.limit.value = Rational(11, 10); });
  refuse([](ClusterOptions& options) { options.limit = {Rational(-1, 2), false}; });
  refuse([](ClusterOptions& options) { options.max_parts = 0; });
  ClusterOptions as_length;
  as_length.limit = {Rational(5), false};  // longer than the diameter is a limit, too
  CHECK(parts(surface, as_length) == 1);
}
