// SPDX-License-Identifier: MIT
// Support function and bounding box, against hand-made values.
#include "measure/support.hpp"

#include <doctest/doctest.h>

#include "convexact/error.hpp"
#include "convexact/measure.hpp"
using namespace convexact;

TEST_CASE("support: no points, no direction") {
  CHECK_THROWS_AS(static_cast<void>(support(PointSet(), {1, 0, 0})), Error);
  const PointSet one(std::vector<Point>{{1, 2, 3}});
  CHECK_THROWS_AS(static_cast<void>(support(one, {0, 0, 0})), Error);
  CHECK(support(one, {1, 1, -1}).value == 0);
}

TEST_CASE("support: the largest dot product, the lowest id on a tie") {
  const PointSet points(std::vector<Point>{{0, 0, 0}, {1, 5, 0}, {1, 7, 0}, {1, 5, 0}});
  CHECK(support(points, {1, 0, 0}).point == PointId(1));
  CHECK(support(points, {2, 0, 0}).value == 2);
  CHECK(support(points, {0, Rational(1, 7), 0}).point == PointId(2));
  CHECK(support(points, {-1, 0, 0}).value == 0);
}

TEST_CASE("support: differences below one ulp decide") {
  const PointSet points(std::vector<Point>{{1, 0, 0}, {1, 0x1p-1074, 0}});
  const Support s = support(points, {1, 1, 0});
  CHECK(s.point == PointId(1));
  CHECK(s.value == 1 + scale_by_power_of_two(Rational(1), -1074));
}

TEST_CASE("bounding_box: doubles, rationals, none") {
  const PointSet doubles(std::vector<Point>{{0, 5, -1}, {2, -3, 4}, {1, 1, 1}});
  const BoundingBox box = bounding_box(doubles);
  CHECK(box.low == RationalPoint(0, -3, -1));
  CHECK(box.high == RationalPoint(2, 5, 4));
  CHECK(box.squared_diameter() == 4 + 64 + 25);
  const PointSet thirds(std::vector<RationalPoint>{{Rational(1, 3), 0, 0}, {0, Rational(2, 3), 0}});
  CHECK(bounding_box(thirds).squared_diameter() == Rational(5, 9));
  CHECK_THROWS_AS(static_cast<void>(bounding_box(PointSet())), Error);
}
