// SPDX-License-Identifier: MIT
// Solids outside of unions. Expected values: closed forms; unit cells counted.
#include <doctest/doctest.h>

#include "defined_solid_volume.hpp"
#include "overlay_scenes.hpp"
#include "sweep.hpp"
using namespace convexact;
using namespace support;

namespace {

constexpr long kBits = 128;

// Checks the volume, and that the verdict and its witness agree with it.
Rational uncovered_of(const Soup& soup, const std::vector<ConvexPart>& parts) {
  const Surface surface = surface_of(soup);
  const Winding winding(surface);
  const SurfaceCoverage coverage = find_uncovered(surface, parts);
  const auto witness = find_uncovered_solid(surface, winding, parts, coverage);
  // Without the pieces of the surface, the boundary alone must say the same.
  const auto again = find_uncovered_solid(surface, winding, parts, {});
  const Measured exact = uncovered_volume(surface, winding, parts, kBits, true);
  const Measured enclosed = uncovered_volume(surface, winding, parts, kBits, false);
  const Rational volume = *exact.exact;
  // Without parts all of the solid is left.
  CHECK(solid_volume(surface, kBits, true).exact == defined_solid_volume(surface));
  CHECK(exact.bounds.contains(volume));
  CHECK(enclosed.bounds.contains(volume));
  CHECK(scale_by_power_of_two(enclosed.bounds.width(), kBits - 3) <= volume);
  for (const auto* found : {&witness, &again}) {
    CHECK(found->has_value() == (volume > 0));
    if (!*found) continue;
    const RationalPoint& x = (*found)->point;
    for (const ConvexPart& part : parts) CHECK_FALSE(holds(part, x));
    CHECK((*found)->winding != 0);
    CHECK(winding(x) == (*found)->winding);
  }
  return volume;
}

std::vector<ConvexPart> unit_cells(const std::vector<Cell>& cells) {
  std::vector<ConvexPart> parts;
  for (const Cell& c : cells)
    parts.push_back(box_part(c[0], c[1], c[2], c[0] + 1, c[1] + 1, c[2] + 1));
  return parts;
}

Soup soup_of(const std::vector<Cell>& cells) {
  return boundary_of(std::set<Cell>(cells.begin(), cells.end()));
}

const std::vector<Cell> kCross{{0, 0, 0},  {1, 0, 0}, {-1, 0, 0}, {0, 1, 0},
                               {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};

}  // namespace

TEST_CASE("solid: six arms of the cross of seven cells leave the middle cell") {
  std::vector<Cell> arms(kCross.begin() + 1, kCross.end());
  const Surface surface = surface_of(soup_of(kCross));
  const std::vector<ConvexPart> parts = unit_cells(arms);
  const SurfaceCoverage coverage = find_uncovered(surface, parts);
  CHECK(coverage.uncovered.empty());
  CHECK(coverage.in_one_part == surface.triangles.size());
  CHECK(uncovered_of(soup_of(kCross), parts) == 1);
  const Winding winding(surface);
  const auto witness = find_uncovered_solid(surface, winding, parts, coverage);
  REQUIRE(witness);
  for (int k = 0; k < 3; ++k) {
    CHECK(witness->point[k] > 0);
    CHECK(witness->point[k] < 1);
  }
  CHECK(uncovered_of(soup_of(kCross), unit_cells(kCross)) == 0);
  CHECK(uncovered_of(soup_of(kCross), {}) == 7);
  // Three bars.
  CHECK(uncovered_of(soup_of(kCross), {box_part(-1, 0, 0, 2, 1, 1), box_part(0, -1, 0, 1, 2, 1),
                                       box_part(0, 0, -1, 1, 1, 2)}) == 0);
}

TEST_CASE("solid: L, U, plus, ring, staircase and cavity, by their bars") {
  const auto none = [](const std::vector<Cell>& cells, const std::vector<ConvexPart>& parts) {
    return uncovered_of(soup_of(cells), parts);
  };
  const std::vector<Cell> ell{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  CHECK(none(ell, {box_part(0, 0, 0, 2, 1, 1), box_part(0, 1, 0, 1, 2, 1)}) == 0);
  CHECK(none(ell, {box_part(0, 0, 0, 2, 1, 1)}) == 1);
  CHECK(none(ell, {box_part(0, 0, 0, 2, 1, 1), box_part(0, 1.5, 0, 1, 2, 1)}) == Rational(1, 2));
  const std::vector<Cell> u{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 1, 0}};
  CHECK(none(u, {box_part(0, 0, 0, 1, 2, 1), box_part(2, 0, 0, 3, 2, 1)}) == 1);
  const std::vector<Cell> ring{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0},
                               {2, 1, 0}, {0, 2, 0}, {1, 2, 0}, {2, 2, 0}};
  CHECK(none(ring, {box_part(0, 0, 0, 3, 1, 1), box_part(0, 2, 0, 3, 3, 1),
                    box_part(0, 0, 0, 1, 3, 1), box_part(2, 0, 0, 3, 3, 1)}) == 0);
  CHECK(none(ring, {box_part(0, 0, 0, 3, 3, 0.5)}) == 4);
  std::vector<Cell> stairs;
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j <= i; ++j) stairs.push_back({i, j, 0});
  }
  CHECK(none(stairs, {}) == 15);
  CHECK(none(stairs, {part_of({rational_point(0, 0, 0), rational_point(5, 0, 0),
                               rational_point(5, 5, 0), rational_point(0, 0, 1),
                               rational_point(5, 0, 1), rational_point(5, 5, 1)})}) ==
        Rational(5, 2));
  // A box with a cavity, by six walls, with one wall missing, and with a part in the cavity.
  Soup hollow;
  add_box(0, 0, 0, 3, 3, 3, hollow);
  add_box(1, 1, 1, 2, 2, 2, hollow, true);
  std::vector<ConvexPart> walls{box_part(0, 0, 0, 1, 3, 3), box_part(2, 0, 0, 3, 3, 3),
                                box_part(1, 0, 0, 2, 1, 3), box_part(1, 2, 0, 2, 3, 3),
                                box_part(1, 1, 0, 2, 2, 1), box_part(1, 1, 2, 2, 2, 3)};
  CHECK(uncovered_of(hollow, walls) == 0);
  walls.pop_back();
  CHECK(uncovered_of(hollow, walls) == 1);
  CHECK(uncovered_of(hollow, {box_part(1, 1, 1, 2, 2, 2)}) == 26);
  CHECK(uncovered_of(hollow, {box_part(0.5, 0.5, 0.5, 2.5, 2.5, 2.5)}) == 19);
}

