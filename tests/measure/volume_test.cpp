// SPDX-License-Identifier: MIT
// Volumes. Expected values: closed forms, and tetrahedra over a fan of each facet (the definition).
#include <doctest/doctest.h>

#include "convexact/measure.hpp"
#include "moved_polytope.hpp"
#include "number/arithmetic.hpp"
#include "polytope_by_definition.hpp"
#include "property.hpp"
#include "shapes/makers.hpp"
using namespace convexact;

namespace {

// Signed tetrahedra from the origin over a fan of each facet: det(a, b, c) / 6.
Rational volume_by_tetrahedra(const Polytope& polytope) {
  Rational sum = 0;
  for (const std::vector<std::uint32_t>& corners : polytope.facets) {
    const RationalPoint& a = polytope.vertices[corners[0]];
    for (std::size_t i = 2; i < corners.size(); ++i) {
      const RationalPoint &b = polytope.vertices[corners[i - 1]],
                          &c = polytope.vertices[corners[i]];
      sum += a.dot(b.cross(c)) / 6;
    }
  }
  return sum;
}

bool narrow(const Enclosure& x, const Rational& exact, long bits) {
  return x.contains(exact) && x.width() <= scale_by_power_of_two(exact, -bits);
}

}  // namespace

TEST_CASE("volume: closed forms") {
  CHECK(volume(solid(shapes::cube())) == 8);
  CHECK(volume(solid(shapes::box({1, 2, 3}))) == 48);
  CHECK(volume(solid(shapes::tetrahedron())) == Rational(8, 3));
  CHECK(volume(solid(shapes::octahedron())) == Rational(4, 3));
  CHECK(volume(solid({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}})) == Rational(1, 6));
  CHECK(volume(solid(shapes::prism(4))) == 2);                 // square of area 2
  CHECK(volume(solid(shapes::pyramid(4))) == Rational(2, 3));  // a third of it
  // A corner cut at depth t takes t^3 / 6.
  CHECK(volume(solid(shapes::cut_cube(8, 0.25))) == 1 - 8 * Rational(1, 384));
  CHECK(volume(solid(shapes::cut_cube(8, 0.5))) == Rational(5, 6));
}

TEST_CASE("volume: equals the tetrahedra over a fan of each facet") {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    CAPTURE(seed);
    for (const auto& points :
         {shapes::in_ball(20, seed), shapes::lattice(20, 3, seed), shapes::needle(15, 1e30, seed),
          shapes::offset_ball(15, 1e8, seed), shapes::subnormal(15, 100, seed),
          shapes::huge(15, seed), shapes::nearly_flat(15, seed)}) {
      const Polytope polytope = solid(points);
      const Rational exact = volume(polytope);
      CHECK(exact > 0);
      CHECK(exact == volume_by_tetrahedra(polytope));
      // Two roundings per factor, one per product, at most 40 for the sum: below 2^6 units.
      CHECK(narrow(enclose_volume(polytope, 64), exact, 57));
    }
  }
}

TEST_CASE("volume: scales with the cube, does not move with the solid or the order of its lists") {
  check_property("metamorphic", [](std::uint16_t seed, std::int8_t k) {
    const Polytope polytope = solid(shapes::in_box(8, seed));
    const Rational v = volume(polytope);
    RC_ASSERT(volume(scaled(polytope, k)) == scale_by_power_of_two(v, 3 * k));
    RC_ASSERT(volume(translated(polytope, {Rational(k, 7), 1000, -3})) == v);
    RC_ASSERT(volume(shuffled(polytope, seed)) == v);
  });
}

TEST_CASE("balanced_sum: none, one, an odd number, many denominators") {
  CHECK(balanced_sum({}) == 0);
  CHECK(balanced_sum({Rational(2, 3)}) == Rational(2, 3));
  for (const int n : {2, 3, 7, 64, 1001}) {
    CAPTURE(n);
    std::vector<Rational> terms;  // 1/(i (i + 1)) telescopes to n/(n + 1)
    for (int i = 1; i <= n; ++i) terms.emplace_back(1, i * (i + 1));
    CHECK(balanced_sum(terms) == Rational(n, n + 1));
  }
}
