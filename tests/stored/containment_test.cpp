// SPDX-License-Identifier: MIT
// count_outside against the definition in GMP integers, and at one ulp from the plane.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "convexact/error.hpp"
#include "convexact/stored.hpp"
#include "hill_climb.hpp"
#include "near/near_plane.hpp"
#include "property.hpp"
#include "shapes/makers.hpp"
#include "stored/prepared_halfspaces.hpp"
#include "stored_cases.hpp"
#include "sweep.hpp"

using namespace convexact;

namespace {

std::size_t by_definition(std::span<const Halfspace> halfspaces, const PointSet& points) {
  std::vector<stored_checker::Plane> planes;
  for (const Halfspace& h : halfspaces) planes.push_back(stored_cases::to_plane(h));
  return stored_checker::count_outside(planes, stored_cases::to_homogeneous(points));
}

}  // namespace

TEST_CASE("count_outside: a point on the plane is inside, one ulp beyond it is outside") {
  // x + y + z <= 0.6 as the doubles are.
  const Rational sum = to_rational(0.1) + to_rational(0.2) + to_rational(0.3);
  const Halfspace h(RationalVector3(1, 1, 1), Rational(-sum));
  const std::vector<Halfspace> halfspaces{h};
  CHECK(count_outside(halfspaces, PointSet(std::vector<Point>{{0.1, 0.2, 0.3}})) == 0);
  CHECK(count_outside(halfspaces,
                      PointSet(std::vector<Point>{{0.1, 0.2, std::nextafter(0.3, 1.0)}})) == 1);
  CHECK(count_outside(halfspaces,
                      PointSet(std::vector<Point>{{0.1, 0.2, std::nextafter(0.3, 0.0)}})) == 0);
}

TEST_CASE("count_outside: among points that are no doubles each is judged by itself (#48)") {
  // x <= 1. The last point is less than half a denormal number beyond 1, its nearest double.
  const std::vector<Halfspace> halfspaces{{IntegerVector3(1, 0, 0), -1}};
  const Rational least(Rational(1) / Rational(Integer(1) << 2000));
  const auto at = [](const Rational& x) { return RationalPoint(x, 0, 0); };
  const PointSet points(std::vector<RationalPoint>{
      at(Rational(1, 3)), at(1), at(to_rational(std::nextafter(1.0, 2.0))), at(Rational(4, 3)),
      at(Rational(1 - least)), at(Rational(1 + least))});
  REQUIRE_FALSE(points.is_binary());
  CHECK(find_outside(halfspaces, points) ==
        std::vector<PointId>{PointId(2), PointId(3), PointId(5)});
}

TEST_CASE("count_outside: a point counts once, whatever number of halfspaces it violates") {
  const std::vector<Halfspace> halfspaces{{IntegerVector3(1, 0, 0), -1},
                                          {IntegerVector3(0, 1, 0), -1}};
  CHECK(count_outside(halfspaces, PointSet(std::vector<Point>{
                                      {2, 2, 0}, {0, 0, 0}, {0, 2, 0}, {1, 1, 9}})) == 2);
  CHECK(count_outside(halfspaces, PointSet(std::vector<Point>{})) == 0);
  CHECK(count_outside({}, PointSet(std::vector<Point>{{2, 2, 0}})) == 0);
}

TEST_CASE("count_outside: overflow and underflow are left to the exact numbers") {
  const double most = std::numeric_limits<double>::max();
  const double least = std::numeric_limits<double>::denorm_min();
  // x - y + z - most <= 0: every partial sum may overflow, and inf - inf is NaN.
  const std::vector<Halfspace> large{{RationalVector3(1, -1, 1), Rational(-to_rational(most))}};
  CHECK(count_outside(large, PointSet(std::vector<Point>{{most, -most, most}})) == 1);
  CHECK(count_outside(large, PointSet(std::vector<Point>{{most, most, most}})) == 0);
  CHECK(count_outside(large, PointSet(std::vector<Point>{{-most, most, -most}})) == 0);
  // x / 3 + y <= least: the product x / 3 underflows.
  const std::vector<Halfspace> small{
      {RationalVector3(Rational(1, 3), 1, 0), Rational(-to_rational(least))}};
  CHECK(count_outside(small, PointSet(std::vector<Point>{{least, least, 0}})) == 1);
  CHECK(count_outside(small, PointSet(std::vector<Point>{{-least, least, 0}})) == 0);
  // An offset beyond the largest double.
  const Rational beyond = scale_by_power_of_two(Rational(1), 1030);
  const std::vector<Halfspace> far{{RationalVector3(1, 1, 1), Rational(-beyond)}};
  CHECK(count_outside(far, PointSet(std::vector<Point>{{most, most, most}})) == 0);
  const std::vector<Halfspace> none{{RationalVector3(1, 1, 1), beyond}};
  CHECK(count_outside(none, PointSet(std::vector<Point>{{-most, -most, -most}})) == 1);
}

