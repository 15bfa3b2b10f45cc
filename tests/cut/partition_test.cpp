// SPDX-License-Identifier: MIT
// Solids cut by planes. Numbers of leaves and volumes are closed forms; that leaves hold the solid
// is decided by the overlay of surfaces and parts, which shares nothing with the cuts.
#include "convexact/partition.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "cells.hpp"
#include "convexact/measure.hpp"
#include "convexact/reach.hpp"
#include "sweep.hpp"

using namespace convexact;
using namespace support;

namespace {

struct Cut {
  Surface surface;
  std::optional<Winding> winding;
  Partition partition;
  Rational squared_limit;

  explicit Cut(const Mesh& mesh, const char* share = "1/100", PartitionOptions options = {})
      : surface(make_surface(mesh)) {
    if (surface.is_closed) winding.emplace(surface);
    const Rational limit = parse_rational(share);
    squared_limit = limit * limit * bounding_box(surface.points).squared_diameter();
    ReachLimit reach(surface, winding ? &*winding : nullptr, squared_limit);
    partition = cut(surface, winding ? &*winding : nullptr, reach, options);
  }
  std::vector<ConvexPart> hulls() const {
    std::vector<ConvexPart> list;
    for (const PartitionLeaf& leaf : partition.leaves) list.push_back(convex_part(leaf.corners));
    return list;
  }
  Rational volumes() const {
    Rational sum = 0;
    for (const ConvexPart& hull : hulls()) {
      if (hull.solid) sum += volume(*hull.solid);
    }
    return sum;
  }
};

std::vector<RationalPoint> corners_of(const PartitionLeaf& leaf) {
  std::vector<RationalPoint> corners;
  for (std::size_t k = 0; k < leaf.corners.size(); ++k) corners.push_back(leaf.corners[PointId(k)]);
  return corners;
}

// The promises of every partition.
void check_promises(const Cut& made) {
  const std::vector<ConvexPart> hulls = made.hulls();
  const SurfaceCoverage coverage = find_uncovered(made.surface, hulls);
  CHECK(coverage.uncovered.empty());
  if (made.winding) CHECK(!find_uncovered_solid(made.surface, *made.winding, hulls, coverage));
  std::vector<BoundingBox> boxes;
  for (const ConvexPart& hull : hulls) boxes.push_back(hull.box);
  ReachLimit limit(made.surface, made.winding ? &*made.winding : nullptr, made.squared_limit,
                   boxes);
  for (std::size_t k = 0; k < hulls.size(); ++k) {
    const PartitionLeaf& leaf = made.partition.leaves[k];
    CHECK(leaf.is_within);
    CHECK(leaf.is_flat == !hulls[k].solid);
    CHECK(leaf.corners.size() == hulls[k].vertices.size());
    CHECK(limit(hulls[k]).reach == Reach::Within);
  }
  for (std::size_t a = 0; a < hulls.size(); ++a) {
    for (std::size_t b = a + 1; b < hulls.size(); ++b) {
      CHECK(!common_interior(hulls[a], hulls[b]));
    }
  }
  // Each leaf lies within the halfspaces on its way from the root.
  for (const PartitionLeaf& leaf : made.partition.leaves) {
    for (std::uint32_t n = leaf.node; made.partition.nodes[n].parent;) {
      const std::uint32_t above = *made.partition.nodes[n].parent;
      const PartitionNode& node = made.partition.nodes[above];
      const bool is_upper = node.children[1] == n;
      for (const RationalPoint& x : corners_of(leaf)) {
        const Rational value = (*node.plane)(x);
        CHECK((is_upper ? value >= 0 : value <= 0));
      }
      n = above;
    }
  }
}

std::set<Cell> plus() { return {{1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}, {1, 2, 0}}; }

std::set<Cell> stairs(int steps) {
  std::set<Cell> cells;
  for (int x = 0; x < steps; ++x) {
    for (int z = 0; z <= x; ++z) cells.insert({x, 0, z});
  }
  return cells;
}

// All cells of a block but some.
std::set<Cell> block_without(int size, const std::set<Cell>& gone) {
  std::set<Cell> cells;
  for (int x = 0; x < size; ++x) {
    for (int y = 0; y < size; ++y) {
      for (int z = 0; z < size; ++z) {
        if (!gone.contains({x, y, z})) cells.insert({x, y, z});
      }
    }
  }
  return cells;
}

Mesh joined_boxes(const std::vector<Box>& boxes, const std::vector<bool>& reversed) {
  std::vector<Point> points;
  Mesh mesh;
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    const auto first = static_cast<std::uint32_t>(points.size());
    for (const Point& corner : box_corners(boxes[k])) points.push_back(corner);
    for (std::vector<std::uint32_t> face : box_faces()) {
      for (std::uint32_t& c : face) c += first;
      if (reversed[k]) std::reverse(face.begin(), face.end());
      mesh.polygons.push_back(face);
    }
  }
  mesh.points = PointSet(points);
  return mesh;
}

