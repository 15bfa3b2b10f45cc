// SPDX-License-Identifier: MIT
// Whether parts lie within T of a solid. Expected values: closed forms, and worlds of grid cells in
// which the distance to the solid is the least distance to a box, in fractions.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "cells.hpp"
#include "convexact/reach.hpp"
#include "expect_error.hpp"
#include "hull/near_solid.hpp"
#include "near/frame.hpp"
#include "number/random.hpp"
#include "reach/clear_cell.hpp"
#include "reach/clipped_part.hpp"
#include "reach/reach_cells.hpp"
#include "reach/walk_cells.hpp"
#include "sweep.hpp"
using namespace convexact;
using support::Box;
using support::Cell;

namespace {

ConvexPart part_of(const std::vector<Point>& points) { return convex_part(PointSet(points)); }
ConvexPart part_of(const Box& box) { return part_of(support::box_corners(box)); }

// A surface with its winding numbers, which refer to it.
struct World {
  explicit World(const Mesh& mesh) : surface(make_surface(mesh)) {
    if (surface.is_closed) winding.emplace(surface);
  }
  World(const World&) = delete;

  ReachLimit limit(const Rational& squared, std::span<const ConvexPart> parts) const {
    std::vector<BoundingBox> boxes;
    for (const ConvexPart& part : parts) boxes.push_back(part.box);
    return ReachLimit(surface, winding ? &*winding : nullptr, squared, boxes);
  }
  PartReach ask(const Rational& squared, const ConvexPart& part) const {
    return limit(squared, std::span(&part, 1))(part);
  }

  Surface surface;
  std::optional<Winding> winding;
};

Rational squared_distance(const RationalPoint& x, const std::set<Cell>& cells) {
  std::optional<Rational> least;
  for (const Cell& cell : cells) {
    Rational sum = 0;
    for (int k = 0; k < 3; ++k) {
      const Rational below = cell[k] - x[k], above = x[k] - cell[k] - 1;
      const Rational gap = std::max<Rational>({below, above, Rational(0)});
      sum += gap * gap;
    }
    if (!least || sum < *least) least = sum;
  }
  return *least;
}

// The largest squared distance of the points of a part on the grid of quarters.
Rational largest_sampled(const ConvexPart& part, const std::set<Cell>& cells, int size) {
  Rational largest = 0;
  for (int i = -4; i <= 4 * size + 4; ++i) {
    for (int j = -4; j <= 4 * size + 4; ++j) {
      for (int k = -4; k <= 4 * size + 4; ++k) {
        const RationalPoint x(Rational(i, 4), Rational(j, 4), Rational(k, 4));
        if (holds(part, x)) largest = std::max<Rational>(largest, squared_distance(x, cells));
      }
    }
  }
  return largest;
}

// A beam of a U: two walls of height 2 on a floor, with a slot of width 2 between them.
std::set<Cell> slot_cells() {
  return {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {0, 0, 1}, {3, 0, 1}, {0, 0, 2}, {3, 0, 2}};
}

Rational squared_of(double x) { return to_rational(x) * to_rational(x); }

std::optional<FarPlace> farthest_in(ReachLimit& limit, const std::vector<Point>& points) {
  return limit.farthest_of_each(std::span(&points, 1)).front();
}

}  // namespace

TEST_CASE("reach: how far a box stands out of a cube is a closed form") {
  const World world(support::mesh_of_cells({{0, 0, 0}}));
  const ConvexPart part = part_of(Box{{0, 0, 0}, {1, 1, 1.25}});
  SUBCASE("within") { CHECK(world.ask(squared_of(0.26), part).reach == Reach::Within); }
  SUBCASE("beyond, with a witness") {
    const PartReach answer = world.ask(squared_of(0.249), part);
    REQUIRE(answer.reach == Reach::Beyond);
    REQUIRE(answer.witness);
    CHECK(holds(part, answer.witness->point));
    CHECK(answer.witness->squared > squared_of(0.249));
    CHECK(answer.witness->squared <= squared_of(0.25));
    CHECK(answer.witness->squared == squared_distance(answer.witness->point, {{0, 0, 0}}));
  }
  SUBCASE("a part in the solid reaches nowhere") {
    CHECK(world.ask(squared_of(0x1p-6), part_of(Box{{0, 0, 0}, {1, 1, 1}})).reach == Reach::Within);
  }
}

TEST_CASE("reach: at exactly T exact numbers decide" * sweep) {
  const World world(support::mesh_of_cells({{0, 0, 0}}));
  CHECK(world.ask(squared_of(0.25), part_of(Box{{0, 0, 0}, {1, 1, 1.25}})).reach == Reach::Within);
}

