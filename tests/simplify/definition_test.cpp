// SPDX-License-Identifier: MIT
// The exact engine against the definition: at every step the halfspaces are intersected from
// scratch for every candidate, without duality (tests/support/definitional_greedy.hpp).
#include <doctest/doctest.h>

#include "definitional_dual.hpp"
#include "definitional_greedy.hpp"
#include "shapes/makers.hpp"
#include "simplify/exact_engine.hpp"
#include "simplify_points.hpp"
#include "sweep.hpp"

using namespace convexact;

namespace {

// Down to the end, with everything verified.
void check(const std::vector<Point>& points) {
  const Run result = simplify_points(points, {.verify = VerifyLevel::Full});
  definition::check_against_definition(result);
}

}  // namespace

TEST_CASE("simplify_exact: regular solids in doubles") {
  check(shapes::tetrahedron());
  check(shapes::cube());
  check(shapes::octahedron());
  check(shapes::dodecahedron());
  check(shapes::icosahedron());
}

TEST_CASE("simplify_exact: cubes with cut corners tie exactly") {
  for (std::uint32_t corners = 0; corners <= 8; ++corners) {
    for (const double depth : {0.125, 0.3, 0.5}) {
      CAPTURE(corners);
      CAPTURE(depth);
      check(shapes::cut_cube(corners, depth));
    }
  }
}

TEST_CASE("simplify_exact: boxes with flat edges") {
  check(shapes::chamfered_box({1, 1, 1}, 0.25));
  check(shapes::chamfered_box({1, 2, 3}, 0.1));
}

TEST_CASE("simplify_exact: prisms, antiprisms, pyramids and bipyramids") {
  for (const std::uint32_t k : {3u, 4u, 5u, 6u, 7u, 8u, 10u, 12u}) {
    CAPTURE(k);
    check(shapes::prism(k));
    check(shapes::pyramid(k));
    if (k <= 8) check(shapes::antiprism(k));
    if (k <= 8) check(shapes::bipyramid(k));
  }
}

TEST_CASE("simplify_exact: random lattice points") {
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    CAPTURE(seed);
    check(shapes::lattice(8 + static_cast<std::uint32_t>(seed % 9), 1 + seed % 3, seed));
  }
}

TEST_CASE("simplify_exact: points in boxes with exact ties" * sweep) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    CAPTURE(seed);
    check(shapes::centrally_symmetric(4 + static_cast<std::uint32_t>(seed % 3), seed));
  }
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    CAPTURE(seed);
    check(shapes::cube_symmetric(1, 2, seed));
  }
}
