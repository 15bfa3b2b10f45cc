// SPDX-License-Identifier: MIT
// Rays against solids. Expected values: closed forms for the cube and the octahedron; for random
// solids the definition: the ends of a line in a solid are among the points where it crosses a
// plane, so the least and the greatest of those that satisfy every facet.
#include <doctest/doctest.h>

#include <algorithm>

#include "convexact/query.hpp"
#include "expect_error.hpp"
#include "moved_polytope.hpp"
#include "query_solids.hpp"
#include "shapes/makers.hpp"
using namespace convexact;
using support::cube_of;
using support::grid_solid;

namespace {

using Ids = std::vector<HalfspaceId>;

// The facets whose normals are these, ascending.
Ids facets_of(const Polytope& solid, const std::vector<IntegerVector3>& normals) {
  Ids ids;
  for (std::size_t f = 0; f < solid.planes.size(); ++f) {
    for (const IntegerVector3& n : normals) {
      if (same_direction(solid.planes[f], Halfspace(n, Integer(0)))) ids.emplace_back(f);
    }
  }
  CHECK(ids.size() == normals.size());
  return ids;
}

RayAnswer checked(const Polytope& solid, const Ray& ray) {
  RayAnswer answer = cast_ray(solid, ray);
  CHECK(check(solid, ray, answer));
  return answer;
}

struct Expected {
  Rational entry, exit;
  std::vector<IntegerVector3> entry_normals, exit_normals;
};

void check_line(const Polytope& solid, const Ray& ray, const Expected& expected) {
  const RayAnswer answer = checked(solid, ray);
  REQUIRE(answer.line);
  CHECK(answer.line->entry == expected.entry);
  CHECK(answer.line->exit == expected.exit);
  CHECK(answer.line->entry_facets == facets_of(solid, expected.entry_normals));
  CHECK(answer.line->exit_facets == facets_of(solid, expected.exit_normals));
  CHECK(answer.is_hit() == (expected.exit >= 0));
  if (answer.is_hit()) CHECK(answer.first() == std::max(Rational(0), expected.entry));
}

RationalPoint at(const Ray& ray, const Rational& t) { return ray.origin + t * ray.direction; }

bool holds(const Polytope& solid, const RationalPoint& x) {
  return std::all_of(solid.planes.begin(), solid.planes.end(),
                     [&](const Halfspace& plane) { return plane(x) <= 0; });
}

// Every t at which the line crosses a plane inside of the solid.
std::vector<Rational> crossings(const Polytope& solid, const Ray& ray) {
  std::vector<Rational> found;
  for (const Halfspace& plane : solid.planes) {
    const Rational here = plane(ray.origin), slope = plane(at(ray, 1)) - here;
    if (slope == 0) continue;
    const Rational t = -here / slope;
    if (holds(solid, at(ray, t))) found.push_back(t);
  }
  return found;
}

const IntegerVector3 kX(1, 0, 0), kY(0, 1, 0), kZ(0, 0, 1);
const IntegerVector3 kLeft(-1, 0, 0), kFront(0, -1, 0), kBottom(0, 0, -1);

}  // namespace

TEST_CASE("rays: through the facets of a cube, from outside, inside, the border and behind") {
  const Polytope cube = cube_of(1);
  check_line(cube, {{-3, 0, 0}, {1, 0, 0}}, {2, 4, {kLeft}, {kX}});
  check_line(cube, {{-3, 0, 0}, {4, 0, 0}}, {Rational(1, 2), 1, {kLeft}, {kX}});
  check_line(cube, {{0, Rational(1, 3), 0}, {0, 0, -3}},
             {Rational(-1, 3), Rational(1, 3), {kZ}, {kBottom}});
  check_line(cube, {{-1, 0, 0}, {1, 0, 0}}, {0, 2, {kLeft}, {kX}});
  check_line(cube, {{1, 0, 0}, {1, 0, 0}}, {-2, 0, {kLeft}, {kX}});
  // Behind the origin: the facet of the exit excludes the ray.
  const RayAnswer behind = checked(cube, {{5, 0, 0}, {1, 0, 0}});
  CHECK_FALSE(behind.is_hit());
  CHECK(behind.missed == facets_of(cube, {kX}));
  REQUIRE(behind.line);
  CHECK(behind.line->exit == -4);
}

