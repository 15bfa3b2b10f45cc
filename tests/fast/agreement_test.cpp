// SPDX-License-Identifier: MIT
// The filtered engine removes what the exact engine removes, at the same costs, with the same ties.

#include "perturb.hpp"
#include "same_run.hpp"
#include "shapes/makers.hpp"

using namespace convexact;

TEST_CASE("simplify_filtered: regular solids in doubles") {
  check_same_run(shapes::tetrahedron());
  check_same_run(shapes::cube());
  check_same_run(shapes::octahedron());
  check_same_run(shapes::dodecahedron());
  check_same_run(shapes::rounded_dodecahedron());
  check_same_run(shapes::icosahedron());
}

TEST_CASE("simplify_filtered: boxes, where inner diagonals are parallel edges") {
  for (std::uint32_t corners = 0; corners <= 8; ++corners) {
    CAPTURE(corners);
    check_same_run(shapes::cut_cube(corners, 0.125));
    check_same_run(shapes::cut_cube(corners, 0.3));
  }
  check_same_run(shapes::chamfered_box({1, 2, 3}, 0.25));
  check_same_run(shapes::rounded_box({1, 1, 2}, 0.25, 3));
  check_same_run(shapes::grid(3));
}

TEST_CASE("simplify_filtered: prisms, antiprisms, pyramids and bipyramids") {
  for (std::uint32_t k = 3; k <= 24; k += k < 10 ? 1 : 7) {
    CAPTURE(k);
    check_same_run(shapes::prism(k));
    check_same_run(shapes::antiprism(k));
    check_same_run(shapes::pyramid(k));
    check_same_run(shapes::bipyramid(k));
  }
  check_same_run(shapes::cylinder(16, 3));
  check_same_run(shapes::cone(16, 3));
}

TEST_CASE("simplify_filtered: random points on small lattices") {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    CAPTURE(seed);
    check_same_run(shapes::lattice(6 + static_cast<std::uint32_t>(seed % 20), 1 + seed % 4, seed));
  }
}

TEST_CASE("simplify_filtered: symmetric solids tie exactly") {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    CAPTURE(seed);
    check_same_run(shapes::centrally_symmetric(4 + static_cast<std::uint32_t>(seed % 8), seed));
    check_same_run(shapes::cube_symmetric(1, 2 + seed % 3, seed));
  }
}

TEST_CASE("simplify_filtered: extreme shapes and sizes") {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    CAPTURE(seed);
    check_same_run(shapes::needle(24, 1e12, seed));
    check_same_run(shapes::slab(24, 1e12, seed));
    check_same_run(shapes::offset_ball(24, 1e8, seed));
    check_same_run(shapes::scaled_ball(24, 300, seed));
    check_same_run(shapes::scaled_ball(24, -300, seed));
    check_same_run(shapes::subnormal(16, 7, seed));
    check_same_run(shapes::huge(16, seed));
    check_same_run(shapes::wide_exponents(16, 300, seed));
    check_same_run(shapes::nearly_flat(16, seed));
    check_same_run(shapes::nearly_coplanar(16, seed));
  }
}

TEST_CASE("simplify_filtered: round shapes") {
  check_same_run(shapes::fibonacci_sphere(60));
  check_same_run(shapes::on_sphere(60, 3));
  check_same_run(shapes::in_ball(100, 4));
  check_same_run(shapes::in_box(100, 5));
}

TEST_CASE(
    "simplify_filtered: a cap that is exact before its lower end is raised hides no stale one") {
  // A lattice solid in a skew slab: doubles enclose no cap of it. When the lower end of the first
  // in the queue was raised to a known exact cost, the next one was removed unseen.
  check_same_run(perturb::turned(perturb::stretched(shapes::lattice(12, 1, 6), {0, 0, -40})));
}

TEST_CASE("simplify_filtered: the same steps for any number of threads that look at all caps") {
  const PointSet points(shapes::on_sphere(5000, 7));
  const Hull hull = std::get<Hull>(convex_hull(points));
  for (const auto cost : {CostMeasure::Volume, CostMeasure::Area, CostMeasure::MeanWidth}) {
    SimplifyOptions options{.faces = 8000, .cost = cost};
    const auto run = [&](std::size_t jobs) {
      options.jobs = jobs;
      const FastDual dual = FastDual::of(hull, points);
      return simplify_filtered(dual, options);
    };
    const FastResult alone = run(1);
    for (const std::size_t jobs : {2u, 3u, 8u}) {
      CAPTURE(jobs);
      const FastResult made = run(jobs);
      REQUIRE(made.steps.size() == alone.steps.size());
      for (std::size_t k = 0; k < made.steps.size(); ++k) {
        CHECK(made.steps[k].removed == alone.steps[k].removed);
        CHECK(made.steps[k].cost_lower == alone.steps[k].cost_lower);
        CHECK(made.steps[k].cost_upper == alone.steps[k].cost_upper);
      }
      CHECK(made.survivors == alone.survivors);
      CHECK(made.counts.evaluations == alone.counts.evaluations);
      CHECK(made.counts.signs.filtered == alone.counts.signs.filtered);
      CHECK(made.counts.signs.exact == alone.counts.signs.exact);
    }
  }
}