Mesh scaled(const Mesh& mesh, double factor) {
  std::vector<Point> points;
  for (const Point& p : mesh.points.doubles()) points.push_back(p * factor);
  Mesh other = mesh;
  other.points = PointSet(points);
  return other;
}

bool same_planes(const Partition& a, const Partition& b) {
  if (a.nodes.size() != b.nodes.size() || a.leaves.size() != b.leaves.size()) return false;
  for (std::size_t n = 0; n < a.nodes.size(); ++n) {
    if (a.nodes[n].plane != b.nodes[n].plane || a.nodes[n].raised != b.nodes[n].raised) {
      return false;
    }
  }
  for (std::size_t k = 0; k < a.leaves.size(); ++k) {
    if (corners_of(a.leaves[k]) != corners_of(b.leaves[k])) return false;
    if (a.leaves[k].triangles != b.leaves[k].triangles) return false;
  }
  return true;
}

// Boxes in general position: turned by rotations whose entries are doubles only.
Mesh turned_boxes(std::mt19937_64& random, int count) {
  const auto unit = [&] { return static_cast<double>(random() >> 40) * 0x1p-24; };
  std::vector<Point> points;
  Mesh mesh;
  for (int k = 0; k < count; ++k) {
    const double a = 6 * unit(), b = 6 * unit();
    const Box box{{-unit(), -unit(), -unit()}, {unit() + 0.1, unit() + 0.1, unit() + 0.1}};
    const auto first = static_cast<std::uint32_t>(points.size());
    for (const Point& p : box_corners(box)) {
      const Point q(p[0] * std::cos(a) - p[1] * std::sin(a),
                    p[0] * std::sin(a) + p[1] * std::cos(a), p[2]);
      points.emplace_back(q[0], q[1] * std::cos(b) - q[2] * std::sin(b),
                          q[1] * std::sin(b) + q[2] * std::cos(b));
    }
    for (std::vector<std::uint32_t> face : box_faces()) {
      for (std::uint32_t& c : face) c += first;
      mesh.polygons.push_back({face[0], face[1], face[2]});
      mesh.polygons.push_back({face[0], face[2], face[3]});
    }
  }
  mesh.points = PointSet(points);
  return mesh;
}

std::set<Cell> random_cells(std::mt19937_64& random) {
  std::set<Cell> cells;
  const std::size_t count = 1 + random() % 12;
  for (std::size_t k = 0; k < count; ++k) {
    cells.insert({static_cast<int>(random() % 3), static_cast<int>(random() % 3),
                  static_cast<int>(random() % 3)});
  }
  return cells;
}

}  // namespace

TEST_CASE("cut: solids of cells take about as many leaves as they need, and nothing beyond" *
          sweep) {
  std::set<Cell> ring = block_without(3, {});
  std::erase_if(ring,
                [](const Cell& cell) { return cell[2] != 0 || (cell[0] == 1 && cell[1] == 1); });
  std::set<Cell> cross = {{1, 1, 1}, {0, 1, 1}, {2, 1, 1}, {1, 0, 1},
                          {1, 2, 1}, {1, 1, 0}, {1, 1, 2}};
  const struct {
    const char* name;
    std::set<Cell> cells;
    std::size_t leaves;
  } shapes[] = {{"cube", {{0, 0, 0}}, 1},
                {"L", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 2},
                {"U", {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 1, 0}}, 3},
                {"plus", plus(), 3},
                {"ring", ring, 4},
                {"stairs", stairs(5), 5},
                {"cavity", block_without(3, {{1, 1, 1}}), 6},
                {"bin", block_without(3, {{1, 1, 1}, {1, 1, 2}}), 5},
                {"cross", cross, 5}};
  for (const auto& shape : shapes) {
    CAPTURE(shape.name);
    const Cut made(mesh_of_cells(shape.cells));
    check_promises(made);
    // What is cut once too often is merged again: tests/parts.
    CHECK(made.partition.leaves.size() >= shape.leaves);
    CHECK(made.partition.leaves.size() <= shape.leaves + 1);
    CHECK(made.volumes() == Rational(static_cast<long>(shape.cells.size())));
  }
}