TEST_CASE("solid: boxes that share an edge or a vertex, and cubes that cross") {
  Soup edge, vertex, crossing;
  add_box(0, 0, 0, 1, 1, 1, edge);
  add_box(1, 1, 0, 2, 2, 1, edge);
  CHECK(uncovered_of(edge, {box_part(0, 0, 0, 1, 1, 1)}) == 1);
  CHECK(uncovered_of(edge, {box_part(0, 0, 0, 2, 2, 1)}) == 0);
  add_box(0, 0, 0, 1, 1, 1, vertex);
  add_box(1, 1, 1, 2, 2, 2, vertex);
  CHECK(uncovered_of(vertex, {box_part(1, 1, 1, 2, 2, 2)}) == 1);
  add_box(0, 0, 0, 2, 2, 2, crossing);
  add_box(1, 1, 1, 3, 3, 3, crossing);
  CHECK(uncovered_of(crossing, {}) == 15);
  CHECK(uncovered_of(crossing, {box_part(0, 0, 0, 2, 2, 2)}) == 7);
  CHECK(uncovered_of(crossing, {box_part(1, 1, 1, 2, 2, 2)}) == 14);
  CHECK(uncovered_of(crossing, {box_part(0, 0, 0, 2, 2, 2), box_part(1, 1, 1, 3, 3, 3)}) == 0);
  // One turned inside out: the common part has the winding number 0.
  Soup opposed;
  add_box(0, 0, 0, 2, 2, 2, opposed);
  add_box(1, 1, 1, 3, 3, 3, opposed, true);
  CHECK(uncovered_of(opposed, {}) == 14);
  CHECK(uncovered_of(opposed, {box_part(1, 1, 1, 2, 2, 2)}) == 14);
  CHECK(uncovered_of(opposed, {box_part(0, 0, 0, 2, 2, 1), box_part(0, 0, 1, 2, 1, 2),
                               box_part(0, 1, 1, 1, 2, 2)}) == 7);
  // Through each other: a bar through a cube.
  Soup through;
  add_box(0, 0, 0, 3, 3, 3, through);
  add_box(-1, 1, 1, 4, 2, 2, through);
  CHECK(uncovered_of(through, {}) == 29);
  CHECK(uncovered_of(through, {box_part(0, 0, 0, 3, 3, 3)}) == 2);
}