TEST_CASE("reach: the hull of a slot reaches half its width") {
  const std::set<Cell> cells = slot_cells();
  const World world(support::mesh_of_cells(cells));
  const ConvexPart hull = convex_part(world.surface.points);
  CHECK(world.ask(squared_of(1.03), hull).reach == Reach::Within);
  CHECK(world.ask(squared_of(0.99), hull).reach == Reach::Beyond);
  ReachLimit limit = world.limit(squared_of(1.05), {});
  CHECK(limit.allows(hull));
  CHECK(limit.cells() > 1);
  CHECK_FALSE(world.limit(squared_of(0.98), {}).allows(hull));
}

TEST_CASE("reach: flat parts, needles and points") {
  const std::set<Cell> cells = slot_cells();
  const World world(support::mesh_of_cells(cells));
  // Across the slot, half way up: its points are 1 from both walls, and 1 from the floor.
  const ConvexPart polygon = part_of({{0, 0, 2}, {4, 0, 2}, {4, 1, 2}, {0, 1, 2}});
  const ConvexPart slanted = part_of({{0, 0, 1}, {4, 0, 3}, {4, 1, 3}, {0, 1, 1}});
  const ConvexPart segment = part_of(std::vector<Point>{{0, 0.5, 2.5}, {4, 0.5, 2.5}});
  const ConvexPart needle =
      part_of({{0, 0.5, 2.5}, {4, 0.5, 2.5}, {2, 0.5 + 0x1p-30, 2.5}, {2, 0.5, 2.5 + 0x1p-40}});
  for (const ConvexPart& part : {polygon, slanted, segment, needle}) {
    CAPTURE(part.dimension);
    CHECK(world.ask(squared_of(1.04), part).reach == Reach::Within);
    const PartReach beyond = world.ask(squared_of(0.9), part);
    REQUIRE(beyond.reach == Reach::Beyond);
    CHECK(holds(part, beyond.witness->point));
    CHECK(squared_distance(beyond.witness->point, cells) > squared_of(0.9));
  }
  const ConvexPart point = part_of(std::vector<Point>{{2, 0.5, 1.75}});
  CHECK(world.ask(squared_of(0.75), point).reach == Reach::Within);
  CHECK(world.ask(squared_of(0.74), point).reach == Reach::Beyond);
}

TEST_CASE("reach: an open surface has no inside") {
  Mesh mesh = support::mesh_of_cells({{0, 0, 0}});
  mesh.polygons.pop_back();
  mesh.parts.clear();
  const World world(mesh);
  REQUIRE_FALSE(world.winding);
  const ConvexPart cube = convex_part(world.surface.points);
  // Without the top the middle of it is 1/2 from the walls, and the middle of the cube, too.
  CHECK(world.ask(squared_of(0.51), cube).reach == Reach::Within);
  CHECK(world.ask(squared_of(0.49), cube).reach == Reach::Beyond);
}

TEST_CASE("reach: components that cross, are nested or inside out are one solid") {
  // A cube of size 4 with an inner cube of size 2: as a second shell it changes nothing, as a void
  // it leaves the middle 1 from the solid.
  Mesh mesh = support::box_mesh({{0, 0, 0}, {4, 4, 4}});
  const auto with_box = [&](const Box& box, bool reversed) {
    Mesh both = mesh;
    std::vector<Point> points(mesh.points.doubles().begin(), mesh.points.doubles().end());
    for (const Point& p : support::box_corners(box)) points.push_back(p);
    both.points = PointSet(points);
    for (auto face : support::box_faces()) {
      for (auto& corner : face) corner += 8;
      if (reversed) std::reverse(face.begin(), face.end());
      both.polygons.push_back(face);
    }
    both.parts.clear();
    return both;
  };
  const ConvexPart hull = part_of(Box{{0, 0, 0}, {4, 4, 4}});
  const Box inner{{1, 1, 1}, {3, 3, 3}}, crossing{{3, 1, 1}, {6, 3, 3}};
  CHECK(World(with_box(inner, false)).ask(squared_of(0.1), hull).reach == Reach::Within);
  const World with_void(with_box(inner, true));
  CHECK(with_void.ask(squared_of(0.98), hull).reach == Reach::Beyond);
  CHECK(with_void.ask(squared_of(1.02), hull).reach == Reach::Within);
  CHECK(World(with_box(crossing, false)).ask(squared_of(0.1), hull).reach == Reach::Within);
  Mesh inside_out = mesh;
  for (auto& face : inside_out.polygons) std::reverse(face.begin(), face.end());
  CHECK(World(inside_out).ask(squared_of(0.1), hull).reach == Reach::Within);
}

