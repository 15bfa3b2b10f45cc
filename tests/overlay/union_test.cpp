// SPDX-License-Identifier: MIT
// Volumes of unions. Expected values: closed forms; unit cells counted; inclusion and exclusion
// with common parts by enumeration.
#include <doctest/doctest.h>

#include "overlay_scenes.hpp"
#include "sweep.hpp"
using namespace convexact;
using namespace support;

namespace {

constexpr long kUnionBits = 128;

Rational checked_union(const std::vector<ConvexPart>& parts) {
  const Measured exact = union_volume(parts, kUnionBits, true);
  const Measured enclosed = union_volume(parts, kUnionBits, false);
  CHECK_FALSE(enclosed.exact);
  const Rational volume = *exact.exact;
  CHECK(exact.bounds.contains(volume));
  CHECK(enclosed.bounds.contains(volume));
  CHECK(scale_by_power_of_two(enclosed.bounds.width(), kUnionBits - 3) <= volume);
  return volume;
}

}  // namespace

TEST_CASE("union_volume: boxes that overlap, touch, repeat, or hold each other") {
  CHECK(checked_union({}) == 0);
  CHECK(checked_union({box_part(0, 0, 0, 1, 1, 1)}) == 1);
  CHECK(checked_union({box_part(0, 0, 0, 2, 2, 2), box_part(1, 1, 1, 3, 3, 3)}) == 15);
  CHECK(checked_union({box_part(0, 0, 0, 1, 1, 1), box_part(1, 0, 0, 2, 1, 1)}) == 2);
  CHECK(checked_union({box_part(0, 0, 0, 1, 1, 1), box_part(1, 1, 0, 2, 2, 1)}) == 2);
  CHECK(checked_union({box_part(0, 0, 0, 1, 1, 1), box_part(1, 1, 1, 2, 2, 2)}) == 2);
  const ConvexPart cube = box_part(0, 0, 0, 3, 3, 3);
  CHECK(checked_union({cube, cube, cube}) == 27);
  CHECK(checked_union({box_part(1, 1, 1, 2, 2, 2), cube}) == 27);
  CHECK(checked_union({cube, box_part(0, 0, 0, 1, 1, 3)}) == 27);
  CHECK(checked_union({box_part(-1, 1, 1, 4, 2, 2), cube}) == 29);  // through the cube
  // Flat parts have no volume.
  CHECK(checked_union({cube, box_part(0, 0, 0, 9, 9, 0), box_part(5, 5, 5, 5, 5, 5)}) == 27);
  CHECK(checked_union({box_part(0, 0, 0, 9, 9, 0)}) == 0);
}

TEST_CASE("union_volume: sums of boxes, mapped and scaled, cell by cell") {
  Random random(3);
  for (int round = 0; round < 40; ++round) {
    CAPTURE(round);
    std::vector<IntegerBox> boxes;
    const std::size_t count = 1 + uniform_below(random, 8);
    for (std::size_t i = 0; i < count; ++i) {
      IntegerBox& box = boxes.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) {
        box.low[k] = static_cast<int>(uniform_below(random, 4));
        box.high[k] = box.low[k] + 1 + static_cast<int>(uniform_below(random, 3));
      }
    }
    int cells = 0;
    for (int x = 0; x < 6; ++x) {
      for (int y = 0; y < 6; ++y) {
        for (int z = 0; z < 6; ++z) cells += any_holds(boxes, {x, y, z});
      }
    }
    const IntegerMap map = random_map(random);
    const long power = round % 4 == 0 ? 300 : round % 4 == 1 ? -300 : 0;
    std::vector<ConvexPart> parts;
    for (const IntegerBox& box : boxes) parts.push_back(scaled(map(box.part()), power));
    const Rational expected =
        scale_by_power_of_two(Rational(cells * std::abs(map.determinant())), 3 * power);
    CHECK(checked_union(parts) == expected);
    std::reverse(parts.begin(), parts.end());
    CHECK(checked_union(parts) == expected);
  }
}

TEST_CASE("union_volume: random solids, by inclusion and exclusion") {
  Random random(8);
  for (int round = 0; round < 40; ++round) {
    CAPTURE(round);
    std::vector<ConvexPart> parts;
    const std::size_t count = 2 + uniform_below(random, 2);
    for (std::size_t i = 0; i < count; ++i) parts.push_back(grid_part(random, 5, 2));
    const Rational expected = measure_of_union(parts, common_volume);
    CHECK(checked_union(parts) == expected);
    std::rotate(parts.begin(), parts.begin() + 1, parts.end());
    CHECK(checked_union(parts) == expected);
  }
}

TEST_CASE("union_volume: solids off the grid by last bits, by inclusion and exclusion" * sweep) {
  Random random(9);
  for (int round = 0; round < 40; ++round) {
    CAPTURE(round);
    std::vector<ConvexPart> parts;
    for (int i = 0; i < 2; ++i) parts.push_back(nearly_grid_part(random, 5, 1));
    if (round % 2 == 0) {  // the same solid but for last bits
      std::vector<RationalPoint> points = parts[0].vertices;
      for (RationalPoint& p : points) {
        p[static_cast<int>(uniform_below(random, 3))] += to_rational(0x1p-51);
      }
      parts[1] = part_of(points);
      if (parts[1].dimension < 3) continue;
    }
    CHECK(checked_union(parts) == measure_of_union(parts, common_volume));
    CHECK(common_interior(parts[0], parts[1]).has_value() ==
          (common_volume({&parts[0], &parts[1]}) > 0));
  }
}

TEST_CASE("union_volume: an interrupted sum stops") {
  const std::atomic<bool> stop = true;
  const std::vector<ConvexPart> parts{box_part(0, 0, 0, 1, 1, 1)};
  CHECK_THROWS_AS((void)union_volume(parts, kUnionBits, false, Watch(&stop)), Error);
}
