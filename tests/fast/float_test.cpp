// SPDX-License-Identifier: MIT
// The float engine ends on everything, with bounded solids; where costs are clearly apart it
// agrees.
#include <doctest/doctest.h>

#include <algorithm>
#include <variant>
#include <vector>

#include "check_bounded.hpp"
#include "convexact/io.hpp"
#include "convexact/shapes.hpp"
#include "expect_error.hpp"
#include "fast/engines.hpp"
#include "process.hpp"
#include "shapes/makers.hpp"
#include "simplify_points.hpp"

using namespace convexact;

TEST_CASE("simplify_float: ends with a bounded solid on every family of shapes") {
  for (const shapes::Family& family : shapes::families()) {
    CAPTURE(family.name);
    for (const std::uint64_t seed : {1u, 2u}) {
      const PointSet set(shapes::generate(family, shapes::usual_values(family), seed));
      const HullOutcome outcome = convex_hull(set);
      const Hull* hull = std::get_if<Hull>(&outcome);
      if (hull == nullptr || hull->facets.size() > 3000) continue;
      const FastDual dual = FastDual::of(*hull, set);
      const FastResult result = simplify_float(dual, {.faces = 4});
      CHECK((result.stop == StopReason::AllUnbounded || result.survivors.size() == 4));
      check_bounded(dual, result);
    }
  }
}

TEST_CASE("simplify_float: removes what the filtered engine removes where costs differ clearly") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    const PointSet set(shapes::in_ball(60, seed));
    const Hull hull = std::get<Hull>(convex_hull(set));
    const FastDual dual = FastDual::of(hull, set);
    const FastResult sure = simplify_filtered(dual), quick = simplify_float(dual);
    REQUIRE(sure.steps.size() == quick.steps.size());
    for (std::size_t s = 0; s < sure.steps.size(); ++s) {
      CAPTURE(s);
      REQUIRE(sure.steps[s].removed == quick.steps[s].removed);
      CHECK(quick.steps[s].cost_lower >= sure.steps[s].cost_lower * (1 - 1e-6));
      CHECK(quick.steps[s].cost_upper <= sure.steps[s].cost_upper * (1 + 1e-6));
    }
  }
}

TEST_CASE("simplify_float: exact ties end as they do in exact numbers (#13)") {
  // Mirror images and other symmetries of the axes: doubles see costs that differ by rounding.
  for (const char* name : {"cube-symmetric", "centrally-symmetric", "rounded-box", "cut-cube"}) {
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
      CAPTURE(name);
      CAPTURE(seed);
      const shapes::Family& family = shapes::family(name);
      const PointSet set(shapes::generate(family, shapes::usual_values(family), seed));
      const Hull hull = std::get<Hull>(convex_hull(set));
      const FastDual dual = FastDual::of(hull, set);
      for (const std::size_t faces : {8u, 18u}) {
        const FastResult sure = simplify_filtered(dual, {.faces = faces}),
                         quick = simplify_float(dual, {.faces = faces});
        const bool has_ties = std::any_of(sure.steps.begin(), sure.steps.end(),
                                          [](const FastStep& step) { return step.tied > 1; });
        CHECK((quick.bound->ties > 0) == has_ties);
        CHECK(quick.survivors == sure.survivors);
      }
    }
  }
}

TEST_CASE("simplify_float: ties that no symmetry of the axes explains end likewise") {
  // Affine images: equal volumes stay equal, but the facets are no mirror images of one another.
  const shapes::Family& family = shapes::family("cube-symmetric");
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    CAPTURE(seed);
    std::vector<Point> points;
    for (const Point& p : shapes::generate(family, std::vector<double>{20, 100}, seed)) {
      points.emplace_back(3 * p.x() + p.y(), 5 * p.y() - p.z(),
                          7 * p.z() + 2 * p.x());  // integers: exact
    }
    const PointSet set(points);
    const Hull hull = std::get<Hull>(convex_hull(set));
    const FastDual dual = FastDual::of(hull, set);
    const FastResult sure = simplify_filtered(dual, {.faces = 8}),
                     quick = simplify_float(dual, {.faces = 8});
    CHECK(quick.bound->ties > 0);
    CHECK(quick.survivors == sure.survivors);
  }
}