TEST_CASE("rays: through vertices and edges of a cube, and in the planes of its facets") {
  const Polytope cube = cube_of(1);
  check_line(cube, {{-3, -3, -3}, {1, 1, 1}}, {2, 4, {kLeft, kFront, kBottom}, {kX, kY, kZ}});
  check_line(cube, {{-2, -2, 0}, {1, 1, 0}}, {1, 3, {kLeft, kFront}, {kX, kY}});
  // In a facet's plane; along an edge; both without crossing those planes.
  check_line(cube, {{-3, 1, 0}, {1, 0, 0}}, {2, 4, {kLeft}, {kX}});
  check_line(cube, {{-3, 1, -1}, {1, 0, 0}}, {2, 4, {kLeft}, {kX}});
  // Parallel to a facet and beyond its plane, be it by the least.
  const Rational just_beyond = 1 + scale_by_power_of_two(Rational(1), -1074);
  const RayAnswer beside = checked(cube, {{-3, just_beyond, 0}, {1, 0, 0}});
  CHECK_FALSE(beside.is_hit());
  CHECK_FALSE(beside.line);
  CHECK(beside.missed == facets_of(cube, {kY}));
  // Touching an edge from outside, and a vertex.
  check_line(cube, {{0, 2, 0}, {1, -1, 0}}, {1, 1, {kY}, {kX}});
  check_line(cube, {{2, 2, -1}, {-1, -1, 2}}, {1, 1, {kX, kY}, {kZ}});
  // Past it.
  const RayAnswer past = checked(cube, {{0, 2 + Rational(1, 1000), 0}, {1, -1, 0}});
  CHECK_FALSE(past.line);
  CHECK(past.missed.size() == 2);
}

TEST_CASE("rays: an octahedron in any direction from its center, and at its vertices") {
  const Polytope octahedron = solid(shapes::octahedron());
  for (const Point& direction : shapes::lattice(40, 3, 2)) {
    const RationalVector3 u = to_rational(direction);
    const Rational norm = u.cwiseAbs().sum();
    if (norm == 0) continue;
    const RayAnswer answer = checked(octahedron, {RationalPoint(0, 0, 0), u});
    REQUIRE(answer.line);
    CHECK(answer.line->exit == 1 / norm);
    CHECK(answer.line->entry == -1 / norm);
    CHECK(answer.first() == 0);
  }
  check_line(octahedron, {{1, -2, 0}, {0, 1, 0}},
             {2, 2, {{1, -1, 1}, {1, -1, -1}}, {{1, 1, 1}, {1, 1, -1}}});
  check_line(octahedron, {{3, 0, 0}, {-1, 0, 0}},
             {2,
              4,
              {{1, 1, 1}, {1, 1, -1}, {1, -1, 1}, {1, -1, -1}},
              {{-1, 1, 1}, {-1, 1, -1}, {-1, -1, 1}, {-1, -1, -1}}});
}

TEST_CASE("rays: many rays of a grid against many solids, by the definition") {
  Random random(3);
  int hits = 0, misses = 0, touches = 0, behind = 0;
  const auto entry = [&](int reach) {
    return static_cast<int>(uniform_below(random, 2 * reach + 1)) - reach;
  };
  for (int round = 0; round < 40; ++round) {
    const Polytope solid = grid_solid(random, 4 + round % 6, 2, 1);
    for (int k = 0; k < 25; ++k) {
      Ray ray{RationalPoint(entry(4), entry(4), entry(4)),
              RationalVector3(entry(3), entry(3), entry(3))};
      if (ray.direction.isZero(0)) continue;
      ray.direction /= Rational(1 + k % 3);
      const RayAnswer answer = checked(solid, ray);
      const std::vector<Rational> ends = crossings(solid, ray);
      REQUIRE(answer.line.has_value() == !ends.empty());
      if (ends.empty()) {
        ++misses;
        continue;
      }
      CHECK(answer.line->entry == *std::min_element(ends.begin(), ends.end()));
      CHECK(answer.line->exit == *std::max_element(ends.begin(), ends.end()));
      CHECK(answer.is_hit() == (answer.line->exit >= 0));
      hits += answer.is_hit();
      behind += !answer.is_hit();
      touches += answer.line->entry == answer.line->exit;
    }
  }
  CHECK(hits > 50);
  CHECK(misses > 50);
  CHECK(touches > 5);
  CHECK(behind > 20);
}

