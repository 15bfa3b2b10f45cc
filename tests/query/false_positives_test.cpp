// SPDX-License-Identifier: MIT
// Random probes. Expected values: closed forms of areas, mean widths and volumes; each decision of
// a hit by the definition in rationals.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "convexact/query.hpp"
#include "moved_polytope.hpp"
#include "query/probed_solid.hpp"
#include "query_solids.hpp"
#include "shapes/makers.hpp"
using namespace convexact;
using support::box_between;
using support::cube_of;
using support::grid_solid;

namespace {

constexpr double kPi = std::numbers::pi;

struct Measures {
  double area, mean_width, volume;
};

void check_tally(const ProbeTally& tally, double of_a, double of_b, double of_ball) {
  const double expected = 1 - of_a / of_b, share = of_b / of_ball;
  const auto n = static_cast<double>(tally.samples), hits = static_cast<double>(tally.hits_b);
  CHECK(tally.only_a == 0);
  CHECK(tally.hits_a + tally.only_b == tally.hits_b);
  REQUIRE(tally.prediction);
  CHECK(tally.prediction->low_double() == doctest::Approx(expected).epsilon(1e-12));
  CHECK(tally.prediction->high_double() == doctest::Approx(expected).epsilon(1e-12));
  CHECK(tally.expected_b.high_double() == doctest::Approx(n * share).epsilon(1e-12));
  CHECK(std::abs(hits - n * share) <= 4 * std::sqrt(n * share * (1 - share)));
  const double sigma = std::sqrt(expected * (1 - expected) / hits);
  REQUIRE(tally.sigma());
  CHECK(*tally.sigma() == doctest::Approx(sigma));
  CHECK(std::abs(*tally.rate() - expected) <= 4 * sigma);
}

void check_rates(const Polytope& a, const Polytope& b, const Measures& of_a, const Measures& of_b,
                 double radius) {
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
    CAPTURE(seed);
    const FalsePositives found =
        count_false_positives(a, b, {.lines = 4000, .planes = 4000, .points = 4000, .seed = seed});
    CHECK_FALSE(found.outside);
    CHECK(to_double(found.radius, Rounding::Nearest) == doctest::Approx(radius).epsilon(1e-12));
    check_tally(*found.lines, of_a.area, of_b.area, 4 * kPi * radius * radius);
    check_tally(*found.planes, of_a.mean_width, of_b.mean_width, 2 * radius);
    check_tally(*found.points, of_a.volume, of_b.volume, 4 * kPi / 3 * radius * radius * radius);
  }
}

bool same_tally(const ProbeTally& a, const ProbeTally& b) {
  return a.samples == b.samples && a.hits_a == b.hits_a && a.hits_b == b.hits_b &&
         a.only_a == b.only_a && a.only_b == b.only_b;
}

bool same_counts(const FalsePositives& a, const FalsePositives& b) {
  return same_tally(*a.lines, *b.lines) && same_tally(*a.planes, *b.planes) &&
         same_tally(*a.points, *b.points);
}

// A cube in [-2, 2]^3 and a box around it.
const Measures kCube{24, 3, 8};

}  // namespace

TEST_CASE("false positives: a cube in a cube twice as large") {
  check_rates(cube_of(1), cube_of(2), kCube, {96, 6, 64}, std::sqrt(12.0));
}

TEST_CASE("false positives: an octahedron in a cube, a cube in a box far from the origin") {
  // Edges sqrt(2), 12 of them, exterior angles acos(1/3).
  const Measures octahedron{4 * std::sqrt(3.0),
                            12 * std::sqrt(2.0) * std::acos(1.0 / 3) / (4 * kPi), 4.0 / 3};
  check_rates(solid(shapes::octahedron()), cube_of(1), octahedron, kCube, std::sqrt(3.0));
  // The mean width of a box is half the sum of its edges.
  const Polytope box = box_between({999, 1999, 2999}, {1003, 2001, 3005});
  const Polytope inner = box_between({1000, 1999, 3000}, {1002, 2001, 3002});
  check_rates(inner, box, kCube, {2 * (4 * 2 + 4 * 6 + 2 * 6), 6, 48}, std::sqrt(14.0));
}

TEST_CASE("false positives: equal solids have none, and the prediction holds 0") {
  const Polytope solid = cube_of(3);
  const FalsePositives found = count_false_positives(solid, solid);
  for (const auto& tally : {found.lines, found.planes, found.points}) {
    CHECK(tally->only_b == 0);
    CHECK(*tally->rate() == 0);
    CHECK(tally->prediction->contains(0));
    CHECK(tally->prediction->high_double() < 1e-30);
  }
}

