// SPDX-License-Identifier: MIT
// The float engine ends on everything, with bounded solids; where costs are clearly apart it
// agrees.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "convexact/fast/float_engine.hpp"
#include "convexact/shapes/families.hpp"
#include "convexact/shapes/random_points.hpp"
#include "exact_determinant.hpp"

using namespace convexact;

namespace {

// By the definition: closed and every triangle of the dual seen from the center in the right
// orientation, so the center is inside the dual hull. D is independent of the center.
void check_bounded(const FastDual& dual, const FastResult& result) {
  REQUIRE(result.triangles.size() == 2 * result.survivors.size() - 4);
  std::vector<std::array<std::uint32_t, 2>> edges;
  for (const DualTriangle& t : result.triangles) {
    std::vector<std::vector<Rational>> rows;
    for (int c = 0; c < 3; ++c) {
      const Halfspace& h = dual.exact(t[c]);
      rows.push_back({Rational(h.normal()[0]), Rational(h.normal()[1]), Rational(h.normal()[2])});
      CHECK(std::binary_search(result.survivors.begin(), result.survivors.end(), t[c]));
      edges.push_back({t[c].value, t[(c + 1) % 3].value});
    }
    CHECK(exact_determinant(rows) > 0);
  }
  std::sort(edges.begin(), edges.end());
  CHECK(std::adjacent_find(edges.begin(), edges.end()) == edges.end());
  for (const auto& [a, b] : edges) {
    CHECK(std::binary_search(edges.begin(), edges.end(), std::array<std::uint32_t, 2>{b, a}));
  }
}

}  // namespace

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
      CHECK(result.survivors.size() + result.steps.size() == dual.size());
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