TEST_CASE("reach: scaling by powers of two, shifts and finer triangles change nothing") {
  const std::set<Cell> cells = slot_cells();
  const Mesh mesh = support::mesh_of_cells(cells);
  const ConvexPart hull = convex_part(make_surface(mesh).points);
  for (const double limit : {0.9, 0.99, 1.03, 1.2}) {
    const PartReach plain = World(mesh).ask(squared_of(limit), hull);
    for (const int e : {-300, 300}) {
      Mesh scaled = mesh;
      std::vector<Point> points(mesh.points.doubles().begin(), mesh.points.doubles().end());
      for (Point& p : points) p *= std::ldexp(1.0, e);
      scaled.points = PointSet(points);
      const PartReach answer = World(scaled).ask(scale_by_power_of_two(squared_of(limit), 2 * e),
                                                 convex_part(scaled.points));
      CHECK(answer.reach == plain.reach);
      CHECK(answer.witness.has_value() == plain.witness.has_value());
      if (plain.witness) {
        CHECK(answer.witness->squared == scale_by_power_of_two(plain.witness->squared, 2 * e));
      }
    }
    // In rationals, as 10^6 + 1/3 is no double.
    std::vector<RationalPoint> moved;
    for (std::size_t p = 0; p < mesh.points.size(); ++p) {
      moved.push_back(mesh.points[PointId(p)] +
                      RationalVector3(Rational(3000001, 3), -7, Rational(1, 7)));
    }
    Mesh shifted = mesh;
    shifted.points = PointSet(moved);
    CHECK(World(shifted).ask(squared_of(limit), convex_part(shifted.points)).reach == plain.reach);
    // Eight times as many cells are the same solid.
    std::set<Cell> finer;
    for (const Cell& c : cells) {
      for (int k = 0; k < 8; ++k) {
        finer.insert({2 * c[0] + (k & 1), 2 * c[1] + (k >> 1 & 1), 2 * c[2] + (k >> 2)});
      }
    }
    const Mesh fine = support::mesh_of_cells(finer);
    CHECK(World(fine).ask(4 * squared_of(limit), convex_part(fine.points)).reach == plain.reach);
  }
}

TEST_CASE("reach: in worlds of cells, answers are those of the definition" * sweep) {
  constexpr int kSize = 3;
  Random random(2604);
  const auto below = [&](std::uint64_t n) { return static_cast<int>(uniform_below(random, n)); };
  std::size_t undecided = 0, within = 0, beyond = 0;
  for (int world = 0; world < 400; ++world) {
    std::set<Cell> cells;
    const int count = 2 + below(9);
    for (int k = 0; k < count; ++k) cells.insert({below(kSize), below(kSize), below(kSize)});
    const World at(support::mesh_of_cells(cells));
    REQUIRE(at.winding);
    std::vector<Point> points;
    const int corners = 1 + below(8);
    for (int k = 0; k < corners; ++k) {
      points.emplace_back(below(4 * kSize + 1) / 4.0, below(4 * kSize + 1) / 4.0,
                          below(4 * kSize + 1) / 4.0);
    }
    const ConvexPart part = part_of(points),
                     larger = part_of([&] {
                       std::vector<Point> more = points;
                       more.emplace_back(below(kSize + 1), below(kSize + 1), below(kSize + 1));
                       return more;
                     }());
    // Not a distance that cells and quarters have.
    const double limit = std::vector<double>{0.13, 0.31, 0.57, 0.83, 1.07}[below(5)];
    CAPTURE(world);
    CAPTURE(limit);
    ReachLimit reach = at.limit(squared_of(limit), std::vector{part, larger});
    const PartReach answer = reach(part);
    const Rational sampled = largest_sampled(part, cells, kSize);
    switch (answer.reach) {
      case Reach::Within:
        ++within;
        CHECK(sampled <= squared_of(limit));
        break;
      case Reach::Beyond: {
        ++beyond;
        REQUIRE(answer.witness);
        CHECK(holds(part, answer.witness->point));
        CHECK(answer.witness->squared == squared_distance(answer.witness->point, cells));
        CHECK(answer.witness->squared > squared_of(limit));
        CHECK_FALSE(reach.allows(part));
        // Monotone: what holds a part that is beyond is beyond.
        CHECK(reach(larger).reach == Reach::Beyond);
        CHECK_FALSE(reach.allows(larger));
        break;
      }
      case Reach::Undecided:
        ++undecided;
        REQUIRE(answer.bracket);
        CHECK(answer.bracket->low <= squared_of(limit));
        CHECK(answer.bracket->high > squared_of(limit));
        CHECK(sampled <= answer.bracket->high);
        CHECK_FALSE(reach.allows(part));
    }
    // The same in a fresh octree, whatever was asked before.
    CHECK(at.limit(squared_of(limit), std::vector{part, larger})(part).reach == answer.reach);
  }
  MESSAGE("within ", within, ", beyond ", beyond, ", undecided ", undecided);
  CHECK(within > 60);
  CHECK(beyond > 60);
  CHECK(undecided < 12);
}

