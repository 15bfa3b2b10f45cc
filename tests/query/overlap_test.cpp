// SPDX-License-Identifier: MIT
// Overlap of two solids. Expected values: closed forms for boxes; for random pairs the Minkowski
// difference by the definition, whose distance from the origin is the distance of the two.
#include <doctest/doctest.h>

#include "convexact/hull.hpp"
#include "convexact/measure.hpp"
#include "convexact/query.hpp"
#include "moved_polytope.hpp"
#include "query_solids.hpp"
#include "shapes/makers.hpp"
#include "sweep.hpp"
using namespace convexact;
using support::box_between;
using support::cube_of;
using support::grid_solid;

namespace {

// a - b for all vertices a of A and b of B: its hull holds the origin iff A and B meet.
Polytope difference_of(const Polytope& a, const Polytope& b) {
  std::vector<RationalPoint> points;
  for (const RationalPoint& v : a.vertices) {
    for (const RationalPoint& w : b.vertices) points.push_back(v - w);
  }
  return polytope_by_definition(PointSet(points));
}

Rational squared_distance(const Polytope& difference) {
  const RationalPoint nearest = NearestPoint(difference)(RationalPoint::Zero());
  return nearest.squaredNorm();
}

bool is_on_border(const Polytope& solid, const RationalPoint& x) {
  bool touches = false;
  for (const Halfspace& plane : solid.planes) {
    if (plane(x) > 0) return false;
    touches = touches || plane(x) == 0;
  }
  return touches;
}

struct Sum {
  RationalVector3 normal = RationalVector3::Zero();
  Rational offset = 0;
  void add(const Polytope& solid, const std::vector<Multiplier>& multipliers) {
    for (const Multiplier& m : multipliers) {
      CHECK(m.value > 0);
      const Halfspace& plane = solid.planes.at(m.row);
      normal += m.value * plane.normal().cast<Rational>();
      offset += m.value * Rational(plane.offset());
    }
  }
};

// The certificate by its definition, and the lower bound of the distance that it gives: the square
// of y'd / |n|.
Rational proven_squared_distance(const Polytope& a, const Polytope& b, const Separation& apart) {
  CHECK(apart.of_a.size() + apart.of_b.size() <= 4);
  Sum sum;
  sum.add(a, apart.of_a);
  const RationalVector3 n = sum.normal;
  sum.add(b, apart.of_b);
  CHECK(sum.normal == RationalVector3::Zero());
  CHECK(sum.offset > 0);
  for (const RationalPoint& v : a.vertices) CHECK(apart.plane(v) < 0);
  for (const RationalPoint& v : b.vertices) CHECK(apart.plane(v) > 0);
  CHECK(same_direction(apart.plane, Halfspace(n, Rational(0))));
  return sum.offset * sum.offset / n.squaredNorm();
}

// The common point, which must exist; false CHECKs stand for a wrong answer.
RationalPoint common_point(const Polytope& a, const Polytope& b) {
  const Overlap answer = find_overlap(a, b);
  CHECK(check(a, b, answer));
  REQUIRE(std::holds_alternative<CommonPoint>(answer));
  return std::get<CommonPoint>(answer).point;
}

}  // namespace

TEST_CASE("overlap: cubes that touch in a vertex, an edge and a facet, nested, equal, crossing") {
  const Polytope unit = box_between({0, 0, 0}, {1, 1, 1});
  const RationalPoint corner(1, 1, 1);
  CHECK(common_point(unit, box_between({1, 1, 1}, {2, 2, 2})) == corner);
  // Of several common points it is the lexicographically largest.
  CHECK(common_point(unit, box_between({1, 1, 0}, {2, 2, 1})) == corner);
  CHECK(common_point(unit, box_between({1, 0, 0}, {2, 1, 1})) == corner);
  CHECK(common_point(unit, unit) == corner);
  CHECK(common_point(unit, box_between({-1, -1, -1}, {2, 2, 2})) == corner);
  const Rational half(1, 2);
  CHECK(common_point(unit, box_between({0.25, 0.25, 0.25}, {0.5, 0.5, 0.5})) ==
        RationalPoint(half, half, half));
  CHECK(common_point(unit, box_between({-1, -1, -1}, {0.5, 0.5, 0.5})) ==
        RationalPoint(half, half, half));
  // The octahedron |x| + |y| + |z| <= 1 and a cube that begins at the middle of its facet.
  const Polytope octahedron = solid(shapes::octahedron());
  const Polytope cube = box_between({0.25, 0.25, 0.5}, {1, 1, 1});
  CHECK(common_point(octahedron, cube) == RationalPoint(Rational(1, 4), Rational(1, 4), half));
}