TEST_CASE("false positives: a solid that is not inside has a witness and no prediction") {
  const Polytope a = box_between({0, 0, 0}, {2, 1, 1}), b = box_between({0, 0, 0}, {1, 1, 1});
  const FalsePositives found = count_false_positives(a, b);
  REQUIRE(found.outside);
  CHECK(b.planes[found.outside->facet.index()](a.vertices[found.outside->vertex]) > 0);
  CHECK(a.vertices[found.outside->vertex][0] == 2);
  CHECK_FALSE(found.points->prediction);
  CHECK_FALSE(found.points->sigma());
  CHECK(found.points->only_a > 0);
  CHECK(found.points->only_b == 0);
  // The least that a vertex can escape.
  const double after_one = 1 + 0x1p-52;
  CHECK(count_false_positives(box_between({0, 0, 0}, {after_one, 1, 1}), b).outside);
  CHECK_FALSE(count_false_positives(b, a).outside);
}

TEST_CASE("false positives: a solid larger or smaller by far less than doubles tell") {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const Polytope b = solid(shapes::on_sphere(12, seed));
    for (const int side : {1, -1}) {
      Polytope a = b;
      const Rational factor = 1 + side * scale_by_power_of_two(Rational(1), -90);
      for (RationalPoint& v : a.vertices) v *= factor;
      for (Halfspace& plane : a.planes) {
        plane = Halfspace(RationalVector3(plane.normal().cast<Rational>()),
                          Rational(plane.offset()) * factor);
      }
      const FalsePositives found =
          count_false_positives(a, b, {.lines = 0, .planes = 0, .points = 1});
      REQUIRE(found.outside.has_value() == (side == 1));
      if (side < 0) continue;
      // Of the first vertex, as each is outside; the first facet by the definition.
      CHECK(found.outside->vertex == 0);
      std::size_t first = 0;
      while (b.planes[first](a.vertices[0]) <= 0) ++first;
      CHECK(found.outside->facet == HalfspaceId(first));
    }
  }
}

TEST_CASE("false positives: scale, place and other kinds of probes change no count; seeds do") {
  Random random(8);
  const Polytope a = solid(shapes::on_sphere(20, 4)), b = cube_of(1);
  const FalsePositives found = count_false_positives(a, b, {.seed = 6});
  for (const long k : {-900L, 1L, 700L}) {
    CHECK(same_counts(found, count_false_positives(scaled(a, k), scaled(b, k), {.seed = 6})));
  }
  const RationalVector3 by(Rational(1, 3), -1000000, Rational(7, 11));
  CHECK(
      same_counts(found, count_false_positives(translated(a, by), translated(b, by), {.seed = 6})));
  const FalsePositives fewer =
      count_false_positives(a, b, {.lines = 0, .planes = 1000, .points = 10, .seed = 6});
  CHECK_FALSE(fewer.lines);
  CHECK(same_tally(*fewer.planes, *found.planes));
  CHECK(fewer.points->samples == 10);
  CHECK_FALSE(same_counts(found, count_false_positives(a, b, {.seed = 7})));
}

TEST_CASE("false positives: hits of points, lines and planes, by the definition") {
  Random random(21);
  // Multiples of 1/16 in [-1/2, 1/2]: on facets, along edges and through vertices, too.
  const auto coordinate = [&] { return (static_cast<double>(uniform_below(random, 17)) - 8) / 16; };
  const auto point = [&] { return Point(coordinate(), coordinate(), coordinate()); };
  const ProbeFrame frame;  // the identity
  std::size_t left_open = 0, hits = 0, probes = 0;
  for (int round = 0; round < 30; ++round) {
    Polytope small = grid_solid(random, 4 + round % 5, 3, 1);
    const Polytope solid = scaled(small, -4);
    const ProbedSolid probed(solid, frame);
    const auto holds = [&](const RationalPoint& x) {
      return std::all_of(solid.planes.begin(), solid.planes.end(),
                         [&](const Halfspace& plane) { return plane(x) <= 0; });
    };
    for (int k = 0; k < 60; ++k) {
      const Point p = k % 4 == 0 ? Point(to_double(solid.vertices[0][0], Rounding::Nearest),
                                         to_double(solid.vertices[0][1], Rounding::Nearest),
                                         to_double(solid.vertices[0][2], Rounding::Nearest))
                                 : point();
      CHECK(probed.is_hit(p) == holds(to_rational(p)));
      const Point q = point();
      const RationalPoint exact_p = to_rational(p);
      const RationalVector3 u = to_rational(q) - exact_p;
      if (!u.isZero(0)) {
        // A line that meets a bounded solid crosses a plane inside of it.
        bool meets = false;
        for (const Halfspace& plane : solid.planes) {
          const Rational here = plane(exact_p), slope = plane(to_rational(q)) - here;
          if (slope != 0 && holds(exact_p - here / slope * u)) meets = true;
        }
        CHECK(probed.is_hit(ProbeLine{p, q}) == meets);
        hits += meets;
        ++probes;
      }
      const double offset = coordinate();
      bool above = false, below = false;
      for (const RationalPoint& v : solid.vertices) {
        const Rational value = to_rational(q).dot(v) - to_rational(offset);
        above = above || value >= 0;
        below = below || value <= 0;
      }
      CHECK(probed.is_hit(ProbePlane{q, offset}) == (above && below));
    }
    left_open += probed.exact_decisions();
  }
  CHECK(left_open > 100);  // the degenerate ones
  CHECK(hits > 200);
  CHECK(probes - hits > 200);
}

