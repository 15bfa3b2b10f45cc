// SPDX-License-Identifier: MIT
// Convex parts of every dimension, and common interiors. Expected values: closed forms; the
// definition of a hull and of an intersection by enumeration.
#include <doctest/doctest.h>

#include "convexact/error.hpp"
#include "expect_error.hpp"
#include "overlay_scenes.hpp"
using namespace convexact;
using namespace support;

namespace {

std::vector<RationalPoint> sorted(std::vector<RationalPoint> points) {
  std::sort(points.begin(), points.end(), comes_before);
  return points;
}

}  // namespace

TEST_CASE("convex_part: a solid has the vertices and facets of its hull") {
  std::vector<RationalPoint> points = box_corners(rational_point(0, 0, 0), rational_point(1, 2, 3));
  points.push_back(rational_point(0.5, 1, 1));
  points.push_back(rational_point(0.5, 0, 0));
  const ConvexPart part = part_of(points);
  CHECK(part.dimension == 3);
  CHECK(part.vertices.size() == 8);
  CHECK(part.halfspaces.size() == 6);
  REQUIRE(part.solid);
  CHECK(volume(*part.solid) == 6);
  CHECK(part.box.high == rational_point(1, 2, 3));
  CHECK(holds(part, rational_point(1, 2, 3)));
  CHECK(holds(part, rational_point(0.5, 0, 1)));
  CHECK_FALSE(holds(part, rational_point(0.5, -0x1p-1074, 1)));
}

TEST_CASE("lies_in: every corner counts, and so does the boundary") {
  const auto box = [](const RationalPoint& low, const RationalPoint& high) {
    return part_of(box_corners(low, high));
  };
  const ConvexPart cube = box(rational_point(0, 0, 0), rational_point(1, 1, 1));
  CHECK(lies_in(cube, cube));
  CHECK(lies_in(box(rational_point(0.5, 0, 0.5), rational_point(1, 1, 0.75)), cube));
  CHECK_FALSE(lies_in(box(rational_point(0.5, -0x1p-1074, 0.5), rational_point(1, 1, 0.75)), cube));
  // In the box of the other part, but for a corner not in the part itself.
  const ConvexPart corner = part_of({rational_point(0, 0, 0), rational_point(1, 0, 0),
                                     rational_point(0, 1, 0), rational_point(0, 0, 1)});
  CHECK(lies_in(corner, cube));
  CHECK_FALSE(lies_in(box(rational_point(0, 0, 0), rational_point(0.25, 0.25, 0.75)), corner));
  const ConvexPart lid = part_of({rational_point(0, 0, 1), rational_point(1, 0, 1),
                                  rational_point(1, 1, 1), rational_point(0, 1, 1)});
  CHECK(lies_in(lid, cube));
  CHECK_FALSE(lies_in(cube, lid));
  CHECK(lies_in(part_of({rational_point(0.5, 0.5, 1)}), lid));
}

TEST_CASE("convex_part: flat parts are the intersection of their halfspaces") {
  // A tilted square with points inside and on its sides; a segment; a point. Each with repeats.
  const RationalPoint o = rational_point(1, 1, 1), u = rational_point(2, 0, 1),
                      v = rational_point(0, 2, 3);
  const auto at = [&](int i, int j, int unit) {
    return RationalPoint(o + Rational(i, unit) * u + Rational(j, unit) * v);
  };
  std::vector<RationalPoint> square;
  for (int i = 0; i <= 2; ++i) {
    for (int j = 0; j <= 2; ++j) square.insert(square.end(), 2, at(i, j, 2));
  }
  const ConvexPart part = part_of(square);
  CHECK(part.dimension == 2);
  CHECK_FALSE(part.solid);
  CHECK(sorted(part.vertices) == sorted({at(0, 0, 1), at(1, 0, 1), at(0, 1, 1), at(1, 1, 1)}));
  for (int i = -1; i <= 5; ++i) {
    for (int j = -1; j <= 5; ++j) {
      const bool is_in = 0 <= i && i <= 4 && 0 <= j && j <= 4;
      CHECK(holds(part, at(i, j, 4)) == is_in);
      CHECK_FALSE(holds(part, at(i, j, 4) + rational_point(0, 0, 0x1p-60)));
    }
  }
  const ConvexPart segment = part_of({at(1, 1, 4), at(0, 0, 4), at(3, 3, 4), at(2, 2, 4)});
  CHECK(segment.dimension == 1);
  CHECK(sorted(segment.vertices) == sorted({at(0, 0, 4), at(3, 3, 4)}));
  for (int i = -1; i <= 4; ++i) {
    CHECK(holds(segment, at(i, i, 4)) == (0 <= i && i <= 3));
    CHECK_FALSE(holds(segment, at(i, i + 1, 4)));
  }
  const ConvexPart point = part_of({o, o, o});
  CHECK(point.dimension == 0);
  CHECK(point.vertices == std::vector{o});
  CHECK(holds(point, o));
  CHECK_FALSE(holds(point, o + rational_point(0x1p-1074, 0, 0)));
}