TEST_CASE("cut: nested, crossing and inside-out boxes") {
  const Box outer{{0, 0, 0}, {8, 8, 8}}, inner{{2, 2, 2}, {5, 5, 5}},
      crossing{{4, 4, 4}, {12, 9, 7}};
  // A cavity: 512 - 27, in six leaves.
  const Cut hollow(joined_boxes({outer, inner}, {false, true}));
  check_promises(hollow);
  CHECK(hollow.partition.leaves.size() == 6);
  CHECK(hollow.volumes() == 485);
  // A body within a body adds nothing.
  const Cut filled(joined_boxes({outer, inner}, {false, false}));
  check_promises(filled);
  CHECK(filled.partition.leaves.size() == 1);
  // What two boxes have in common is counted once: 512 + 8 * 5 * 3 - 4 * 4 * 3.
  const Cut crossed(joined_boxes({outer, crossing}, {false, false}));
  check_promises(crossed);
  CHECK(crossed.volumes() >= 584);
  // All turned around: the same.
  const Cut reversed(joined_boxes({outer, crossing}, {true, true}));
  CHECK(same_planes(reversed.partition, crossed.partition));
}

TEST_CASE("cut: random solids of cells, and boxes in general position" * sweep) {
  std::mt19937_64 random(48);
  for (int k = 0; k < 60; ++k) {
    CAPTURE(k);
    const std::set<Cell> cells = random_cells(random);
    const Cut made(mesh_of_cells(cells), "1/50");
    check_promises(made);
    CHECK(made.volumes() >= Rational(static_cast<long>(cells.size())));
  }
  for (int k = 0; k < 12; ++k) {
    CAPTURE(k);
    check_promises(Cut(turned_boxes(random, 1 + k % 3), "1/20"));
  }
}

TEST_CASE("cut: an open surface is covered, and what bounds nothing has no inside") {
  Mesh box = box_mesh({{0, 0, 0}, {4, 4, 4}});
  box.polygons.pop_back();
  const Cut made(box);
  CHECK(!made.winding);
  check_promises(made);
  // Five squares, of which no two have a hull near them.
  CHECK(made.partition.leaves.size() >= 5);
  for (const PartitionLeaf& leaf : made.partition.leaves) CHECK(leaf.is_flat);
}

TEST_CASE("cut: the exact engine cuts alike" * sweep) {
  std::mt19937_64 random(481);
  for (int k = 0; k < 12; ++k) {
    CAPTURE(k);
    const Mesh mesh = k % 2 == 0 ? mesh_of_cells(random_cells(random)) : turned_boxes(random, 2);
    const CutPlanes planes = k % 3 == 0 ? CutPlanes::Bisectors : CutPlanes::All;
    const Cut filtered(mesh, "1/20", {.planes = planes}),
        exact(mesh, "1/20", {.is_exact = true, .planes = planes});
    CHECK(same_planes(filtered.partition, exact.partition));
  }
}

TEST_CASE("cut: boxes apart have no notch, and are parted all the same") {
  const Cut made(mesh_of_cells({{0, 0, 0}, {3, 0, 0}}), "1/20", {.planes = CutPlanes::Bisectors});
  check_promises(made);
  CHECK(made.volumes() == 2);
}

TEST_CASE("cut: a ring is cut along chords, or across if asked to") {
  Mesh tube;
  std::vector<Point> points;
  constexpr std::uint32_t kSides = 24;
  for (std::uint32_t i = 0; i < kSides; ++i) {
    const double angle = 2 * M_PI * i / kSides;
    for (const double radius : {0.6, 1.0}) {
      for (const double z : {0.0, 2.0}) {
        points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
      }
    }
    const std::uint32_t a = 4 * i,
                        b = (a + 4) % (4 * kSides);  // inner below, above, outer likewise
    for (const auto& [from, to] : {std::pair(2u, 3u), {3u, 1u}, {1u, 0u}, {0u, 2u}}) {
      tube.polygons.push_back({a + from, b + from, b + to, a + to});
    }
  }
  tube.points = PointSet(points);
  // Within 1.5% of the diameter are sectors of three sides.
  const Cut along(tube, "3/200"), across(tube, "3/200", {.planes = CutPlanes::Bisectors});
  CHECK(across.partition.leaves.size() == 8);
  CHECK(along.partition.leaves.size() > 8);
  check_promises(across);
  check_promises(along);
}

