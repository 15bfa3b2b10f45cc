// SPDX-License-Identifier: MIT
// The hull of points. Expected values: closed forms, the definition, and its certificate.
#include "convexact/hull/hull.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <set>

#include "convexact/number/random.hpp"
#include "hull_by_definition.hpp"
#include "property.hpp"

using namespace convexact;

namespace {

/// The hull, checked against its certificate; the same for several orders of insertion.
Hull checked_hull(const PointSet& points) {
  const HullOutcome outcome = convex_hull(points);
  REQUIRE(std::holds_alternative<Hull>(outcome));
  const Hull& hull = std::get<Hull>(outcome);
  CHECK(check_hull(hull, points));
  for (const std::uint64_t seed : {1u, 2u}) {
    const Hull other = std::get<Hull>(convex_hull(points, {seed, 0}));
    CHECK(check_hull(other, points));
    CHECK(other.vertices == hull.vertices);
    CHECK(facet_halfspaces(other, points) == facet_halfspaces(hull, points));
  }
  return hull;
}

std::set<Halfspace> facets_of(const Hull& hull, const PointSet& points) {
  const auto list = facet_halfspaces(hull, points);
  return {list.begin(), list.end()};
}

std::vector<Point> grid(int nx, int ny, int nz) {
  std::vector<Point> points;
  for (int x = 0; x < nx; ++x)
    for (int y = 0; y < ny; ++y)
      for (int z = 0; z < nz; ++z) points.emplace_back(x, y, z);
  return points;
}

}  // namespace

TEST_CASE("convex_hull: a grid has the eight corners and six facets of its box") {
  for (const int n : {2, 3, 5, 8}) {
    const PointSet points(grid(n, n + 1, n));
    const Hull hull = checked_hull(points);
    CHECK(hull.vertices.size() == 8);
    CHECK(hull.facets.size() == 6);
    CHECK(hull.facets.corner_count() == 24);
  }
}

TEST_CASE("convex_hull: small lattice points agree with the definition") {
  check_property("facets by definition", [](const std::vector<std::array<std::int8_t, 3>>& raw) {
    std::vector<Point> list;
    for (const auto& r : raw)
      if (list.size() < 20) list.emplace_back(r[0] % 3, r[1] % 3, r[2] % 3);
    const PointSet points(list);
    const HullOutcome outcome = convex_hull(points);
    if (const auto* flat = std::get_if<FlatInput>(&outcome)) {
      RC_ASSERT(check_flat(*flat, points));
      return;
    }
    const Hull& hull = std::get<Hull>(outcome);
    RC_ASSERT(check_hull(hull, points));
    RC_ASSERT(facets_of(hull, points) == facets_by_definition(points));
  });
}

TEST_CASE("convex_hull: random points agree with the definition") {
  Random random(7);
  for (const std::size_t n : {4u, 5u, 8u, 16u, 30u}) {
    std::vector<Point> list;
    for (std::size_t i = 0; i < n; ++i)
      list.emplace_back(uniform_unit(random), uniform_unit(random), uniform_unit(random));
    const PointSet points(list);
    CHECK(facets_of(checked_hull(points), points) == facets_by_definition(points));
  }
}