TEST_CASE("false positives: probes that miss touching by their rounding alone") {
  // Points in facets, lines that touch edges, planes through vertices, each rounded to doubles:
  // what remains of their distance is as large as the errors of doubles, so a bound too small
  // decides some of them wrongly.
  Random random(31);
  const auto unit = [&] { return 2 * uniform_unit(random) - 1; };
  const auto rounded = [](const RationalPoint& x) {
    return Point(to_double(x[0], Rounding::Nearest), to_double(x[1], Rounding::Nearest),
                 to_double(x[2], Rounding::Nearest));
  };
  std::size_t left_open = 0, hits = 0, probes = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    std::vector<Point> points = shapes::on_sphere(12, seed);
    for (Point& p : points) p = 0.95 * p + Point(0.01, 0.02, 0.03);  // |y_k| <= 1
    const Polytope solid = ::solid(points);
    const ProbedSolid probed(solid, ProbeFrame{});
    const auto holds = [&](const RationalPoint& x) {
      return std::all_of(solid.planes.begin(), solid.planes.end(),
                         [&](const Halfspace& plane) { return plane(x) <= 0; });
    };
    for (std::size_t f = 0; f < solid.facets.size(); ++f) {
      const auto corner = [&](std::size_t k) { return solid.vertices[solid.facets[f][k]]; };
      for (int k = 0; k < 40; ++k) {
        const Rational s = to_rational(uniform_unit(random)) / Rational(2),
                       t = to_rational(uniform_unit(random)) / Rational(2);
        const RationalPoint in_facet =
            corner(0) + s * (corner(1) - corner(0)) + t * (corner(2) - corner(0));
        const Point point = rounded(in_facet);
        const bool inside = holds(to_rational(point));
        CHECK(probed.is_hit(point) == inside);
        // A line in the facet's plane, away from its other facets.
        const RationalVector3 along = corner(1) - corner(0);
        const RationalVector3 across = to_rational(unit()) * along + corner(2) - corner(0);
        const RationalPoint on_edge = corner(0) + s * along;
        const ProbeLine line{rounded(on_edge - across / Rational(4)),
                             rounded(on_edge + across / Rational(4))};
        const RationalPoint first = to_rational(line.first);
        const Ray ray{first, to_rational(line.second) - first};
        CHECK(probed.is_hit(line) == cast_ray(solid, ray).line.has_value());
        const Point u = Point(unit(), unit(), unit()).normalized();
        Rational most = to_rational(u).dot(solid.vertices[0]);
        for (const RationalPoint& v : solid.vertices) {
          most = std::max<Rational>(most, to_rational(u).dot(v));
        }
        const double offset = to_double(most, Rounding::Nearest);
        const bool meets = to_rational(offset) <= most;
        CHECK(probed.is_hit(ProbePlane{u, offset}) == meets);
        hits += inside + meets;
        probes += 2;
      }
    }
    left_open += probed.exact_decisions();
  }
  CHECK(left_open > probes / 2);
  CHECK(hits > probes / 5);
  CHECK(hits < probes - probes / 5);
}

TEST_CASE("false positives: doubles decide nearly all probes of common solids") {
  const Polytope a = solid(shapes::on_sphere(20, 4)), b = cube_of(1);
  const FalsePositives found = count_false_positives(a, b);
  CHECK(found.lines->exact + found.planes->exact + found.points->exact == 0);
}