TEST_CASE("simplify_float: mirror images tie where rounding tells their costs apart") {
  const PointSet set = read_mesh(support::data("teapot.obj")).points;
  const Hull hull = std::get<Hull>(convex_hull(set));
  const FastDual dual = FastDual::of(hull, set);
  for (const std::size_t faces : {6u, 400u, 900u}) {
    CAPTURE(faces);
    const FastResult sure = simplify_filtered(dual, {.faces = faces}),
                     quick = simplify_float(dual, {.faces = faces});
    CHECK(quick.survivors == sure.survivors);
  }
}

TEST_CASE("simplify_float: half-turned caps that differ by the rounding of points are no ties") {
  // Were they, their exact planes would be formed to find the first: half of the time it takes.
  const PointSet set(shapes::fibonacci_sphere(30000));
  const Hull hull = std::get<Hull>(convex_hull(set));
  const FastDual dual = FastDual::of(hull, set);
  const FastResult quick = simplify_float(dual, {.faces = 50000});
  CHECK(quick.steps.size() == 9996);
  CHECK(quick.bound->ties < 1000);
  CHECK(dual.formed() < 1000);
}

TEST_CASE("simplify_float: more ties than it looks at cost it no time (#13)") {
  const PointSet set(shapes::prism(5000));
  const Hull hull = std::get<Hull>(convex_hull(set));
  const FastDual dual = FastDual::of(hull, set);
  CHECK(simplify_float(dual, {.faces = 4500}).steps.size() == 502);
}

TEST_CASE("simplify_float: facets that are coplanar but for rounding do not stop it") {
  // Their dual points are a few roundings apart: doubles cannot tell what vertices there are.
  for (const char* name : {"rounded-dodecahedron", "rounded-box", "nearly-coplanar"}) {
    CAPTURE(name);
    const shapes::Family& family = shapes::family(name);
    const PointSet set(shapes::generate(family, shapes::usual_values(family), 1));
    const Hull hull = std::get<Hull>(convex_hull(set));
    const FastDual dual = FastDual::of(hull, set);
    const FastResult sure = simplify_filtered(dual), quick = simplify_float(dual);
    CHECK(sure.stop == quick.stop);
    CHECK(sure.steps.size() == quick.steps.size());
  }
}

TEST_CASE("simplify_float: a long ring in doubt is not looked at after every removal") {
  // Top and bottom of a prism stay unbounded, and doubles are never certain of it.
  const PointSet set(shapes::prism(1000));
  const Hull hull = std::get<Hull>(convex_hull(set));
  const FastDual dual = FastDual::of(hull, set);
  const FastResult result = simplify_float(dual);
  CHECK(result.survivors.size() == 5);
  // A side is looked at about three times.
  CHECK(2 * result.counts.evaluations < 7 * dual.size());
}

TEST_CASE("simplify_float: a growth limit stops it where the filtered engine stops") {
  const PointSet set(shapes::in_ball(80, 7));
  const Hull hull = std::get<Hull>(convex_hull(set));
  const FastDual dual = FastDual::of(hull, set);
  for (const int percent : {0, 1, 5, 20, 100}) {
    CAPTURE(percent);
    const SimplifyOptions options{.max_growth = Rational(percent, 100)};
    const FastResult sure = simplify_filtered(dual, options), quick = simplify_float(dual, options);
    CHECK(sure.stop == quick.stop);
    CHECK(sure.steps.size() == quick.steps.size());
  }
}

TEST_CASE("simplify_float, simplify_filtered: what makes no sense is refused") {
  const PointSet set(shapes::icosahedron());
  const Hull hull = std::get<Hull>(convex_hull(set));
  const FastDual dual = FastDual::of(hull, set);
  for (const SimplifyOptions& options :
       {SimplifyOptions{.faces = 3}, SimplifyOptions{.max_growth = Rational(-1)}}) {
    CHECK(error_of([&] { return simplify_float(dual, options); }).code() ==
          ErrorCode::InvalidArgument);
    CHECK(error_of([&] { return simplify_filtered(dual, options); }).code() ==
          ErrorCode::InvalidArgument);
  }
}

TEST_CASE("FastDual: the center is strictly inside, or there is no dual") {
  const DualHull solid = dual_of_doubles(shapes::cube());
  CHECK(FastDual::of(solid, center_of(solid)).size() == 6);
  for (const double x : {1.0, 0x1.0000000000001p0, 2.0, 1e300}) {  // on the boundary and beyond
    CAPTURE(x);
    const RationalPoint center(to_rational(x), Rational(0), Rational(0));
    CHECK(error_of([&] { return FastDual::of(solid, center); }).code() ==
          ErrorCode::InvalidArgument);
  }
}
