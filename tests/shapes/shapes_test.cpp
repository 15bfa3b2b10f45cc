// SPDX-License-Identifier: MIT
// Shapes keep the promises of their headers: counts of facets and vertices come from the definition
// (every supporting plane through three points), in rationals.
#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include "affine_dimension.hpp"
#include "convexact/error.hpp"
#include "polytope_by_definition.hpp"
#include "shapes/makers.hpp"
using namespace convexact;
using namespace convexact::shapes;

namespace {

struct Counts {
  std::size_t vertices, facets;
  friend bool operator==(const Counts&, const Counts&) = default;
};

Counts counts(const std::vector<Point>& points) {
  const Polytope polytope = polytope_by_definition(PointSet(points));
  return {polytope.vertices.size(), polytope.planes.size()};
}

doctest::String toString(const Counts& c) {
  return doctest::toString(c.vertices) + " vertices, " + doctest::toString(c.facets) + " facets";
}

bool all_squared_norms_are_near_one(const std::vector<Point>& points) {
  for (const Point& p : points) {
    if (std::abs(p.squaredNorm() - 1) > 1e-15) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("on_circle: axes and diagonals are exact, mirrored angles are mirrored") {
  CHECK(on_circle(0, 4).cosine == 1);
  CHECK(on_circle(1, 4).cosine == 0);
  CHECK(on_circle(1, 4).sine == 1);
  CHECK(on_circle(2, 4).cosine == -1);
  CHECK(on_circle(3, 4).sine == -1);
  CHECK(on_circle(1, 8).cosine == std::sqrt(0.5));
  CHECK(on_circle(1, 8).sine == std::sqrt(0.5));
  CHECK(on_circle(1, 6).cosine == 0.5);
  CHECK(on_circle(7, 6).cosine == 0.5);  // around once
  // Both numbers times a power of two: the same angle. The words of GMP may have 32 bits.
  constexpr std::uint64_t kScale = std::uint64_t{1} << 33;
  for (const std::uint64_t k : {1, 2, 3, 4}) {
    CHECK(on_circle(k * kScale, 5 * kScale).cosine == on_circle(k, 5).cosine);
    CHECK(on_circle(k * kScale, 5 * kScale).sine == on_circle(k, 5).sine);
  }
  for (const std::uint64_t n : {3u, 7u, 12u, 1000u}) {
    for (std::uint64_t k = 0; k < n; ++k) {
      CAPTURE(n);
      CAPTURE(k);
      const CirclePoint p = on_circle(k, n), mirrored = on_circle(n - k, n);
      CHECK(mirrored.cosine == p.cosine);
      CHECK(mirrored.sine == -p.sine);
      // Correctly rounded, so within one unit in the last place of any good library.
      const double angle = 2 * std::acos(-1.0) * static_cast<double>(k) / static_cast<double>(n);
      CHECK(std::abs(p.cosine - std::cos(angle)) < 1e-14);
      CHECK(std::abs(p.sine - std::sin(angle)) < 1e-14);
    }
  }
}

TEST_CASE("regular solids: Euler's counts, pentagons exactly plane") {
  CHECK(counts(tetrahedron()) == Counts{4, 4});
  CHECK(counts(cube()) == Counts{8, 6});
  CHECK(counts(octahedron()) == Counts{6, 8});
  CHECK(counts(dodecahedron()) == Counts{20, 12});
  CHECK(counts(icosahedron()) == Counts{12, 20});
  const Counts broken = counts(rounded_dodecahedron());
  CHECK(broken.vertices == 20);
  CHECK(broken.facets > 12);
}

TEST_CASE("dodecahedron and icosahedron: regular up to the promised rounding") {
  // Edges: 2 h = 2/golden for the dodecahedron, 2 for the icosahedron; each is the least distance.
  const auto shortest_and_next = [](const std::vector<Point>& points, std::size_t edges) {
    std::vector<double> lengths;
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) lengths.push_back((points[i] - points[j]).norm());
    }
    std::sort(lengths.begin(), lengths.end());
    return std::array{lengths.front(), lengths[edges - 1], lengths[edges]};
  };
  const auto dodecahedron_edges = shortest_and_next(dodecahedron(), 30);
  CHECK(std::abs(dodecahedron_edges[0] - (std::sqrt(5) - 1)) < 0x1p-24);
  CHECK(std::abs(dodecahedron_edges[1] - (std::sqrt(5) - 1)) < 0x1p-24);
  CHECK(dodecahedron_edges[2] > 1.9);
  const auto icosahedron_edges = shortest_and_next(icosahedron(), 30);
  CHECK(std::abs(icosahedron_edges[0] - 2) < 1e-15);
  CHECK(std::abs(icosahedron_edges[1] - 2) < 1e-15);
  CHECK(icosahedron_edges[2] > 3);
}

TEST_CASE("prisms: closed-form counts, k-gons and rectangles exactly plane") {
  for (const std::uint32_t k : {3u, 4u, 5u, 8u, 11u}) {
    CAPTURE(k);
    CHECK(counts(prism(k)) == Counts{2 * k, k + 2});
    CHECK(counts(antiprism(k)) == Counts{2 * k, 2 * k + 2});
    CHECK(counts(pyramid(k)) == Counts{k + 1, k + 1});
    CHECK(counts(bipyramid(k)) == Counts{k + 2, 2 * k});
  }
  CHECK(cylinder(7, 4).size() == 28);
  CHECK(counts(cylinder(7, 4)) == Counts{14, 9});
  CHECK(cone(7, 4).size() == 29);
  CHECK(counts(cone(7, 4)) == Counts{8, 8});
  CHECK_THROWS_AS((void)prism(2), Error);
  CHECK_THROWS_AS((void)cone(5, 51), Error);
}

TEST_CASE("polygons of high valence are strictly convex") {
  for (const std::uint32_t k : {1000u, 100000u}) {
    const std::vector<Point> points = pyramid(k);
    std::size_t left_turns = 0;
    for (std::uint32_t i = 0; i < k; ++i) {
      const RationalPoint a = to_rational(points[i]), b = to_rational(points[(i + 1) % k]),
                          c = to_rational(points[(i + 2) % k]);
      const RationalVector3 u = b - a, v = c - b;
      if (u[0] * v[1] - u[1] * v[0] > 0) ++left_turns;
    }
    CHECK(left_turns == k);  // and the corners go around once, so every corner is extreme
  }
}

TEST_CASE("boxes: closed-form counts") {
  CHECK(counts(box({1, 2, 3})) == Counts{8, 6});
  CHECK(counts(chamfered_box({1, 1, 1}, 0.25)) == Counts{24, 26});
  CHECK(counts(chamfered_box({1, 2, 4}, 0.5)) == Counts{24, 26});
  CHECK(rounded_box({1, 2, 3}, 0.5, 4).size() == 8 * 21);
  // One segment: 6 sides, 12 rectangles, 8 triangles.
  CHECK(counts(rounded_box({1, 2, 3}, 0.5, 1)) == Counts{24, 26});
  for (std::uint32_t corners = 0; corners <= 8; ++corners) {
    CAPTURE(corners);
    CHECK(counts(cut_cube(corners, 0.25)) == Counts{8 + 2 * corners, 6 + corners});
  }
  CHECK(counts(cut_cube(8, 0.5)) == Counts{12, 14});  // cuboctahedron
  CHECK(grid(3).size() == 27);
  CHECK(counts(grid(3)) == Counts{8, 6});
  CHECK_THROWS_AS((void)cut_cube(9, 0.25), Error);
  CHECK_THROWS_AS((void)cut_cube(1, 0.75), Error);
  CHECK_THROWS_AS((void)chamfered_box({1, 1, 1}, 1), Error);
}

TEST_CASE("rounded_box: sides and edge rectangles are exactly plane at any segment count") {
  const std::uint32_t segments = 2;
  const std::vector<Point> points = rounded_box({1, 1, 1}, 0.25, segments);
  const Polytope polytope = polytope_by_definition(PointSet(points));
  CHECK(polytope.vertices.size() == points.size());
  std::size_t sides = 0, rectangles = 0;
  for (const Halfspace& plane : polytope.planes) {
    const auto zeros = (plane.normal().array() == 0).count();
    sides += zeros == 2 ? 1 : 0;
    rectangles += zeros == 1 ? 1 : 0;  // parallel to exactly one axis
  }
  CHECK(sides == 6);
  CHECK(rectangles == 12 * segments);
}

TEST_CASE("random points: inside what they name") {
  for (const Point& p : in_box(1000, 3)) CHECK((p.array() >= -1 && p.array() < 1).all());
  for (const Point& p : in_ball(1000, 3)) CHECK(p.squaredNorm() <= 1);
  CHECK(all_squared_norms_are_near_one(on_sphere(1000, 3)));
  CHECK(all_squared_norms_are_near_one(fibonacci_sphere(1000)));
  for (const Point& p : lattice(1000, 3, 3)) {
    CHECK(p == p.array().round().matrix());
    CHECK(p.cwiseAbs().maxCoeff() <= 3);
  }
  CHECK(counts(fibonacci_sphere(30)).vertices == 30);
}

TEST_CASE("random points: pinned to the bit, so the same on every platform") {
  // From the definition: coordinates 2 (draw >> 11) 2^-53 - 1 of the standard's mt19937_64.
  std::mt19937_64 random(42);
  for (const Point& p : in_box(50, 42)) {
    for (int k = 0; k < 3; ++k) {
      CHECK(p[k] == std::ldexp(static_cast<double>(random() >> 11), -52) - 1);
    }
  }
  CHECK(on_sphere(20, 1) == on_sphere(20, 1));
  CHECK(on_sphere(20, 1) != on_sphere(20, 2));
}

TEST_CASE("symmetric solids: every image is there, exactly") {
  const auto contains = [](const std::vector<Point>& points, const Point& p) {
    return std::find(points.begin(), points.end(), p) != points.end();
  };
  const std::vector<Point> central = centrally_symmetric(10, 5);
  for (const Point& p : central) CHECK(contains(central, -p));
  const std::vector<Point> cubic = cube_symmetric(2, 100, 5);
  CHECK(cubic.size() == 96);
  for (const Point& p : cubic) {
    CHECK(contains(cubic, {p[1], p[0], p[2]}));
    CHECK(contains(cubic, {p[1], p[2], p[0]}));
    CHECK(contains(cubic, {-p[0], p[1], p[2]}));
  }
}

TEST_CASE("extreme shapes: as thin, far, small and large as they say") {
  for (const double aspect : {1e8, 1e16, 1e30}) {
    CAPTURE(aspect);
    const std::vector<Point> thin = needle(20, aspect, 1), flat = slab(20, aspect, 1);
    CHECK(affine_dimension(thin) == 3);
    CHECK(affine_dimension(flat) == 3);
    for (const Point& p : thin) CHECK(std::max(std::abs(p[1]), std::abs(p[2])) <= 1 / aspect);
    for (const Point& p : flat) CHECK(std::abs(p[2]) <= 1 / aspect);
  }
  for (const Point& p : offset_ball(20, 1e8, 1)) {
    CHECK((p.array() - 1e8).abs().maxCoeff() <= 1);
  }
  const std::vector<Point> ball = in_ball(20, 1), scaled = scaled_ball(20, -300, 1);
  for (std::size_t i = 0; i < ball.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      CHECK(to_rational(scaled[i][k]) == scale_by_power_of_two(to_rational(ball[i][k]), -300));
    }
  }
  const std::vector<Point> integers = lattice(30, 100, 1);
  for (std::size_t k = 0; k < integers.size(); ++k) {
    CHECK(to_rational(subnormal(30, 100, 1)[k]) ==
          RationalPoint(to_rational(integers[k]) * scale_by_power_of_two(Rational(1), -1074)));
  }
  for (const Point& p : subnormal(30, 100, 1)) {
    CHECK(p.cwiseAbs().maxCoeff() < std::numeric_limits<double>::min());
  }
  CHECK(affine_dimension(subnormal(30, 100, 1)) == 3);
  for (const Point& p : huge(20, 1)) CHECK(p.allFinite());
  CHECK(affine_dimension(wide_exponents(20, 300, 1)) == 3);
}

