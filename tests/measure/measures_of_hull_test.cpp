// SPDX-License-Identifier: MIT
// Volume, area and mean width of a hull from its points. Expected values: closed forms of boxes and
// simplices, and the measures of the same hull as a polytope, which are computed by facets, heights
// and planes instead.
#include <doctest/doctest.h>

#include <cmath>

#include "convexact/measure.hpp"
#include "number/precision.hpp"
#include "property.hpp"
#include "shapes/makers.hpp"

using namespace convexact;

namespace {
Hull hull_of(const PointSet& points) { return std::get<Hull>(convex_hull(points)); }

PointSet box(double x, double y, double z) {
  std::vector<Point> corners;
  for (int c = 0; c < 8; ++c) corners.push_back({c & 1 ? x : 0, c & 2 ? y : 0, c & 4 ? z : 0});
  return PointSet(std::move(corners));
}

// Both hold the same number, and the first one narrowly.
bool same_measure(const Enclosure& a, const Enclosure& b) {
  return (a - b).contains(0) && a.width() <= scale_by_power_of_two(a.high(), -kMeasureBits + 10);
}
bool is_near(const PointSet& points, CostMeasure measure, const Rational& value) {
  return same_measure(enclose_measure(hull_of(points), points, measure, kMeasureBits),
                      Enclosure(value, kMeasureBits));
}
}  // namespace

TEST_CASE("volume of a hull: boxes of every size") {
  for (const double size : {1.0, 0x1p-300, 0x1p300, 0.1}) {
    CAPTURE(size);
    const PointSet points = box(size, 3, 0.5);
    CHECK(volume(hull_of(points), points) == to_rational(size) * 3 / 2);
  }
}

TEST_CASE("volume of a hull: coordinates from the least to the largest double") {
  const double tiny = 5e-324, huge = 1e308;
  const PointSet points = box(tiny, huge, 1);
  CHECK(volume(hull_of(points), points) == to_rational(tiny) * to_rational(huge));
}

TEST_CASE("volume of a hull: points that are no doubles") {
  const Rational third(1, 3);
  const PointSet points(std::vector<RationalPoint>{
      RationalPoint(third, third, third), RationalPoint(third + 1, third, third),
      RationalPoint(third, third + 1, third), RationalPoint(third, third, third + third)});
  REQUIRE_FALSE(points.is_binary());
  CHECK(volume(hull_of(points), points) == Rational(1, 18));
}

TEST_CASE("volume of a hull: as by facets and heights") {
  check_property("two formulas agree", [](const std::vector<std::array<std::int16_t, 3>>& raw) {
    std::vector<Point> list;
    for (const auto& p : raw) list.push_back({std::ldexp(p[0], -7), p[1] * 0.1, 1e-9 * p[2]});
    const PointSet points(std::move(list));
    const HullOutcome outcome = convex_hull(points);
    RC_PRE(std::holds_alternative<Hull>(outcome));
    const Hull& hull = std::get<Hull>(outcome);
    RC_ASSERT(volume(hull, points) == volume(to_polytope(hull, points)));
  });
}

TEST_CASE("area and mean width of a hull: boxes from the least to the largest double") {
  for (const double size : {1.0, 0x1p-300, 0x1p300, 0.1, 5e-324, 1e308}) {
    CAPTURE(size);
    const Rational a = to_rational(size), b = 3, c(1, 2);
    const PointSet points = box(size, 3, 0.5);
    CHECK(is_near(points, CostMeasure::Volume, a * b * c));
    CHECK(is_near(points, CostMeasure::Area, 2 * (a * b + b * c + c * a)));
    CHECK(is_near(points, CostMeasure::MeanWidth, (a + b + c) / 2));
  }
}

TEST_CASE("area and mean width of a hull: points that are no doubles") {
  const Rational third(1, 3);
  std::vector<RationalPoint> corners;
  for (int c = 0; c < 8; ++c) {
    corners.emplace_back(c & 1 ? third : -third, c & 2 ? third : -third, c & 4 ? third : -third);
  }
  const PointSet points(std::move(corners));
  REQUIRE_FALSE(points.is_binary());
  CHECK(is_near(points, CostMeasure::Area, Rational(8, 3)));
  CHECK(is_near(points, CostMeasure::MeanWidth, 1));
}

TEST_CASE("area and mean width of a hull: as by planes, polygons included") {
  for (const auto& list : {shapes::octahedron(), shapes::prism(7), shapes::pyramid(30),
                           shapes::in_ball(200, 3), shapes::lattice(60, 3, 1)}) {
    const PointSet points(list);
    const Hull hull = hull_of(points);
    const Polytope polytope = to_polytope(hull, points);
    for (const CostMeasure measure : {CostMeasure::Area, CostMeasure::MeanWidth}) {
      CAPTURE(list.size());
      CHECK(same_measure(enclose_measure(hull, points, measure, kMeasureBits),
                         enclose_measure(polytope, measure, kMeasureBits)));
    }
  }
}