TEST_CASE("convex_part: the planes of random flat polygons hold their points, and no others") {
  Random random(5);
  for (int round = 0; round < 40; ++round) {
    const IntegerMap map = random_map(random);
    std::vector<RationalPoint> points;
    for (int i = 0; i < 7; ++i) {
      points.push_back(map(rational_point(static_cast<double>(uniform_below(random, 4)),
                                          static_cast<double>(uniform_below(random, 4)), 0)));
    }
    const ConvexPart part = part_of(points);
    CHECK(part.dimension == affine_dimension(points));
    for (const RationalPoint& p : points) CHECK(holds(part, p));
    // Every vertex is one of the points, and is lost without it.
    for (const RationalPoint& v : part.vertices) {
      std::vector<RationalPoint> others;
      for (const RationalPoint& p : points) {
        if (p != v) others.push_back(p);
      }
      CHECK(others.size() < points.size());
      if (!others.empty()) CHECK_FALSE(holds(part_of(others), v));
    }
    CHECK(sorted(vertices_by_enumeration(part.halfspaces)) == sorted(part.vertices));
  }
}

TEST_CASE("convex_part: no point is an error") {
  CHECK(error_of([] { return convex_part(PointSet()); }).code() == ErrorCode::InvalidArgument);
}

TEST_CASE("common_interior: boxes that overlap, touch, or lie apart") {
  const ConvexPart box = box_part(0, 0, 0, 2, 2, 2);
  const auto common = common_interior(box, box_part(1, 1, 1, 3, 3, 3));
  REQUIRE(common);
  for (int k = 0; k < 3; ++k) {
    CHECK((*common)[k] > 1);
    CHECK((*common)[k] < 2);
  }
  CHECK_FALSE(common_interior(box, box_part(2, 0, 0, 3, 2, 2)));  // a facet
  CHECK_FALSE(common_interior(box, box_part(2, 2, 0, 3, 3, 2)));  // an edge
  CHECK_FALSE(common_interior(box, box_part(2, 2, 2, 3, 3, 3)));  // a vertex
  CHECK_FALSE(common_interior(box, box_part(5, 0, 0, 6, 2, 2)));  // nothing
  CHECK_FALSE(common_interior(box, box_part(0, 0, 1, 2, 2, 1)));  // a flat one
  CHECK(common_interior(box, box));
  CHECK(common_interior(box, box_part(2 - 0x1p-52, 0, 0, 3, 2, 2)));
}

TEST_CASE("common_interior: it is there iff the common part of random solids has a volume") {
  Random random(11);
  int found = 0;
  for (int round = 0; round < 60; ++round) {
    const ConvexPart a = grid_part(random, 5, 2), b = grid_part(random, 5, 2);
    const bool has_volume = common_volume({&a, &b}) > 0;
    const auto x = common_interior(a, b);
    CHECK(x.has_value() == has_volume);
    CHECK(common_interior(b, a).has_value() == has_volume);
    found += has_volume;
    if (!x) continue;
    for (const ConvexPart* part : {&a, &b}) {
      for (const Halfspace& h : part->halfspaces) CHECK(h(*x) < 0);
    }
  }
  CHECK(found > 5);
  CHECK(found < 60);
}
