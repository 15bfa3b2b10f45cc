// SPDX-License-Identifier: MIT
// Flat input, repeats, and points that are one unit in the last place from flat.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "affine_dimension.hpp"
#include "checked_hull.hpp"
#include "shapes/makers.hpp"
#include "sweep.hpp"

using namespace convexact;

namespace {

FlatInput checked_flat(const PointSet& points) {
  const HullOutcome outcome = convex_hull(points);
  REQUIRE(std::holds_alternative<FlatInput>(outcome));
  const FlatInput& flat = std::get<FlatInput>(outcome);
  CHECK(check_flat(flat, points));
  std::vector<RationalPoint> list;
  for (std::size_t i = 0; i < points.size(); ++i) list.push_back(points[PointId(i)]);
  CHECK(flat.dimension == affine_dimension(list));
  return flat;
}

}  // namespace

TEST_CASE("convex_hull: points that span no volume, with proof") {
  CHECK(checked_flat(PointSet()).dimension == -1);
  CHECK(checked_flat(PointSet(std::vector<Point>{Point(1, 2, 3)})).dimension == 0);
  CHECK(checked_flat(PointSet(shapes::all_equal(20))).dimension == 0);
  CHECK(checked_flat(PointSet(shapes::collinear(20, 1))).dimension == 1);
  CHECK(checked_flat(PointSet(shapes::coplanar(3, 1))).dimension == 2);
  CHECK(checked_flat(PointSet(shapes::coplanar(200, 1))).dimension == 2);
  const std::vector<RationalPoint> thirds{{Rational(1, 3), 0, 0},
                                          {0, Rational(1, 3), 0},
                                          {0, 0, Rational(1, 3)},
                                          {Rational(1, 6), Rational(1, 6), 0}};
  CHECK(checked_flat(PointSet(thirds)).dimension == 2);
  // An axis with subnormal extent counts.
  const double least = std::numeric_limits<double>::denorm_min();
  CHECK(checked_flat(PointSet(std::vector<Point>{{0, 0, 0}, {0, 0, least}})).dimension == 1);
}

TEST_CASE("check_flat: wrong proofs are rejected") {
  const PointSet points(shapes::coplanar(10, 1));
  const FlatInput flat = checked_flat(points);
  FlatInput wrong = flat;
  wrong.dimension = 1;
  CHECK_FALSE(check_flat(wrong, points));
  wrong = flat;
  wrong.basis[2] = wrong.basis[1];
  CHECK_FALSE(check_flat(wrong, points));
  wrong = flat;
  wrong.basis[0] = PointId(10);
  CHECK_FALSE(check_flat(wrong, points));
  wrong = flat;
  wrong.equations[0] = Halfspace(flat.equations[0].normal(), flat.equations[0].offset() + 1);
  CHECK_FALSE(check_flat(wrong, points));
  wrong = flat;  // more of what is right already
  wrong.basis.push_back(wrong.basis[0]);
  CHECK_FALSE(check_flat(wrong, points));
  wrong = flat;
  wrong.equations.push_back(wrong.equations[0]);
  CHECK_FALSE(check_flat(wrong, points));
  wrong = flat;
  wrong.dimension = -2;
  CHECK_FALSE(check_flat(wrong, points));
  // Four points that span space are no flat input, though they are a basis without equations.
  const PointSet solid(shapes::tetrahedron());
  CHECK_FALSE(check_flat({3, {PointId(0), PointId(1), PointId(2), PointId(3)}, {}}, solid));
  const PointSet line(shapes::collinear(10, 1));
  wrong = checked_flat(line);
  wrong.equations[1] = wrong.equations[0];
  CHECK_FALSE(check_flat(wrong, line));
}

TEST_CASE("convex_hull: one unit in the last place from flat is solid") {
  const std::vector<Point> square{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  for (const double z : {std::nextafter(1.0, 0.0), std::nextafter(1.0, 2.0)}) {
    std::vector<Point> points = square;
    points.emplace_back(0.5, 0.5, z);
    const Hull hull = checked_hull(PointSet(points));
    CHECK(hull.vertices.size() == 5);
    CHECK(hull.facets.size() == 5);
  }
  const double least = std::numeric_limits<double>::denorm_min();
  const Hull sliver = checked_hull(PointSet(
      std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.25, 0.25, least}, {0.25, 0.25, 0}}));
  CHECK(sliver.vertices.size() == 4);
  CHECK(sliver.facets.size() == 4);
}

TEST_CASE("convex_hull: nearly flat, stretched, tiny and huge families pass their certificates") {
  for (const auto& points :
       {shapes::nearly_flat(300, 1), shapes::nearly_coplanar(300, 1), shapes::needle(300, 1e8, 1),
        shapes::needle(300, 1e16, 1), shapes::needle(300, 1e30, 1), shapes::slab(300, 1e16, 1),
        shapes::offset_ball(300, 1e8, 1), shapes::offset_ball(300, 1e15, 1),
        shapes::subnormal(300, 100, 1), shapes::huge(300, 1), shapes::wide_exponents(60, 500, 1),
        shapes::scaled_ball(300, 300, 1), shapes::scaled_ball(300, -300, 1),
        shapes::scaled_ball(300, -950, 1)}) {
    checked_hull(PointSet(points));
  }
}

TEST_CASE("convex_hull: of equal points the lowest id is the vertex") {
  std::vector<Point> points{{0.5, 0.5, 0.5}};
  for (int copy = 0; copy < 3; ++copy)
    for (const Point& p : shapes::cut_cube(1, 0.5)) points.push_back(p);
  const std::size_t each = (points.size() - 1) / 3;
  const Hull hull = checked_hull(PointSet(points));
  CHECK(hull.vertices.size() == 10);  // 7 corners and 3 midpoints of edges
  CHECK(hull.facets.size() == 7);
  for (const PointId p : hull.vertices) {
    for (std::size_t i = 0; i < p.index(); ++i) CHECK(points[i] != points[p.index()]);
    CHECK(p.index() <= each);
  }
}

TEST_CASE("convex_hull: valences of ten thousand take no quadratic time" * sweep) {
  // Quadratic work would be 10^8 exact signs, minutes; the runner stops it after 30 seconds.
  CHECK(checked_hull(PointSet(shapes::pyramid(10000))).facets.size() == 10001);
  CHECK(checked_hull(PointSet(shapes::bipyramid(10000))).facets.size() == 20000);
  CHECK(checked_hull(PointSet(shapes::prism(10000))).facets.size() == 10002);
  CHECK(checked_hull(PointSet(shapes::cone(10000, 2))).vertices.size() == 10001);
  CHECK(checked_hull(PointSet(shapes::cylinder(10000, 3))).vertices.size() == 20000);
}