TEST_CASE("rays: t grows with the scale of the solid and shrinks with that of the direction") {
  const Polytope solid = support::box_between({-1, 0, 2}, {3, 4, 7});
  const Ray ray{{-9, Rational(1, 3), 1}, {4, Rational(1, 7), 1}};
  const RayAnswer answer = checked(solid, ray);
  REQUIRE(answer.is_hit());
  for (const long k : {-1000L, -1L, 800L}) {
    Ray far{ray.origin, ray.direction};
    for (int i = 0; i < 3; ++i) far.origin[i] = scale_by_power_of_two(ray.origin[i], k);
    const RayAnswer scaled_answer = checked(scaled(solid, k), far);
    CHECK(scaled_answer.line->entry == scale_by_power_of_two(answer.line->entry, k));
    CHECK(scaled_answer.line->exit == scale_by_power_of_two(answer.line->exit, k));
    for (int i = 0; i < 3; ++i) far.direction[i] = scale_by_power_of_two(ray.direction[i], k);
    CHECK(checked(scaled(solid, k), far).line->exit == answer.line->exit);
  }
}

TEST_CASE("rays: a zero direction is refused; a claim that is not true fails its check") {
  const Polytope cube = cube_of(1);
  CHECK(error_of([&] {
          return cast_ray(cube, {{0, 0, 0}, {0, 0, 0}});
        }).code() == ErrorCode::InvalidArgument);
  const Ray ray{{-3, 0, 0}, {1, 0, 0}};
  const RayAnswer right = checked(cube, ray);
  const auto refused = [&](const auto& change) {
    RayAnswer wrong = right;
    change(wrong);
    CHECK_FALSE(check(cube, ray, wrong));
  };
  refused([](RayAnswer& a) { a.line->entry = Rational(5, 2); });
  refused([](RayAnswer& a) { a.line->exit = 5; });
  refused([](RayAnswer& a) { std::swap(a.line->entry, a.line->exit); });
  refused([](RayAnswer& a) { a.line->entry_facets = a.line->exit_facets; });
  refused([](RayAnswer& a) { a.line->exit_facets.emplace_back(5u); });
  refused([](RayAnswer& a) { a.line.reset(); });
  refused([](RayAnswer& a) { a.missed = a.line->exit_facets; });
  refused([](RayAnswer& a) { a.missed = {HalfspaceId(77)}; });
  refused([](RayAnswer& a) {
    a.missed = {HalfspaceId(0), HalfspaceId(1)};
    a.line.reset();
  });
}

TEST_CASE("rays: a miss is not proven by facets whose planes the ray touches at one point") {
  const Polytope cube = cube_of(1);
  const struct {
    Ray ray;
    std::vector<IntegerVector3> entries, exits;  // at t = 1
  } touching[] = {
      {{{0, 2, 0}, {1, -1, 0}}, {{0, 1, 0}}, {{1, 0, 0}}},                   // an edge
      {{{2, 0, 0}, {-1, 0, 1}}, {{1, 0, 0}}, {{0, 0, 1}}},                   // another one
      {{{0, 2, 2}, {1, -1, -1}}, {{0, 1, 0}, {0, 0, 1}}, {{1, 0, 0}}},       // a vertex
      {{{-2, -2, 0}, {1, 1, -1}}, {{-1, 0, 0}, {0, -1, 0}}, {{0, 0, -1}}}};  // another one
  for (const auto& [ray, entries, exits] : touching) {
    const RayAnswer right = checked(cube, ray);
    CHECK(right.is_hit());
    CHECK(right.first() == 1);
    for (const HalfspaceId entry : facets_of(cube, entries)) {
      for (const HalfspaceId exit : facets_of(cube, exits)) {
        for (const Ids& missed : {Ids{entry, exit}, Ids{exit, entry}, Ids{entry}, Ids{exit}}) {
          CHECK_FALSE(check(cube, ray, {{}, missed}));
          CHECK_FALSE(check(cube, ray, {right.line, missed}));
        }
      }
    }
    // The same two facets prove the miss of a ray beside.
    Ray beside = ray;
    beside.origin *= Rational(1001, 1000);
    CHECK_FALSE(checked(cube, beside).is_hit());
  }
}