TEST_CASE("nearly plane points: off the plane, by no more than one rounding") {
  const std::vector<Point> flat = nearly_flat(20, 1);
  CHECK(affine_dimension(flat) == 3);
  for (const Point& p : flat) CHECK((p[2] == 1 || p[2] == std::nextafter(1.0, 2.0)));
  const std::vector<Point> lid = nearly_coplanar(40, 1);
  std::size_t off = 0;
  for (std::size_t i = 0; i + 1 < lid.size(); ++i) {
    const RationalPoint p = to_rational(lid[i]);
    const Rational error = p[2] - (p[0] + p[1]) / 3;
    CHECK(abs(error) <= to_rational(0x1p-53));
    off += error != 0 ? 1 : 0;
  }
  CHECK(off > 20);
}

TEST_CASE("nearly flat: as many ulps above the plane as asked for") {
  for (const std::uint64_t ulps : {1u, 3u, 1000u}) {
    const double above = std::bit_cast<double>(std::bit_cast<std::uint64_t>(1.0) + ulps);
    const std::vector<Point> points = nearly_flat(20, 1, ulps);
    for (std::size_t i = 0; i < points.size(); ++i) CHECK(points[i][2] == (i % 2 ? above : 1));
  }
  CHECK_THROWS_AS((void)nearly_flat(20, 1, 0), Error);
}