TEST_CASE("cut: the cuts are the same for any number of threads") {
  // A torus of 1,200 corners, enough for threads to be worth it.
  Mesh torus;
  std::vector<Point> points;
  constexpr std::uint32_t kAround = 40, kAcross = 30;
  for (std::uint32_t i = 0; i < kAround; ++i) {
    for (std::uint32_t k = 0; k < kAcross; ++k) {
      const double u = 2 * M_PI * i / kAround, v = 2 * M_PI * k / kAcross;
      const double radius = 2 + std::cos(v);
      points.emplace_back(radius * std::cos(u), radius * std::sin(u), std::sin(v));
      const auto at = [&](std::uint32_t a, std::uint32_t b) {
        return a % kAround * kAcross + b % kAcross;
      };
      torus.polygons.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
      torus.polygons.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
    }
  }
  torus.points = PointSet(points);
  const Cut alone(torus, "3/100");
  CHECK(alone.partition.leaves.size() > 4);
  for (const std::size_t jobs : {2u, 3u, 8u}) {
    const Cut made(torus, "3/100", {.jobs = jobs});
    REQUIRE(made.partition.nodes.size() == alone.partition.nodes.size());
    for (std::size_t n = 0; n < made.partition.nodes.size(); ++n) {
      CHECK(made.partition.nodes[n].plane == alone.partition.nodes[n].plane);
    }
    CHECK(made.partition.planes_tried == alone.partition.planes_tried);
    REQUIRE(made.partition.leaves.size() == alone.partition.leaves.size());
    for (std::size_t k = 0; k < made.partition.leaves.size(); ++k) {
      CHECK(made.partition.leaves[k].is_within == alone.partition.leaves[k].is_within);
      CHECK(made.partition.leaves[k].triangles == alone.partition.leaves[k].triangles);
      CHECK(corners_of(made.partition.leaves[k]) == corners_of(alone.partition.leaves[k]));
    }
  }
}

TEST_CASE("cut: any number of threads stops at as many leaves, and takes facets alone") {
  std::mt19937_64 random(483);
  const Mesh mesh = turned_boxes(random, 3);
  for (const PartitionOptions& options :
       {PartitionOptions{.max_leaves = 5}, PartitionOptions{.planes = CutPlanes::Facets}}) {
    const Cut alone(mesh, "1/100", options);
    CHECK(alone.partition.leaves.size() >= 5);
    CHECK(alone.partition.stopped_by_count == options.max_leaves.has_value());
    for (const std::size_t jobs : {2u, 8u}) {
      PartitionOptions several = options;
      several.jobs = jobs;
      const Cut made(mesh, "1/100", several);
      REQUIRE(made.partition.nodes.size() == alone.partition.nodes.size());
      for (std::size_t n = 0; n < made.partition.nodes.size(); ++n) {
        CHECK(made.partition.nodes[n].plane == alone.partition.nodes[n].plane);
      }
      CHECK(made.partition.planes_tried == alone.partition.planes_tried);
      CHECK(made.partition.leaves.size() == alone.partition.leaves.size());
    }
  }
  CHECK_THROWS_AS(Cut(mesh, "1/100", {.jobs = 0}), Error);
}

TEST_CASE("cut: scale by powers of two, order and repeats change nothing") {
  std::mt19937_64 random(482);
  const Mesh mesh = turned_boxes(random, 2);
  const Cut made(mesh, "1/20");
  for (const double factor : {0x1p300, 0x1p-300}) {
    const Cut other(scaled(mesh, factor), "1/20");
    REQUIRE(other.partition.nodes.size() == made.partition.nodes.size());
    for (std::size_t k = 0; k < made.partition.leaves.size(); ++k) {
      const auto a = corners_of(made.partition.leaves[k]),
                 b = corners_of(other.partition.leaves[k]);
      REQUIRE(a.size() == b.size());
      for (std::size_t v = 0; v < a.size(); ++v) CHECK(a[v] * to_rational(factor) == b[v]);
    }
  }
  Mesh shuffled = mesh;
  std::shuffle(shuffled.polygons.begin(), shuffled.polygons.end(), random);
  std::vector<Point> points(mesh.points.doubles().begin(), mesh.points.doubles().end());
  points.push_back(points.front());
  shuffled.polygons.front() = [&] {
    std::vector<std::uint32_t> face = shuffled.polygons.front();
    for (std::uint32_t& c : face) c = c == 0 ? static_cast<std::uint32_t>(points.size() - 1) : c;
    return face;
  }();
  shuffled.points = PointSet(points);
  CHECK(same_planes(Cut(shuffled, "1/20").partition, made.partition));
}

TEST_CASE("cut: as many leaves as allowed") {
  PartitionOptions options;
  options.max_leaves = 2;
  const Cut made(mesh_of_cells(plus()), "1/100", options);
  CHECK(made.partition.leaves.size() == 2);
  CHECK(made.partition.stopped_by_count);
  CHECK(std::any_of(made.partition.leaves.begin(), made.partition.leaves.end(),
                    [](const PartitionLeaf& leaf) { return !leaf.is_within; }));
  const std::vector<ConvexPart> hulls = made.hulls();
  CHECK(!find_uncovered_solid(made.surface, *made.winding, hulls,
                              find_uncovered(made.surface, hulls)));
}