TEST_CASE("count_outside: agrees with the definition") {
  check_property("count_outside agrees with GMP on random planes through near points", [] {
    const auto seed = *rc::gen::arbitrary<std::uint32_t>();
    for (const auto& points :
         {shapes::lattice(40, 4, seed), shapes::in_ball(40, seed),
          shapes::wide_exponents(40, 200, seed), shapes::offset_ball(40, 1e8, seed)}) {
      const std::vector<Halfspace> halfspaces = [&] {
        std::vector<Halfspace> made;
        for (int i = 0; i + 3 <= 9; i += 3) {
          const Point u = points[i + 1] - points[i], v = points[i + 2] - points[i];
          if (to_rational(points[i]) == to_rational(points[i + 1])) continue;
          const RationalVector3 n = to_rational(u).cross(to_rational(v));
          if (n == RationalVector3::Zero()) continue;
          made.push_back({n, Rational(-n.dot(to_rational(points[i])))});
        }
        return made;
      }();
      const PointSet set(points);
      RC_ASSERT(count_outside(halfspaces, set) == by_definition(halfspaces, set));
      std::vector<RationalPoint> thirds;
      for (const Point& p : points) thirds.push_back(to_rational(p) / Rational(3));
      const PointSet rational(thirds);
      RC_ASSERT(count_outside(halfspaces, rational) == by_definition(halfspaces, rational));
    }
  });
}

// A halfspace whose coefficients doubles round, against rationals.
TEST_CASE("DoubleHalfspace: the bound holds for the worst found, and is not vacuous") {
  const auto ratio = [](const std::vector<double>& y) -> double {
    const Integer scale = (Integer(1) << 90) + 12345;  // no coefficient is a double
    const auto coefficient = [&](double c) { return Integer(Rational(to_rational(c) * scale)); };
    const IntegerVector3 n(coefficient(y[0]), coefficient(y[1]), coefficient(y[2]));
    if (n.isZero(0)) return 0;
    const Halfspace h(n, coefficient(y[3]));
    const DoubleHalfspace near(h);
    const Point x(y[4], y[5], y[6]);
    const std::vector<Point> points{x};
    const NearValue value = near.at(CoordinateArrays(points), 0, 0);
    if (value.error == 0) return 0;
    // The scaling is the power of two that brings the largest coefficient into [1/2, 1].
    std::size_t bits = 0;
    for (int k = 0; k < 3; ++k) bits = std::max(bits, bit_length(h.normal()[k]));
    const Rational truth = scale_by_power_of_two(h(to_rational(x)), -static_cast<long>(bits));
    return Rational(abs(Rational(to_rational(value.value) - truth)) / to_rational(value.error))
        .convert_to<double>();
  };
  const double highest = hill_climb::highest(7, 12, 400, 1, ratio);
  MESSAGE("n.x + d: " << highest << " of the bound is reached");
  CHECK(highest <= 1);
  CHECK(highest > 0.1);
}

