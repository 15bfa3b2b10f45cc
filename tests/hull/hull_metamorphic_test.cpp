// SPDX-License-Identifier: MIT
// What must not change the hull: order, repeats, inner points, powers of two, lattice translations;
// and the same points as doubles, rationals and homogeneous integers.
#include <doctest/doctest.h>

#include <cmath>

#include "checked_hull.hpp"
#include "convexact/error.hpp"
#include "convexact/hull.hpp"
#include "fractions.hpp"
#include "hull/exact_points.hpp"
#include "number/arithmetic.hpp"
#include "number/random.hpp"
#include "shapes/makers.hpp"

using namespace convexact;

namespace {

std::vector<std::vector<Point>> samples() {
  return {shapes::lattice(60, 3, 1),       shapes::lattice(200, 6, 2),
          shapes::in_ball(200, 3),         shapes::fibonacci_sphere(150),
          shapes::cube_symmetric(3, 8, 4), shapes::chamfered_box(Point(1, 2, 4), 0.25)};
}

std::set<Halfspace> planes(const std::vector<Point>& list) {
  const PointSet points(list);
  return facet_set(checked_hull(points), points);
}

}  // namespace

TEST_CASE("convex_hull: a permutation of the points leaves the planes as they are") {
  Random random(1);
  for (std::vector<Point> list : samples()) {
    const auto before = planes(list);
    shuffle(std::span(list), random);
    CHECK(planes(list) == before);
  }
}

TEST_CASE("convex_hull: repeats and inner points change neither vertices nor facets") {
  for (const std::vector<Point>& list : samples()) {
    const Hull before = checked_hull(PointSet(list));
    std::vector<Point> more = list;
    more.insert(more.end(), list.begin(), list.end());
    // The origin is in each of these hulls, and halving is exact.
    for (const Point& p : list) more.push_back(p / 2);
    const Hull after = checked_hull(PointSet(more));
    CHECK(after.vertices == before.vertices);
    CHECK(after.facets == before.facets);
  }
}

TEST_CASE("convex_hull: powers of two for each axis leave vertices and facets as they are") {
  for (const std::vector<Point>& list : samples()) {
    const Hull before = checked_hull(PointSet(list));
    for (const std::array<int, 3> e : {std::array{300, 300, 300}, std::array{-300, -300, -300},
                                       std::array{0, 40, -60}, std::array{900, 0, -900}}) {
      std::vector<Point> scaled = list;
      for (Point& p : scaled)
        for (int k = 0; k < 3; ++k) p[k] = std::ldexp(p[k], e[k]);
      const Hull after = checked_hull(PointSet(scaled));
      CHECK(after.vertices == before.vertices);
      CHECK(after.facets == before.facets);
    }
  }
}

TEST_CASE("convex_hull: translation on the lattice leaves vertices and facets as they are") {
  for (const std::vector<Point>& list : {shapes::lattice(60, 3, 1), shapes::lattice(200, 6, 2)}) {
    const Hull before = checked_hull(PointSet(list));
    std::vector<Point> moved = list;
    for (Point& p : moved) p += Point(0x1p52 - 8, -0x1p40, 12345);
    const Hull after = checked_hull(PointSet(moved));
    CHECK(after.vertices == before.vertices);
    CHECK(after.facets == before.facets);
  }
}

TEST_CASE("convex_hull: the same points as homogeneous integers, each with its own weight") {
  for (const std::vector<Point>& list : samples()) {
    const Hull doubles = checked_hull(PointSet(list));
    std::vector<HomogeneousPoint> points;
    for (std::size_t i = 0; i < list.size(); ++i) {
      HomogeneousPoint p;
      for (int k = 0; k < 3; ++k)
        p.n[k] = numerator(scale_by_power_of_two(to_rational(list[i][k]), 1074)) * (i + 1);
      p.w = (Integer(1) << 1074) * (i + 1);
      points.push_back(p);
    }
    const HullOutcome outcome = convex_hull(points);
    const Hull& hull = std::get<Hull>(outcome);
    CHECK(check_hull(hull, points));
    CHECK(hull.vertices == doubles.vertices);
    CHECK(hull.facets == doubles.facets);
  }
  std::vector<HomogeneousPoint> bad(1, {IntegerVector3(1, 0, 0), Integer(0)});
  CHECK_THROWS_AS((void)convex_hull(bad), Error);
}

TEST_CASE("convex_hull: a set of fractions and its homogeneous integers") {
  for (const std::vector<Point>& list : samples()) {
    for (const support::Fractions kind : support::kFractions) {
      CAPTURE(static_cast<int>(kind));
      const PointSet set = support::as_fractions(PointSet(list), kind);
      REQUIRE_FALSE(set.is_binary());
      std::vector<HomogeneousPoint> points;
      for (std::size_t i = 0; i < set.size(); ++i) {
        points.push_back(clear_denominators(set[PointId(i)]));
      }
      const Hull hull = checked_hull(set);
      const HullOutcome outcome = convex_hull(points);
      CHECK(check_hull(hull, points));
      CHECK(hull.vertices == std::get<Hull>(outcome).vertices);
      CHECK(hull.facets == std::get<Hull>(outcome).facets);
      // With a point that lies outside of it, it is no hull of the set.
      std::vector<RationalPoint> more;
      for (std::size_t i = 0; i < set.size(); ++i) more.push_back(set[PointId(i)]);
      more.push_back(more.front() + RationalPoint(Rational(100000, 3), 0, 0));
      CHECK_FALSE(check_hull(hull, PointSet(std::move(more))));
    }
  }
}

TEST_CASE("HomogeneousPoints: near points of a set are near") {
  for (const support::Fractions kind : support::kFractions) {
    CAPTURE(static_cast<int>(kind));
    const PointSet set = support::as_fractions(PointSet(shapes::in_ball(40, 5)), kind);
    HomogeneousPoints points(set);
    points.center_at({PointId(0), PointId(1), PointId(2), PointId(3)});
    RationalPoint center = set[PointId(0)];
    for (std::size_t k = 1; k < 4; ++k) center += set[PointId(k)];
    center /= Rational(4);
    for (int axis = 0; axis < 3; ++axis) {
      const auto near = [&](std::size_t i) {
        const NearPoint& p = points.near()[i];
        return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
      };
      const auto shifted = [&](std::size_t i) {
        return Rational(set[PointId(i)][axis] - center[axis]);
      };
      std::size_t farthest = 0;
      for (std::size_t i = 0; i < set.size(); ++i) {
        if (std::abs(near(i)) > std::abs(near(farthest))) farthest = i;
      }
      const Rational ratio = shifted(farthest) / to_rational(near(farthest));
      long exponent = exponent_of(ratio) - 2;  // ratio is a power of two, but for rounding
      while (scale_by_power_of_two(ratio, -exponent) > Rational(3, 2)) ++exponent;
      for (std::size_t i = 0; i < set.size(); ++i) {
        const Rational exact = scale_by_power_of_two(shifted(i), -exponent);
        CHECK(abs(exact) <= 1);
        CHECK(abs(Rational(exact - to_rational(near(i)))) <= to_rational(kNearError));
      }
    }
  }
}
