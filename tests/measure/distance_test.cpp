// SPDX-License-Identifier: MIT
// Distances. Expected values: closed forms; nearest points are proven by the projection theorem on
// the list of vertices, which shares nothing with the search.
#include <doctest/doctest.h>

#include "convexact/measure.hpp"
#include "expect_error.hpp"
#include "moved_polytope.hpp"
#include "polytope_by_definition.hpp"
#include "property.hpp"
#include "shapes/makers.hpp"
using namespace convexact;

namespace {

bool contains(const Polytope& polytope, const RationalPoint& x) {
  for (const Halfspace& plane : polytope.planes) {
    if (plane(x) > 0) return false;
  }
  return true;
}

// q is nearest to x iff it belongs to the polytope and no vertex lies on x's side of the plane
// through q perpendicular to x - q.
bool is_nearest(const RationalPoint& q, const RationalPoint& x, const Polytope& polytope) {
  const RationalVector3 away = x - q;
  for (const RationalPoint& v : polytope.vertices) {
    const RationalVector3 w = v - q;
    if (away.dot(w) > 0) return false;
  }
  return contains(polytope, q);
}

Rational squared(const RationalVector3& v) { return v.squaredNorm(); }

}  // namespace

TEST_CASE("nearest_point: facet, edge and vertex of a cube; inside; on the boundary") {
  const Polytope cube = solid(shapes::cube());
  const NearestPoint nearest(cube);
  CHECK(nearest({3, 0, Rational(1, 2)}) == RationalPoint(1, 0, Rational(1, 2)));
  CHECK(nearest({3, -2, Rational(1, 2)}) == RationalPoint(1, -1, Rational(1, 2)));
  CHECK(nearest({3, -2, 5}) == RationalPoint(1, -1, 1));
  CHECK(nearest({0, 0, 0}) == RationalPoint(0, 0, 0));
  CHECK(nearest({1, 0, 0}) == RationalPoint(1, 0, 0));
  // On the border between two regions.
  CHECK(nearest({3, 1, 0}) == RationalPoint(1, 1, 0));
  CHECK(nearest({3, 1, 1}) == RationalPoint(1, 1, 1));
}

TEST_CASE("nearest_point: the projection theorem holds around many solids") {
  for (const auto& points :
       {shapes::in_ball(20, 1), shapes::lattice(15, 2, 1), shapes::needle(12, 1e8, 1),
        shapes::prism(7), shapes::nearly_flat(12, 1), shapes::cut_cube(5, 0.25)}) {
    const Polytope polytope = solid(points);
    const NearestPoint nearest(polytope);
    for (const Point& direction : shapes::lattice(60, 2, 7)) {
      const RationalPoint x = to_rational(direction);
      CHECK(is_nearest(nearest(x), x, polytope));
    }
  }
}

TEST_CASE("nearest_point: from near and far, on many facets, far from the origin (#13)") {
  for (const auto& points :
       {shapes::on_sphere(40, 1), shapes::prism(18), shapes::needle(25, 1e12, 2)}) {
    const Polytope polytope = solid(points);
    for (const auto& by : {RationalVector3(0, 0, 0), RationalVector3(0x1p60, -0x1p61, 0x1p55)}) {
      const Polytope moved = translated(polytope, by);
      const NearestPoint nearest(moved);
      for (std::size_t v = 0; v < moved.vertices.size(); v += 3) {
        for (const Rational& factor :
             {Rational(1), Rational(101, 100), Rational(3), Rational(99, 100)}) {
          const RationalPoint x =
              by + factor * (moved.vertices[v] - by) + RationalVector3(0, 0, Rational(1, 1000));
          CHECK(is_nearest(nearest(x), x, moved));
        }
      }
    }
  }
}

TEST_CASE("hausdorff_distance: closed forms") {
  const Polytope small = solid(shapes::cube()), large = scaled(small, 1);
  const HausdorffDistance d = hausdorff_distance(large, small);
  CHECK(d.squared == 3);
  CHECK(d.vertex == 0);
  CHECK(d.nearest == RationalPoint(-1, -1, -1));
  CHECK(hausdorff_distance(small, small).squared == 0);
  // A corner cut at depth t is t / sqrt(3) away from its cut.
  const HausdorffDistance cut =
      hausdorff_distance(solid(shapes::cut_cube(0, 0.25)), solid(shapes::cut_cube(1, 0.25)));
  CHECK(cut.squared == Rational(1, 48));
  CHECK(cut.nearest == RationalPoint(Rational(1, 12), Rational(1, 12), Rational(1, 12)));
  // From the cube's corners to the octahedron: the plane x + y + z = 1, distance 2 / sqrt(3).
  CHECK(hausdorff_distance(small, solid(shapes::octahedron())).squared == Rational(4, 3));
}

TEST_CASE("hausdorff_distance: the pair is nearest, no vertex is farther; scale and translation") {
  check_property("definition", [](std::uint16_t seed, std::int8_t k) {
    const std::vector<Point> points = shapes::in_box(9, seed);
    const Polytope inner = solid({points.begin(), points.begin() + 6}), outer = solid(points);
    const HausdorffDistance d = hausdorff_distance(outer, inner);
    RC_ASSERT(is_nearest(d.nearest, outer.vertices[d.vertex], inner));
    RC_ASSERT(squared(outer.vertices[d.vertex] - d.nearest) == d.squared);
    for (const RationalPoint& v : outer.vertices) {
      RC_ASSERT(squared(v - NearestPoint(inner)(v)) <= d.squared);
    }
    RC_ASSERT(hausdorff_distance(scaled(outer, k), scaled(inner, k)).squared ==
              scale_by_power_of_two(d.squared, 2 * k));
    const RationalVector3 by(Rational(k, 3), 5, -7);
    RC_ASSERT(hausdorff_distance(translated(outer, by), translated(inner, by)).squared ==
              d.squared);
    RC_ASSERT(hausdorff_distance(shuffled(outer, 1), shuffled(inner, 2)).squared == d.squared);
  });
}

TEST_CASE("edges: Euler's formula, each edge between the facets that hold it") {
  for (const auto& points : {shapes::cube(), shapes::dodecahedron(), shapes::in_ball(25, 1)}) {
    const Polytope polytope = solid(points);
    const std::vector<Edge> list = edges(polytope);
    CHECK(polytope.vertices.size() + polytope.facets.size() == list.size() + 2);
    for (const Edge& e : list) {
      for (const std::uint32_t f : {e.left, e.right}) {
        CHECK(polytope.planes[f](polytope.vertices[e.tail]) == 0);
        CHECK(polytope.planes[f](polytope.vertices[e.head]) == 0);
      }
      // Seen from outside, n_left x along points into the left facet, away from the right one.
      const RationalVector3 along = polytope.vertices[e.head] - polytope.vertices[e.tail];
      const RationalVector3 n = polytope.planes[e.left].normal().cast<Rational>();
      CHECK(n.cross(along).dot(polytope.planes[e.right].normal().cast<Rational>()) < 0);
    }
  }
  Polytope open = solid(shapes::cube());
  open.facets.pop_back();
  CHECK(error_of([&] { return edges(open); }).code() == ErrorCode::InvalidArgument);
}
