// SPDX-License-Identifier: MIT
// Planes between two parts. Expected values: closed forms; for random pairs the definition, over
// the normals of facets and the directions across two edges, one of which is the best.
#include <doctest/doctest.h>

#include <random>

#include "overlay_scenes.hpp"
using namespace convexact;
using namespace support;

namespace {

ConvexPart box(const RationalPoint& low, const RationalPoint& high) {
  return part_of(box_corners(low, high));
}

// A bar of length 8 along an axis, whose section is a square on its tip, 2 wide; at a height.
ConvexPart bar(int axis, double height) {
  std::vector<RationalPoint> points;
  for (const double end : {-4.0, 4.0}) {
    for (const auto& [side, up] : {std::pair(-1, 0), {1, 0}, {0, -1}, {0, 1}}) {
      points.push_back(axis == 0 ? rational_point(end, side, height + up)
                                 : rational_point(side, end, height + up));
    }
  }
  return part_of(points);
}

}  // namespace

TEST_CASE("plane_between: boxes") {
  const ConvexPart a = box(rational_point(0, 0, 0), rational_point(1, 1, 1));
  const auto push = [&](const RationalPoint& low, const RationalPoint& high) {
    return plane_between(a, box(low, high), 0).squared;
  };
  CHECK(push(rational_point(1, 0, 0), rational_point(2, 1, 1)) == 0);
  CHECK(push(rational_point(5, 5, 5), rational_point(6, 6, 6)) == 0);
  // A quarter in common along x: an eighth on each side of the plane.
  CHECK(push(rational_point(0.75, 0, 0), rational_point(2, 1, 1)) == Rational(1, 64));
  // One in the other: out of it by the shortest way.
  CHECK(push(rational_point(0.25, 0.25, 0.25), rational_point(0.75, 0.75, 0.5)) == Rational(1, 16));
  const PlaneBetween plane =
      plane_between(a, box(rational_point(0, 0.75, 0), rational_point(1, 2, 1)), 0);
  CHECK(plane.direction[1] > 0);
  CHECK(plane.direction[0] == 0);
  CHECK(plane_between(a, a, IntegerVector3(0, 0, 1)).squared == Rational(1, 4));
}

TEST_CASE("plane_between: bars that cross at edges, where no facet has the direction") {
  for (const double height : {1.5, 1.75, 2.0}) {
    const PlaneBetween plane = plane_between(bar(0, 0), bar(1, height), 0);
    const Rational common = 2 - to_rational(height);
    CHECK(plane.squared == common * common / 4);
    if (common == 0) continue;
    CHECK(plane.direction[0] == 0);
    CHECK(plane.direction[1] == 0);
    CHECK(plane.direction[2] > 0);
  }
}

TEST_CASE("plane_between: least of all directions, or near enough") {
  std::mt19937_64 random(12);
  const auto some_part = [&] {
    std::vector<RationalPoint> points;
    for (int k = 0; k < 7; ++k) {
      points.push_back(
          rational_point(double(random() % 9), double(random() % 9), double(random() % 9)));
    }
    return part_of(points);
  };
  int overlapping = 0;
  for (int round = 0; round < 60; ++round) {
    CAPTURE(round);
    const ConvexPart a = some_part(), b = some_part();
    if (!a.solid || !b.solid) continue;
    // Any difference of two vertices may be along an edge.
    std::vector<IntegerVector3> directions;
    for (const Halfspace& h : a.halfspaces) directions.push_back(h.normal());
    for (const Halfspace& h : b.halfspaces) directions.emplace_back(-h.normal());
    const auto integers = [](const RationalVector3& v) {
      return IntegerVector3(numerator(v[0]), numerator(v[1]), numerator(v[2]));
    };
    for (std::size_t i = 0; i < a.vertices.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        for (std::size_t k = 0; k < b.vertices.size(); ++k) {
          for (std::size_t l = 0; l < k; ++l) {
            const IntegerVector3 across = integers(a.vertices[i] - a.vertices[j])
                                              .cross(integers(b.vertices[k] - b.vertices[l]));
            if (across == IntegerVector3::Zero()) continue;
            directions.push_back(across);
            directions.emplace_back(-across);
          }
        }
      }
    }
    Rational least = plane_between(a, b, directions[0]).squared;
    for (const IntegerVector3& direction : directions) {
      least = std::min(least, plane_between(a, b, direction).squared);
    }
    const PlaneBetween found = plane_between(a, b, 0);
    CHECK(found.squared == least);
    CHECK(plane_between(a, b, found.direction).squared == least);
    CHECK(plane_between(b, a, 0).squared == least);
    CHECK((least == 0) == !common_interior(a, b));
    CHECK(plane_between(a, b, Rational(4)).squared <= std::max<Rational>(least, 4));
    overlapping += least > 0 ? 1 : 0;
  }
  CHECK(overlapping > 20);
}