TEST_CASE(
    "overlap: solids that are apart by the least there is, or far, have a plane between them") {
  const Polytope unit = box_between({0, 0, 0}, {1, 1, 1});
  const double after_one = 1 + 0x1p-52;
  for (const Polytope& other : {box_between({after_one, 0, 0}, {2, 1, 1}),
                                box_between({after_one, after_one, after_one}, {2, 2, 2}),
                                box_between({-0x1p60, -3, -2}, {-0x1p-1074, 3, 4}),
                                box_between({0x1p1000, 0, 0}, {0x1p1001, 1, 1})}) {
    const Overlap answer = find_overlap(unit, other);
    CHECK(check(unit, other, answer));
    REQUIRE(std::holds_alternative<Separation>(answer));
    (void)proven_squared_distance(unit, other, std::get<Separation>(answer));
    CHECK(check(other, unit, find_overlap(other, unit)));
  }
}

TEST_CASE("overlap: two edges across each other") {
  // The edge from (-1, 0, 0) to (1, 0, 0) on top of A, and across it, at height h, the lowest edge
  // of B: no facet of either separates them unless the cross product of the edges does.
  const Polytope a = solid({{-1, 0, 0}, {1, 0, 0}, {0, -1, -1}, {0, 1, -1}});
  for (const double height : {0.0, 0x1p-40, 0.5}) {
    const Polytope b =
        solid({{0, -1, height}, {0, 1, height}, {-1, 0, height + 1}, {1, 0, height + 1}});
    const Overlap answer = find_overlap(a, b);
    CHECK(check(a, b, answer));
    if (height == 0) {
      REQUIRE(std::holds_alternative<CommonPoint>(answer));
      CHECK(std::get<CommonPoint>(answer).point == RationalPoint(0, 0, 0));
      continue;
    }
    REQUIRE(std::holds_alternative<Separation>(answer));
    const Rational bound = proven_squared_distance(a, b, std::get<Separation>(answer));
    CHECK(bound <= to_rational(height) * to_rational(height));
  }
}

TEST_CASE("overlap: random pairs against the distance of their Minkowski difference" * sweep) {
  Random random(11);
  int apart = 0, touching = 0, crossing = 0;
  for (int round = 0; round < 60; ++round) {
    CAPTURE(round);
    const Polytope a = grid_solid(random, 5, 2, 2), b = grid_solid(random, 5, 2, 2);
    const Polytope difference = difference_of(a, b);
    const Rational squared = squared_distance(difference);
    const Overlap answer = find_overlap(a, b, static_cast<std::uint64_t>(round));
    CHECK(check(a, b, answer));
    CHECK(std::holds_alternative<CommonPoint>(answer) == (squared == 0));
    if (const auto* separation = std::get_if<Separation>(&answer)) {
      ++apart;
      CHECK(proven_squared_distance(a, b, *separation) <= squared);
    } else if (is_on_border(difference, RationalPoint::Zero())) {
      ++touching;
    } else {
      ++crossing;
    }
  }
  CHECK(apart > 5);
  CHECK(touching > 0);
  CHECK(crossing > 5);
}

