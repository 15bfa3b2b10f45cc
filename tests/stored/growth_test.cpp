// SPDX-License-Identifier: MIT
// Growth of solids whose distance and volume have a closed form.
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "convexact/error.hpp"
#include "convexact/measure.hpp"
#include "convexact/stored.hpp"
#include "shapes/makers.hpp"
#include "stored/acceptance.hpp"
#include "stored_cases.hpp"

using namespace convexact;
using convexact::stored::growth;

namespace {

Polytope hull_of(const std::vector<Point>& points) {
  return stored_cases::hull_case(PointSet(points))->exact;
}

Polytope box(double a, double b, double c) { return hull_of(shapes::box({a, b, c})); }

const RationalPoint kOrigin = RationalPoint::Zero();

// At or above the true value, by no more than some units in the last place.
bool is_upper_bound(double bound, double value) {
  return bound >= value * (1 - 1e-15) && bound <= value * (1 + 1e-14);
}

}  // namespace

TEST_CASE("growth: a solid is at distance 0 from itself") {
  const Growth same = growth(box(1, 2, 3), box(1, 2, 3), kOrigin, Rational(56));
  CHECK(same.push == 0);
  CHECK(same.volume_ratio == 1);
}

TEST_CASE("growth: a center that is not strictly inside both solids is refused") {
  const Polytope small = box(1, 1, 1), large = box(2, 2, 2);
  for (const Rational& x : {Rational(1), Rational(3, 2), Rational(3)}) {
    const RationalPoint center(x, Rational(0), Rational(0));
    CHECK_THROWS_AS((void)growth(small, large, center, Rational(12)), Error);
    CHECK_THROWS_AS((void)growth(large, small, center, Rational(12)), Error);
  }
}

TEST_CASE("growth: a scaled cube, either way round") {
  // Half edges 1 and 1 + 2^-20: corners move by sqrt(3) 2^-20; divided by the diagonal 2 sqrt(3).
  const double step = 0x1p-20;
  const Polytope inner = box(1, 1, 1), outer = box(1 + step, 1 + step, 1 + step);
  const Growth grown = growth(inner, outer, kOrigin, Rational(12));
  CHECK(is_upper_bound(grown.push, step / 2));
  CHECK(is_upper_bound(grown.volume_ratio, std::pow(1 + step, 3)));
  const Growth shrunk = growth(outer, inner, kOrigin, Rational(12));
  CHECK(shrunk.push == grown.push);
  CHECK(shrunk.volume_ratio < 1);
}

// The squared distance of the corners is 3 step^2, exactly, so the push is the root of 3 step^2 /
// D: never below it, whatever the roundings on the way, and less than three units above.
TEST_CASE("growth: the push is rounded up") {
  const double step = 0x1p-20;
  const Polytope inner = box(1, 1, 1), outer = box(1 + step, 1 + step, 1 + step);
  // Of the first three, the root of the quotient rounded down is too small even one unit higher.
  std::vector<int> divisors{1529, 1531, 3347};
  for (int d = 1; d <= 400; ++d) divisors.push_back(d);
  for (const int d : divisors) {
    const Rational squared = 3 * to_rational(step * step) / Rational(d);
    const double push = growth(inner, outer, kOrigin, Rational(d)).push;
    const double below = push * (1 - 3 * 0x1p-52);
    CHECK(to_rational(push) * to_rational(push) >= squared);
    CHECK(to_rational(below) * to_rational(below) < squared);
  }
  // (1 + 2^-20)^3 has 61 bits.
  const Rational side = 1 + to_rational(step), ratio = side * side * side;
  const double rounded = growth(inner, outer, kOrigin, Rational(1)).volume_ratio;
  CHECK(to_rational(rounded) > ratio);
  CHECK(to_rational(std::nextafter(rounded, 0.0)) < ratio);
}

TEST_CASE("growth: neither solid holds the other") {
  // Boxes of half edges (1, 1, 2) and (1, 2, 1): a corner is at distance 1 from the other box, and
  // the nearest corner of the other is at distance sqrt(2): the bound is between them.
  const Growth moved = growth(box(1, 1, 2), box(1, 2, 1), kOrigin, Rational(1));
  CHECK(moved.push >= 1);
  CHECK(moved.push <= std::sqrt(2) * (1 + 1e-15));
  CHECK(moved.volume_ratio == 1);
}

TEST_CASE("growth: a vertex far from all others, near to an edge") {
  // The long box with one end cut off by 2^-30: no vertex of the cut box is nearer than that, so
  // the way in along the ray to the center, about 2^-30 long, is the bound.
  const double step = 0x1p-30;
  std::vector<Point> cut = shapes::box({8, 1, 1});
  for (Point& p : cut) p.x() = p.x() > 0 ? p.x() - step : p.x();
  const Growth grown = growth(hull_of(cut), box(8, 1, 1), kOrigin, Rational(1));
  CHECK(grown.push >= step);
  CHECK(grown.push <= 1.01 * step);
}

TEST_CASE("growth: never below the exact distance, and near it") {
  // NearestPoint is exact and knows nothing of rays to a center.
  const auto exact_square = [](const Polytope& from, const Polytope& to) {
    const NearestPoint nearest(to);
    Rational most = 0;
    for (const RationalPoint& v : from.vertices) {
      most = std::max(most, (v - nearest(v)).squaredNorm());
    }
    return most;
  };
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
    const Polytope a = hull_of(shapes::in_box(20, seed)), b = hull_of(shapes::in_box(20, seed + 9));
    const Rational squared = std::max(exact_square(a, b), exact_square(b, a));
    const Rational bound = to_rational(growth(a, b, kOrigin, Rational(1)).push);
    CHECK(bound * bound >= squared);
    CHECK(bound * bound <= 4 * squared);
  }
}

// Every vertex is as far from its copy as the solid was moved. Of a needle's tips the way in is
// much longer, so a copy that is not found would show; and vertices are sought in their order along
// (0.48, 0.6, 0.64), so needles across it are the hard ones: many vertices are at nearly one
// height.
TEST_CASE("growth: a solid that was moved is no farther than that") {
  std::vector<Point> across = shapes::in_ball(300, 7);
  for (Point& p : across) {
    p = 1024 * p.x() * Point(0.6, -0.48, 0) + p.y() * Point(0.3072, 0.384, -0.5904) +
        p.z() * Point(0.48, 0.6, 0.64);
  }
  const std::vector<std::vector<Point>> shapes = {across, shapes::in_ball(300, 7),
                                                  shapes::box({1024, 1, 1}), shapes::prism(40)};
  const std::vector<Point> moves = {{1, 0, 0},       {0, 1, 0},    {0, 0, 1},
                                    {0.6, -0.48, 0}, {-1, -1, -1}, {0.48, 0.6, 0.64}};
  for (const std::vector<Point>& points : shapes) {
    for (const Point& move : moves) {
      for (const double length : {0x1p-20, 0x1p-4}) {
        const RationalVector3 step = to_rational(Point(length * move));
        const Polytope solid = hull_of(points);
        Polytope moved = solid;
        for (RationalPoint& v : moved.vertices) v += step;
        for (Halfspace& h : moved.planes) {
          const RationalVector3 normal = h.normal().cast<Rational>();
          h = Halfspace(normal, Rational(h.offset() - normal.dot(step)));
        }
        const Rational bound = to_rational(growth(solid, moved, kOrigin, Rational(1)).push);
        CHECK(bound > 0);
        CHECK(bound * bound <= step.squaredNorm() * (1 + Rational(1, Integer(1) << 40)));
      }
    }
  }
}