TEST_CASE("reach: a box of cells is within a small distance iff the surface winds about each" *
          sweep) {
  constexpr int kSize = 4;
  Random random(45);
  const auto below = [&](std::uint64_t n) { return static_cast<int>(uniform_below(random, n)); };
  std::size_t within = 0, beyond = 0;
  for (int world = 0; world < 100; ++world) {
    std::set<Cell> cells;
    for (int k = 0; k < 48; ++k) cells.insert({below(kSize), below(kSize), below(kSize)});
    const World at(support::mesh_of_cells(cells));
    // (A cavity may be filled: shells that touch along an edge are not told apart.)
    const auto winds_about = [&](const Cell& cell) {
      const Rational half(1, 2);
      return *(*at.winding)(RationalPoint(cell[0] + half, cell[1] + half, cell[2] + half)) != 0;
    };
    ReachLimit limit = at.limit(squared_of(world % 2 == 0 ? 0x1p-12 : 0), {});
    for (int k = 0; k < 4; ++k) {
      std::array<int, 3> low{}, high{};
      bool is_there = true;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        low[axis] = below(kSize);
        high[axis] = std::min(low[axis] + 1 + below(2), kSize);
      }
      for (int x = low[0]; x < high[0]; ++x) {
        for (int y = low[1]; y < high[1]; ++y) {
          for (int z = low[2]; z < high[2]; ++z) {
            is_there = is_there && winds_about({x, y, z});
          }
        }
      }
      const ConvexPart part = part_of(Box{{double(low[0]), double(low[1]), double(low[2])},
                                          {double(high[0]), double(high[1]), double(high[2])}});
      CAPTURE(world);
      CHECK(limit.allows(part) == is_there);
      CHECK(limit(part).reach == (is_there ? Reach::Within : Reach::Beyond));
      ++(is_there ? within : beyond);
    }
  }
  CHECK(within > 50);
  CHECK(beyond > 50);
}