TEST_CASE("overlap: neither the seed, the order of the points, nor the scale matters") {
  Random random(5);
  for (int round = 0; round < 12; ++round) {
    const Polytope a = grid_solid(random, 8, 3, 3), b = grid_solid(random, 8, 3, 3);
    const Overlap answer = find_overlap(a, b);
    const auto* common = std::get_if<CommonPoint>(&answer);
    for (std::uint64_t seed = 2; seed < 6; ++seed) {
      const Overlap other = find_overlap(a, b, seed);
      CHECK(check(a, b, other));
      REQUIRE(answer.index() == other.index());
      if (common != nullptr) CHECK(std::get<CommonPoint>(other).point == common->point);
    }
    for (const long k : {-700L, -3L, 900L}) {
      const Polytope large_a = scaled(a, k), large_b = scaled(b, k);
      const Overlap other = find_overlap(large_a, large_b);
      CHECK(check(large_a, large_b, other));
      REQUIRE(answer.index() == other.index());
      if (common == nullptr) continue;
      for (int i = 0; i < 3; ++i) {
        CHECK(std::get<CommonPoint>(other).point[i] == scale_by_power_of_two(common->point[i], k));
      }
    }
  }
  std::vector<Point> points = shapes::on_sphere(60, 3);
  const auto first = queried_solid(PointSet(points));
  shuffle(std::span(points), random);
  const auto second = queried_solid(PointSet(points), 9);
  const Polytope box = box_between({0.25, 0.25, 0.25}, {3, 3, 3});
  CHECK(common_point(std::get<Polytope>(first), box) ==
        common_point(std::get<Polytope>(second), box));
}

TEST_CASE("overlap: a claim that is not true fails its check") {
  const Polytope a = cube_of(1), b = box_between({2, 0, 0}, {3, 1, 1});
  CHECK_FALSE(check(a, b, CommonPoint{{1, 0, 0}}));
  CHECK_FALSE(check(a, b, CommonPoint{{2, 0, 0}}));
  CHECK(check(a, cube_of(2), CommonPoint{{1, 1, 1}}));
  const Separation right = std::get<Separation>(find_overlap(a, b));
  CHECK(check(a, b, right));
  CHECK_FALSE(check(b, a, right));
  CHECK_FALSE(check(a, cube_of(1), right));
  Separation wrong = right;
  wrong.of_b.clear();
  CHECK_FALSE(check(a, b, wrong));
  wrong = right;
  wrong.of_a[0].value *= 2;
  CHECK_FALSE(check(a, b, wrong));
  wrong = right;
  wrong.of_a[0].value *= -1;
  CHECK_FALSE(check(a, b, wrong));
  wrong = right;
  wrong.of_a[0].row = a.planes.size();
  CHECK_FALSE(check(a, b, wrong));
  wrong = right;
  wrong.of_b[0].row = b.planes.size();
  CHECK_FALSE(check(a, b, wrong));
  // A plane that touches A, one with the wrong side, one of another direction.
  for (const auto& [n, d] : {std::pair{IntegerVector3(1, 0, 0), -1},
                             {IntegerVector3(1, 0, 0), -2},
                             {IntegerVector3(-2, 0, 0), 3},
                             {IntegerVector3(8, 1, 0), -12}}) {
    wrong = right;
    wrong.plane = Halfspace(n, Integer(d));
    CHECK_FALSE(check(a, b, wrong));
  }
}

TEST_CASE("queried_solid: a shape without volume is no solid, with the proof") {
  const auto flat =
      queried_solid(PointSet(std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}));
  REQUIRE(std::holds_alternative<NotSolid>(flat));
  CHECK(std::holds_alternative<FlatInput>(std::get<NotSolid>(flat)));
  std::vector<Halfspace> slab{{IntegerVector3(1, 0, 0), Integer(-1)},
                              {IntegerVector3(-1, 0, 0), Integer(-1)}};
  const auto unbounded = queried_solid(slab);
  CHECK(std::holds_alternative<RecessionRay>(std::get<NotSolid>(unbounded)));
  slab[1] = Halfspace(IntegerVector3(-1, 0, 0), Integer(2));
  CHECK(std::holds_alternative<EmptyProof>(std::get<NotSolid>(queried_solid(slab))));
}