TEST_CASE("cospherical: integers of exactly that squared length, all extreme") {
  for (const std::uint32_t square : {9u, 41u, 89u}) {
    CAPTURE(square);
    const std::vector<Point> points = cospherical(18, square, 3);
    CHECK(points.size() == 18);
    for (const Point& p : points) {
      CHECK(p == p.array().round().matrix());
      CHECK(p.squaredNorm() == square);
    }
    CHECK(counts(points).vertices == 18);  // so no repeats either
  }
  // 41 = 16 + 16 + 9 (24 points), 36 + 4 + 1 (48), 25 + 16 + 0 (24).
  CHECK(cospherical(1000, 41, 1).size() == 96);
  CHECK(cospherical(1000, 1, 1).size() == 6);
  CHECK_THROWS_AS((void)cospherical(20, 7, 1), Error);  // no three squares sum to 7
}

TEST_CASE("moment curve: the cyclic polytope's counts by Gale's evenness") {
  for (const std::uint32_t n : {4u, 5u, 12u, 19u}) {
    CAPTURE(n);
    CHECK(counts(moment_curve(n)) == Counts{n, 2 * n - 4});
  }
  CHECK_THROWS_AS((void)moment_curve(3), Error);
}

TEST_CASE("repeated sphere: every point as often as asked for") {
  const std::vector<Point> points = repeated_sphere(7, 3, 1);
  CHECK(points.size() == 21);
  for (const Point& p : points) CHECK(std::count(points.begin(), points.end(), p) == 3);
}

TEST_CASE("flat shapes: the affine dimension is exact") {
  for (const std::uint64_t seed : {1u, 2u}) {
    CHECK(affine_dimension(all_equal(7)) == 0);
    CHECK(affine_dimension(collinear(50, seed)) == 1);
    CHECK(affine_dimension(coplanar(50, seed)) == 2);
  }
  CHECK(affine_dimension(coplanar(2, 1)) == 1);
  CHECK(affine_dimension(std::vector<Point>{}) == -1);
}