TEST_CASE("solid: repeated and cancelling sheets count once, or not at all") {
  Soup twice;
  add_box(0, 0, 0, 2, 2, 2, twice);
  add_box(0, 0, 0, 2, 2, 2, twice);
  CHECK(uncovered_of(twice, {}) == 8);
  CHECK(uncovered_of(twice, {box_part(0, 0, 0, 2, 2, 1)}) == 4);
  Soup cancelled;
  add_box(0, 0, 0, 2, 2, 2, cancelled);
  add_box(0, 0, 0, 2, 2, 2, cancelled, true);
  CHECK(uncovered_of(cancelled, {}) == 0);
  // A doubled sheet that pierces a cube, and one outside of it.
  Soup pierced;
  add_box(0, 0, 0, 2, 2, 2, pierced);
  const SoupTriangle sheet{rational_point(-3, 1, 1), rational_point(5, 1, 1),
                           rational_point(1, 1, 9)};
  pierced.push_back(sheet);
  pierced.push_back({sheet[0], sheet[2], sheet[1]});
  CHECK(uncovered_of(pierced, {}) == 8);
  CHECK(uncovered_of(pierced, {box_part(0, 0, 0, 2, 2, 2)}) == 0);
  CHECK(uncovered_of(pierced, {box_part(0, 0, 0, 2, 2, 2), box_part(-3, 1, 0, 5, 2, 9)}) == 0);
  CHECK(uncovered_of(pierced, {box_part(0, 0, 0, 2, 1, 2)}) == 4);
  // Cubes with a common face that cancels, and with one that does not.
  Soup joined;
  add_box(0, 0, 0, 1, 1, 1, joined);
  add_box(1, 0, 0, 2, 1, 1, joined);
  CHECK(uncovered_of(joined, {}) == 2);
  CHECK(uncovered_of(joined, {box_part(0.5, 0, 0, 1.5, 1, 1)}) == 1);
  Soup against;
  add_box(0, 0, 0, 1, 1, 1, against);
  add_box(1, 0, 0, 2, 1, 1, against, true);
  CHECK(uncovered_of(against, {}) == 2);
  CHECK(uncovered_of(against, {box_part(0, 0, 0, 1, 1, 1)}) == 1);
}

TEST_CASE("solid: flat parts cover no volume, even where they hold the surface") {
  Soup cube;
  add_box(0, 0, 0, 1, 1, 1, cube);
  std::vector<ConvexPart> skin;
  for (int k = 0; k < 3; ++k) {
    for (const int side : {0, 1}) {
      RationalPoint low = rational_point(0, 0, 0), high = rational_point(1, 1, 1);
      low[k] = high[k] = side;
      skin.push_back(box_part(low, high));
    }
  }
  CHECK(find_uncovered(surface_of(cube), skin).uncovered.empty());
  CHECK(uncovered_of(cube, skin) == 1);
  skin.push_back(box_part(0, 0, 0.5, 1, 1, 0.5));
  skin.push_back(box_part(0, 0.5, 0, 1, 0.5, 1));
  skin.push_back(box_part(0.5, 0, 0, 0.5, 1, 1));
  CHECK(uncovered_of(cube, skin) == 1);
  skin.push_back(box_part(0, 0, 0, 1, 1, 0.5));
  CHECK(uncovered_of(cube, skin) == Rational(1, 2));
}

TEST_CASE("solid: a part may touch an uncovered triangle in a segment through its middle") {
  // A prism over a triangle, and a tent whose ridge leads from a corner of that triangle to the
  // middle of the opposite side. Behind the middle of the triangle there is the tent only. At depth
  // x it holds an area of 6 x - 3/2 x^2 of the prism, which has a volume of 6.
  const std::vector<std::array<int, 2>> base{{-2, 0}, {2, 0}, {0, 3}};
  std::vector<RationalPoint> corners;
  for (const auto& [y, z] : base) {
    for (const int x : {0, 1}) corners.push_back(rational_point(x, y, z));
  }
  Soup prism;
  add_solid(*part_of(corners).solid, prism);
  const ConvexPart tent =
      part_of({rational_point(0, 0, 0), rational_point(0, 0, 3), rational_point(1, -1, 0),
               rational_point(1, 1, 0), rational_point(1, -1, 3), rational_point(1, 1, 3)});
  CHECK(uncovered_of(prism, {tent}) == Rational(7, 2));
}

TEST_CASE("solid: a part may touch another one's facet in a segment through its middle") {
  // A box with walls of 1 around a void of volume 8, and a tent in the void whose ridge leads
  // across the inner facet of the first wall, with a volume of 4.
  Soup box;
  add_box(0, 0, 0, 4, 4, 4, box);
  const ConvexPart tent =
      part_of({rational_point(1, 2, 1), rational_point(1, 2, 3), rational_point(3, 1, 1),
               rational_point(3, 3, 1), rational_point(3, 1, 3), rational_point(3, 3, 3)});
  CHECK(uncovered_of(box, {box_part(0, 0, 0, 1, 4, 4), box_part(3, 0, 0, 4, 4, 4),
                           box_part(0, 0, 0, 4, 1, 4), box_part(0, 3, 0, 4, 4, 4),
                           box_part(0, 0, 0, 4, 4, 1), box_part(0, 0, 3, 4, 4, 4), tent}) == 4);
}