// Two coefficients underflow, times coordinates that make more of them than of the third.
// Many halfspaces: points are put into blocks of neighbours, and boxes of blocks are settled at
// once.
TEST_CASE("find_outside: many points and many halfspaces, point by point (#13)" * sweep) {
  const auto near_sphere = [](double reach, std::uint64_t seed) {
    std::vector<Point> points = shapes::on_sphere(700, seed);
    for (std::size_t i = 0; i < points.size(); i += 5) points[i] *= i % 2 == 0 ? reach : 0.5;
    return points;
  };
  for (const auto& directions : {shapes::on_sphere(400, 3), shapes::lattice(500, 9, 1)}) {
    std::vector<Halfspace> halfspaces;
    for (const Point& n : directions) {
      if (!n.isZero(0)) halfspaces.emplace_back(to_rational(n), Rational(-n.squaredNorm()));
    }
    REQUIRE(halfspaces.size() >= 256);
    const PreparedHalfspaces prepared(halfspaces);  // for all sets of points
    std::vector<RationalPoint> thirds;
    for (const Point& p : near_sphere(1.001, 4))
      thirds.push_back(to_rational(p) / Rational(3) * Rational(2));
    for (const PointSet& points :
         {PointSet(near_sphere(1.001, 1)), PointSet(near_sphere(40, 2)), PointSet(thirds),
          PointSet(std::vector<Point>(300, Point(1, 0, 0))),
          PointSet(shapes::lattice(900, 2, 5))}) {
      std::vector<PointId> expected;
      for (std::size_t i = 0; i < points.size(); ++i) {
        const PointId id(i);
        const bool is_outside = std::any_of(halfspaces.begin(), halfspaces.end(),
                                            [&](const Halfspace& h) { return h(points[id]) > 0; });
        if (is_outside) expected.push_back(id);
      }
      CHECK(find_outside(halfspaces, points) == expected);
      CHECK(find_outside(prepared, points) == expected);
    }
  }
  const std::atomic<bool> stop = true;
  CHECK_THROWS_AS((void)find_outside({}, PointSet(shapes::lattice(9, 2, 5)), &stop), Error);
}

TEST_CASE("count_outside: what a coefficient loses to underflow is paid for") {
  std::vector<Halfspace> halfspaces{{IntegerVector3(Integer(1) << 1077, 1, 1), 0}};
  const PointSet point(std::vector<Point>{{-0x1p-1000, 0x1p1000, 0x1p1000}});
  CHECK(by_definition(halfspaces, point) == 1);
  CHECK(count_outside(halfspaces, point) == 1);
  // Among so many, halfspaces are tested in groups first.
  while (halfspaces.size() < 300) {
    halfspaces.emplace_back(IntegerVector3((Integer(1) << 1077) + halfspaces.size(), -1, -1), 0);
  }
  CHECK(count_outside(halfspaces, point) == 1);
}

TEST_CASE("find_outside: groups of halfspaces, some too large for doubles, at one ulp") {
  const auto most = Rational(to_rational(std::numeric_limits<double>::max()));
  std::vector<Halfspace> halfspaces;
  for (int i = 0; i < 300; ++i) {  // x + (i/1000) y <= 1, and some that hold nothing outside
    halfspaces.emplace_back(RationalVector3(1, Rational(i, 1000), 0), Rational(-1));
    halfspaces.emplace_back(RationalVector3(-1, Rational(i, 1000), 0),
                            Rational(-scale_by_power_of_two(most, i)));
  }
  const PointSet points(std::vector<Point>{{1, 0, 7},
                                           {std::nextafter(1.0, 2.0), 0, 0},
                                           {0.5, 1.67, 0},
                                           {0.5, 1.673, 0},
                                           {-std::numeric_limits<double>::max(), 0, 0},
                                           {1, -1, 1e300}});
  // 0.5 + 0.299 * 1.673 > 1 > 0.5 + 0.299 * 1.67.
  CHECK(find_outside(halfspaces, points) == std::vector<PointId>{PointId(1), PointId(3)});
}

TEST_CASE("find_outside: the same for any number of threads") {
  std::vector<Halfspace> cube;
  for (int k = 0; k < 3; ++k) {
    for (const int side : {-1, 1}) {
      IntegerVector3 n = IntegerVector3::Zero();
      n[k] = side;
      cube.emplace_back(n, Integer(-1));
    }
  }
  std::vector<Point> points = shapes::in_ball(30000, 7);  // of radius 1
  std::vector<PointId> expected;
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i] *= 1.25;
    if (points[i].lpNorm<Eigen::Infinity>() > 1) expected.emplace_back(i);
  }
  REQUIRE(expected.size() > 1000);
  for (const std::size_t jobs : {1u, 2u, 3u, 8u}) {
    CHECK(find_outside(cube, PointSet(points), {}, jobs) == expected);
  }
  CHECK_THROWS_AS((void)find_outside(cube, PointSet(points), {}, 0), Error);
}
