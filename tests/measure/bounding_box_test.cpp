// SPDX-License-Identifier: MIT
// Bounding boxes against hand-made values.
#include <doctest/doctest.h>

#include "convexact/error.hpp"
#include "convexact/measure.hpp"

using namespace convexact;

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