TEST_CASE("reach: at T = 0 a point outside refutes, however near") {
  const World world(support::mesh_of_cells({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  ReachLimit limit = world.limit(0, {});
  CHECK(limit(part_of(Box{{0, 0, 0}, {2, 1, 1}})).reach == Reach::Within);
  for (const double out : {1.0, 0x1p-6, 0x1p-12}) {
    const ConvexPart part = part_of(Box{{0, 0, 0}, {2, 1 + out, 1}});
    CAPTURE(out);
    CHECK_FALSE(limit.allows(part));
    const PartReach found = limit(part);
    REQUIRE(found.reach == Reach::Beyond);
    const RationalPoint& x = found.witness->point;
    CHECK(holds(part, x));
    CHECK(x[0] > 1);
    CHECK(x[1] > 1);
    CHECK(found.witness->squared == squared_distance(x, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  }
  // So thin that no point there is certain: volumes decide.
  const double out = 0x1p-40;
  CHECK(limit.allows(part_of(Box{{0, 0, 0}, {2, 1 + out, 1}})));
}

TEST_CASE("reach: along a facet that lies in a face, cells need not be small") {
  const World world(support::mesh_of_cells({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  ReachLimit limit = world.limit(squared_of(1e-5), {});
  CHECK(limit.allows(part_of(Box{{0, 0, 0}, {2, 1, 1}})));
  CHECK(limit.allows(part_of(Box{{0, 0, 0}, {1, 2, 1}})));
  // Cut at 45 degrees through the notch.
  CHECK(limit.allows(part_of(
      {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {0, 0, 1}, {2, 0, 1}, {2, 1, 1}, {1, 1, 1}})));
  CHECK(limit.cells() < 100);
  CHECK(limit(part_of(Box{{0, 0, 0}, {1, 1, 1 + 0x1p-15}})).reach == Reach::Beyond);
  CHECK(limit(part_of(Box{{0, 0, 0}, {1 + 0x1p-15, 2, 1}})).reach == Reach::Beyond);
}

TEST_CASE("reach: the farthest point of a hull whose facet runs through centers of cells") {
  const World world(support::mesh_of_cells({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  ReachLimit limit = world.limit(squared_of(1e-5), {});
  std::vector<Point> corners;
  for (std::size_t k = 0; k < world.surface.points.size(); ++k) {
    corners.push_back(limit.frame()(world.surface.points[PointId(k)]));
  }
  // In the middle of the slanted facet, 1/2 from both walls of the notch.
  const auto far = farthest_in(limit, corners);
  REQUIRE(far);
  const double unit = limit.frame().root_up(1);
  CHECK(far->distance <= unit / 2 * (1 + 1e-9));
  CHECK(far->distance > unit / 2 / 1.04);
  CHECK(limit.cells() < 100000);
}

TEST_CASE("reach: what a part has in a clear cell is near, in exact numbers" * sweep) {
  constexpr int kSize = 3;
  Random random(48);
  const auto below = [&](std::uint64_t n) { return static_cast<int>(uniform_below(random, n)); };
  const Rational squared = squared_of(0x1p-10);
  std::size_t clear = 0, outside = 0, others = 0;
  for (int world = 0; world < 40; ++world) {
    std::set<Cell> cells;
    for (int k = 0; k < 20; ++k) cells.insert({below(kSize), below(kSize), below(kSize)});
    const World at(support::mesh_of_cells(cells));
    std::vector<Point> points;
    for (int k = 0; k < 6; ++k) {
      points.emplace_back(below(2 * kSize + 1) / 2.0, below(2 * kSize + 1) / 2.0,
                          below(2 * kSize + 1) / 2.0);
    }
    const ConvexPart part = part_of(points);
    if (!part.solid) continue;
    const BoundingBox boxes[] = {bounding_box(at.surface.points), part.box};
    ReachCells octree(at.surface, &*at.winding, frame_around(boxes), squared);
    const std::optional<InnerPart> inner = inner_part(octree, NearPart(part, octree.frame()));
    REQUIRE(inner);
    const NearPart& near = inner->part;
    std::vector<MetCell> open{{octree.root(), {}}};
    for (std::uint32_t k = 0; k < near.planes(); ++k) open.front().planes.push_back(k);
    (void)octree.label(open.front().place);
    for (std::size_t k = 0; k < open.size() && k < 300; ++k) {
      const MetCell met = open[k];
      const NearHull hull = near_hull(near.vertices(), met.place.center);
      const auto found = clear_point(octree, near, met, met.place.center + hull.nearest);
      if (found && found->is_outside) {
        CHECK(squared_distance(octree.frame().point(found->point), cells) > 0);
        ++outside;
      } else if (found) {
        ++clear;
        // A convex piece that no triangle runs through is near if its corners are.
        for (const RationalPoint& x : common_corners(part, met.place, octree.frame())) {
          CHECK(squared_distance(x, cells) <= squared);
        }
        continue;
      }
      ++others;
      MetCell half;
      for (const CellPlace& place : octree.children(met.place)) {
        if (!met.may_meet(near, place, half)) continue;
        if (octree.label(place) == ReachCells::Label::Open) open.push_back(half);
      }
    }
  }
  MESSAGE("clear ", clear, ", outside ", outside, ", others ", others);
  CHECK(clear > 200);
  CHECK(outside > 20);
  CHECK(others > 200);
}

TEST_CASE("reach: what is about as thin as roundings is not made smaller") {
  const World world(support::box_mesh({{0, 0, 0}, {4, 4, 4}}));
  const BoundingBox box[] = {bounding_box(world.surface.points)};
  ReachCells octree(world.surface, &*world.winding, frame_around(box), squared_of(0x1p-10));
  for (int bits = 2; bits < 52; ++bits) {
    CAPTURE(bits);
    const NearPart part(near_solid(std::vector<Point>{
        {0, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}, {0.25, 0.25, std::ldexp(1.0, -bits)}}));
    REQUIRE(part.planes() == 4);
    const std::optional<InnerPart> inner = inner_part(octree, part);
    if (bits < 8) CHECK(inner);
    if (inner) CHECK(inner->share < 0x1p-20);
    if (bits > 40) CHECK_FALSE(inner);
  }
}

// So thin that moving planes inward by roundings would turn them inside out.
TEST_CASE("reach: slivers just beyond T are not within") {
  const World world(support::box_mesh({{-0.48, -0.48, -0.48}, {-0.25, 0.48, 0.48}}));
  const ConvexPart frame = part_of(Box{{-0.48, -0.48, -0.48}, {0.48, 0.48, 0.48}});
  constexpr double kFar = 0x1p-17;  // beyond T = 1/4
  for (const double r : {2.5, 3.0, 4.0, 4.2, 6.0, 9.0, 20.0}) {
    CAPTURE(r);
    const Box box{{-3 * kFar, -kFar, -r * 0x1p-43}, {kFar, kFar, r * 0x1p-43}};
    ReachLimit limit = world.limit(squared_of(0.25), std::span(&frame, 1));
    REQUIRE(limit.frame()(RationalPoint(0, 0, 0)) == Point(0, 0, 0));
    CHECK(limit(part_of(box)).reach != Reach::Within);
    CHECK_FALSE(limit.allows(part_of(box)));
    CHECK_FALSE(limit.allows_near(support::box_corners(box)));
    CHECK(farthest_in(limit, support::box_corners(box)));
  }
}

// The planes of its hull meet beyond its sharp edge, inside of the second box.
TEST_CASE("reach: a wedge that ends in a gap is not within") {
  constexpr double kGap = 0x1p-6, kLimit = kGap / 4, kAt = 17.0 / 64, kMiddle = 1.0 / 64;
  Mesh mesh = support::box_mesh({{-0.48, -0.48, -0.48}, {kAt - kGap - 0x1p-20, 0.48, 0.48}});
  std::vector<Point> points(mesh.points.doubles().begin(), mesh.points.doubles().end());
  for (const Point& p :
       support::box_corners({{kAt - 0.255 * kGap, -0.48, -0.48}, {0.48, 0.48, 0.48}})) {
    points.push_back(p);
  }
  for (auto face : support::box_faces()) {
    for (auto& corner : face) corner += 8;
    mesh.polygons.push_back(face);
  }
  mesh.points = PointSet(points);
  mesh.parts.clear();
  const World world(mesh);
  std::vector<Point> wedge;
  for (const double y : {-0x1p-18, 0x1p-18}) {
    for (const double z : {-0x1p-25, 0x1p-25}) wedge.emplace_back(-0.4, kMiddle + y, kMiddle + z);
    wedge.emplace_back(kAt - 0.26 * kGap, kMiddle + y, kMiddle);
  }
  ReachLimit limit = world.limit(squared_of(kLimit), {});
  REQUIRE(limit.frame()(RationalPoint(0, 0, 0)) == Point(0, 0, 0));
  REQUIRE(limit.frame().exponent == 0);
  CHECK(limit(part_of(wedge)).reach == Reach::Beyond);
  CHECK_FALSE(limit.allows_near(wedge));
  CHECK(farthest_in(limit, wedge));
}

TEST_CASE("reach: however few cells wait, the same ones are visited") {
  const World world(support::mesh_of_cells(slot_cells()));
  const ConvexPart hull = convex_part(world.surface.points);
  ReachCells cells(world.surface, &*world.winding, frame_around(std::span(&hull.box, 1)),
                   squared_of(0.3));
  const NearPart near(hull, cells.frame());
  const auto visited = [&](std::size_t most_waiting) {
    std::set<std::uint32_t> found;
    walk_cells(
        cells, near,
        [&](const MetCell& met) {
          CHECK(found.insert(met.place.cell).second);
          return met.place.half < 0x1p-5 ? Below::Skip : Below::Visit;
        },
        most_waiting);
    return found;
  };
  const std::set<std::uint32_t> all = visited(kMostWaiting);
  CHECK(all.size() > 100);
  for (const std::size_t most : {1u, 2u, 7u}) CHECK(visited(most) == all);
}

TEST_CASE("reach: parts asked about at the same time are answered as one after another") {
  const World world(support::mesh_of_cells(slot_cells()));
  Random random(55);
  const auto coordinate = [&](int size) {
    return static_cast<double>(uniform_below(random, 64 * size + 1)) / 64;
  };
  const ReachLimit frame = world.limit(squared_of(0.3), {});
  std::vector<std::vector<Point>> parts(40);
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const int width = p % 3 == 0 ? 1 : 4;  // in a wall, or across the slot
    for (int k = 0; k < 8; ++k) {
      const Point x(coordinate(width), coordinate(1), coordinate(3));
      parts[p].push_back(frame.frame()(RationalPoint(x.cast<Rational>())));
    }
  }
  const auto answers = [&](std::size_t jobs) {
    ReachLimit limit = world.limit(squared_of(0.3), {});
    std::vector<std::array<double, 4>> found;
    for (const auto& far : limit.farthest_of_each(parts, jobs)) {
      const Point y = far ? far->point : Point::Zero();
      found.push_back({far ? far->distance : 0, y[0], y[1], y[2]});
    }
    return std::pair(found, limit.cells());
  };
  const auto alone = answers(1);
  CHECK(std::ranges::count(alone.first, std::array<double, 4>{}) > 2);
  CHECK(std::ranges::count(alone.first, std::array<double, 4>{}) < 38);
  for (const std::size_t jobs : {2u, 3u, 8u, 8u, 8u}) {
    CAPTURE(jobs);
    CHECK(answers(jobs) == alone);
  }

  // The same parts, asked whether they are within the limit: one by one, and several together.
  std::vector<ConvexPart> exact;
  for (const std::vector<Point>& part : parts) {
    std::vector<RationalPoint> corners;
    for (const Point& y : part) corners.push_back(frame.frame().point(y));
    exact.push_back(convex_part(PointSet(std::move(corners))));
  }
  std::vector<bool> one_by_one;
  for (const ConvexPart& part : exact) {
    one_by_one.push_back(world.limit(squared_of(0.3), {}).allows(part));
  }
  std::vector<ConvexPart> near;
  for (std::size_t p = 0; p < exact.size(); ++p) {
    if (one_by_one[p]) near.push_back(exact[p]);
  }
  CHECK(near.size() > 2);
  for (const std::size_t jobs : {1u, 2u, 3u, 8u}) {
    CAPTURE(jobs);
    ReachLimit limit = world.limit(squared_of(0.3), {});
    CHECK(limit.allows_each(exact, jobs) == one_by_one);
    CHECK_FALSE(limit.allows_all(exact, jobs));
    CHECK(limit.allows_all(near, jobs));
    CHECK(limit.allows_all({}, jobs));
  }
}

TEST_CASE("frame: the points of a set are those that each has alone, of any size and place") {
  Random random(7);
  for (const double unit : {1.0, 0x1p-3, 3e-320, 1e-310, 0x1p-1022, 1e300, 0x1p1020}) {
    for (const double away : {0.0, 1.0, 1e9, 3.7e15}) {
      std::vector<Point> doubles;
      for (int k = 0; k < 50; ++k) {
        Point& x = doubles.emplace_back();
        for (int axis = 0; axis < 3; ++axis) {
          const double of_unit = static_cast<double>(uniform_below(random, 1u << 20)) / 0x1p20;
          x[axis] = unit > 1e299 ? unit * of_unit : (away + of_unit) * unit;
        }
      }
      doubles.push_back(doubles[3]);
      doubles.emplace_back(-0.0, 0.0, -0.0);
      std::vector<RationalPoint> thirds;
      for (const Point& x : doubles) thirds.push_back(to_rational(x) / Rational(3));
      for (const PointSet& points : {PointSet(doubles), PointSet(thirds)}) {
        const BoundingBox box = bounding_box(points);
        for (const NearFrame& frame :
             {frame_around(std::span(&box, 1)), NearFrame{RationalPoint(Rational(1, 3), 0, 1), 2},
              NearFrame{RationalPoint::Zero(), 2}}) {
          const std::vector<Point> framed = frame(points);
          REQUIRE(framed.size() == points.size());
          for (std::size_t i = 0; i < points.size(); ++i) {
            const Point alone = frame(points[PointId(i)]);
            CHECK(framed[i] == alone);
            for (int k = 0; k < 3; ++k) CHECK(std::signbit(framed[i][k]) == std::signbit(alone[k]));
          }
        }
      }
    }
  }
}

TEST_CASE("near_hull: boxes of points change no bit of what is found") {
  Random random(11);
  const auto coordinate = [&](std::uint32_t steps) {
    return static_cast<double>(uniform_below(random, steps)) / steps * 2 - 1;
  };
  for (const std::size_t count : {1u, 31u, 95u, 96u, 97u, 128u, 500u, 3000u}) {
    for (const std::uint32_t steps : {2u, 5u, 1u << 30}) {  // with few, most points are many times
      CAPTURE(count);
      CAPTURE(steps);
      std::vector<Point> points;
      for (std::size_t k = 0; k < count; ++k) {
        points.emplace_back(coordinate(steps), coordinate(steps), coordinate(steps) / 8);
      }
      const HullPoints boxed(points);
      for (int k = 0; k < 40; ++k) {
        const Point y = 2 * Point(coordinate(64), coordinate(64), coordinate(64));
        const Point q(coordinate(3), coordinate(1u << 20), coordinate(64));
        std::size_t first = 0;
        for (std::size_t i = 0; i < count; ++i) {
          if (q.dot(points[i] - y) < q.dot(points[first] - y)) first = i;
        }
        const double least = q.dot(points[first] - y);
        CHECK(boxed.least_along(q, y) == std::pair(first, least));
        for (const double enough : {std::numeric_limits<double>::quiet_NaN(), 0.5}) {
          const NearHull plain = near_hull(points, y, enough), quick = near_hull(boxed, y, enough);
          CHECK(plain.bounds.low == quick.bounds.low);
          CHECK(plain.bounds.high == quick.bounds.high);
          CHECK(plain.nearest == quick.nearest);
          CHECK(plain.towards == quick.towards);
        }
      }
    }
  }
}

TEST_CASE("reach: what it refuses") {
  const World world(support::mesh_of_cells({{0, 0, 0}}));
  // By exactly T: cells alone do not prove it, however small.
  const ConvexPart outside = part_of({{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {0, 0, 2}});
  const ConvexPart* const parts[] = {&outside};
  CHECK(error_of([&] {
          (void)world.limit(squared_of(1), std::span(&outside, 1)).certificate(parts);
        }).code() == ErrorCode::Unrepresentable);
  CHECK(error_of([&] { (void)world.limit(-1, {}); }).code() == ErrorCode::InvalidArgument);
  CHECK(error_of([&] {
          (void)world.limit(1, {})(part_of(Box{{5, 5, 5}, {9, 9, 9}}));
        }).code() == ErrorCode::InvalidArgument);
  const std::atomic<bool> stop = true;
  const ConvexPart part = part_of(Box{{0, 0, 0}, {1, 1, 2}});
  CHECK(error_of([&] {
          (void)world.limit(squared_of(0.1), std::span(&part, 1))(part, Watch(&stop));
        }).code() == ErrorCode::Stopped);
}

TEST_CASE("reach: a part deep inside is allowed, and one that is barely beyond is not") {
  const World solid(support::box_mesh({{0, 0, 0}, {4, 4, 4}}));
  CHECK(solid.limit(squared_of(0.3), {}).allows(part_of(Box{{0, 0, 0}, {4, 4, 4}})));
  CHECK(solid.limit(squared_of(0.3), {}).allows(part_of(Box{{1, 1, 1}, {3, 3, 3}})));
  // It reaches 1: no center of a cell is that far, so that only open cells tell.
  const World slot(support::mesh_of_cells(slot_cells()));
  CHECK_FALSE(slot.limit(squared_of(0.9995), {}).allows(convex_part(slot.surface.points)));
}

TEST_CASE("reach: labels of cells are what they say, in exact numbers") {
  std::set<Cell> cells;  // a block of 27
  for (int k = 0; k < 27; ++k) cells.insert({k % 3, k / 3 % 3, k / 9});
  const World world(support::mesh_of_cells(cells));
  const BoundingBox box = bounding_box(world.surface.points);
  for (const double limit : {0.41, 0.5, 0.57, 0.66, 0.73}) {
    const Rational squared = squared_of(limit);
    ReachCells octree(world.surface, &*world.winding, frame_around(std::span(&box, 1)), squared);
    std::size_t near = 0, inside = 0;
    std::vector<CellPlace> open{octree.root()};
    for (std::size_t k = 0; k < open.size() && k < 1500; ++k) {
      for (const CellPlace& place : octree.children(open[k])) {
        const ReachCells::Label label = octree.label(place);
        // Those by the surface; nothing far away becomes near.
        const bool is_by_surface = octree.distance(place.cell).low <= place.radius();
        if (label == ReachCells::Label::Open && is_by_surface) open.push_back(place);
        for (int c = 0; c < 8; ++c) {
          const RationalPoint corner = octree.frame().point(place.corner(c));
          if (label == ReachCells::Label::Near) {
            const auto found =
                nearest_on_triangle(world.surface, octree.triangle(place.cell), corner);
            CHECK(found.squared <= squared);
          } else if (label == ReachCells::Label::Inside) {
            CHECK(squared_distance(corner, cells) == 0);
          }
        }
        near += label == ReachCells::Label::Near ? 1 : 0;
        inside += label == ReachCells::Label::Inside ? 1 : 0;
      }
    }
    CHECK(near > 50);
    CHECK(inside > 0);
  }
}

TEST_CASE("reach: what a part and a cell have in common has the corners of both") {
  const NearFrame frame{RationalPoint::Zero(), 0};
  const CellPlace cell{0, Point(0.5, 0.5, 0.5), 0.5};
  const auto has = [&](const ConvexPart& part, const Point& corner) {
    const auto found = common_corners(part, cell, frame);
    return std::find(found.begin(), found.end(), to_rational(corner)) != found.end();
  };
  const std::vector<Point> corners{
      {0.25, 0.25, 0.25}, {0.75, 0.25, 0.25}, {0.25, 0.75, 0.25}, {0.25, 0.25, 0.75}};
  for (const Point& p : corners) CHECK(has(part_of(corners), p));
  const ConvexPart large = part_of(Box{{-1, -1, -1}, {2, 2, 2}});
  for (int c = 0; c < 8; ++c) CHECK(has(large, cell.corner(c)));
  // A square across the cell: where its plane meets edges of the cell.
  const ConvexPart square = part_of({{-1, -1, 0.25}, {2, -1, 0.25}, {2, 2, 0.25}, {-1, 2, 0.25}});
  for (int c = 0; c < 4; ++c) CHECK(has(square, Point(c & 1, c >> 1, 0.25)));
  CHECK(common_corners(part_of(Box{{3, 3, 3}, {4, 4, 4}}), cell, frame).empty());
}