TEST_CASE("solid: an ulp that matters") {
  Soup cube;
  add_box(0, 0, 0, 1, 1, 1, cube);
  const double less = 1 - 0x1p-53;
  CHECK(uncovered_of(cube, {box_part(0, 0, 0, 1, 1, less)}) == to_rational(0x1p-53));
  CHECK(uncovered_of(cube, {box_part(0, 0, 0, less, less, less), box_part(0, 0, 0.5, 1, 1, 1),
                            box_part(0, 0, 0, 1, 1, 0.5)}) == 0);
  // A gap within: the surface is covered but for a slit.
  CHECK(uncovered_of(cube, {box_part(0, 0, 0, 1, 1, 0.5),
                            box_part(0, 0, 0.5 + 0x1p-53, 1, 1, 1)}) == to_rational(0x1p-53));
}

TEST_CASE("solid: cells and boxes, mapped and scaled, cell by cell" * sweep) {
  Random random(77);
  int covered = 0;
  for (int round = 0; round < 30; ++round) {
    CAPTURE(round);
    const auto below = [&](std::uint64_t n) { return static_cast<int>(uniform_below(random, n)); };
    std::set<Cell> cells;
    const std::size_t count = 1 + uniform_below(random, 12);
    while (cells.size() < count) cells.insert({below(3), below(3), below(3)});
    std::vector<IntegerBox> boxes;
    const int most = round % 2 == 0 ? 6 : 14;
    for (int i = 0; i < most; ++i) {
      IntegerBox& box = boxes.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) {
        box.low[k] = below(3);
        box.high[k] = box.low[k] + 1 + below(2);
      }
    }
    int uncovered = 0;
    for (const Cell& cell : cells) uncovered += !any_holds(boxes, cell);
    covered += uncovered == 0;
    const IntegerMap map = random_map(random);
    const long power = round % 8 == 0 ? 300 : round % 8 == 1 ? -300 : 0;
    std::vector<ConvexPart> parts;
    for (const IntegerBox& box : boxes) parts.push_back(scaled(map(box.part()), power));
    const Rational expected =
        scale_by_power_of_two(Rational(uncovered * std::abs(map.determinant())), 3 * power);
    const Soup soup = scaled(map(boundary_of(cells)), power);
    CHECK(uncovered_of(soup, parts) == expected);
    std::reverse(parts.begin(), parts.end());
    CHECK(uncovered_of(soup, parts) == expected);
  }
  CHECK(covered > 1);
}

TEST_CASE("solid: boxes that cross each other, turned either way, cell by cell") {
  Random random(78);
  for (int round = 0; round < 24; ++round) {
    CAPTURE(round);
    const auto below = [&](std::uint64_t n) { return static_cast<int>(uniform_below(random, n)); };
    const auto random_box = [&] {
      IntegerBox box;
      for (std::size_t k = 0; k < 3; ++k) {
        box.low[k] = below(3);
        box.high[k] = box.low[k] + 1 + below(3);
      }
      return box;
    };
    std::vector<IntegerBox> shells, boxes;
    std::vector<int> turns;
    Soup soup;
    for (int i = 0; i < 3; ++i) {
      shells.push_back(random_box());
      turns.push_back(below(3) == 0 ? -1 : 1);
      add_solid(*shells.back().part().solid, soup, turns.back() < 0);
    }
    for (int i = below(4); i > 0; --i) boxes.push_back(random_box());
    int uncovered = 0;
    for (int x = 0; x < 6; ++x) {
      for (int y = 0; y < 6; ++y) {
        for (int z = 0; z < 6; ++z) {
          int number = 0;
          for (int i = 0; i < 3; ++i) number += shells[i].holds({x, y, z}) ? turns[i] : 0;
          uncovered += number != 0 && !any_holds(boxes, {x, y, z});
        }
      }
    }
    const IntegerMap map = random_map(random);
    std::vector<ConvexPart> parts;
    for (const IntegerBox& box : boxes) parts.push_back(map(box.part()));
    CHECK(uncovered_of(map(soup), parts) == uncovered * std::abs(map.determinant()));
  }
}

TEST_CASE("solid: random solids that cross, by inclusion and exclusion" * sweep) {
  Random random(79);
  for (int round = 0; round < 25; ++round) {
    CAPTURE(round);
    std::vector<ConvexPart> shells{grid_part(random, 5, 2), grid_part(random, 5, 2)};
    const std::vector<ConvexPart> parts{grid_part(random, 5, 2)};
    Soup soup;
    for (const ConvexPart& shell : shells) add_solid(*shell.solid, soup);
    const Rational inside = measure_of_union(parts, common_volume);
    shells.push_back(parts.front());
    CHECK(uncovered_of(soup, parts) == measure_of_union(shells, common_volume) - inside);
  }
}
