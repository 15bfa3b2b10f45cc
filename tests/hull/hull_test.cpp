// SPDX-License-Identifier: MIT
// The hull of points that span a volume. Expected values: closed forms and the definition.
#include "convexact/hull.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>

#include "checked_hull.hpp"
#include "property.hpp"
#include "shapes/makers.hpp"
#include "supporting_planes.hpp"

using namespace convexact;

namespace {

// The facets by definition, in canonical order, against those of the hull.
bool has_defined_facets(const Hull& hull, const PointSet& points) {
  std::vector<RationalPoint> list;
  for (std::size_t i = 0; i < points.size(); ++i) list.push_back(points[PointId(i)]);
  const Polytope polytope = to_polytope(hull, points);
  for (std::size_t f = 0; f < polytope.planes.size(); ++f) {
    for (const std::uint32_t v : polytope.facets[f])
      if (polytope.planes[f](polytope.vertices[v]) != 0) return false;
  }
  return polytope.planes == supporting_planes(list);
}

}  // namespace

TEST_CASE("convex_hull: a grid has the eight corners and six facets of its box") {
  for (const std::uint32_t n : {2u, 3u, 5u, 10u}) {
    const PointSet points(shapes::grid(n));
    const Hull hull = checked_hull(points);
    CHECK(hull.vertices.size() == 8);
    CHECK(hull.facets.size() == 6);
    CHECK(hull.facets.corner_count() == 24);
    CHECK(hull.certificate.inside.size() == points.size() - 8);
  }
}

TEST_CASE("convex_hull: prisms, antiprisms, pyramids and bipyramids by their closed forms") {
  for (const std::uint32_t k : {3u, 4u, 5u, 8u, 100u}) {
    CAPTURE(k);
    const Hull prism = checked_hull(PointSet(shapes::prism(k)));
    CHECK(prism.vertices.size() == 2 * k);
    CHECK(prism.facets.size() == k + 2);
    CHECK(prism.facets.corner_count() == 6 * k);
    CHECK(checked_hull(PointSet(shapes::antiprism(k))).facets.size() == 2 * k + 2);
    CHECK(checked_hull(PointSet(shapes::pyramid(k))).facets.corner_count() == 4 * k);
    CHECK(checked_hull(PointSet(shapes::bipyramid(k))).facets.corner_count() == 6 * k);
  }
}

TEST_CASE("convex_hull: points on straight edges are not vertices") {
  const Hull cylinder = checked_hull(PointSet(shapes::cylinder(30, 4)));
  CHECK(cylinder.vertices.size() == 60);
  CHECK(cylinder.facets.size() == 32);
  const Hull cone = checked_hull(PointSet(shapes::cone(30, 4)));
  CHECK(cone.vertices.size() == 31);
  CHECK(cone.facets.size() == 31);
}

TEST_CASE("convex_hull: facets start at their lowest corner and stand in its order") {
  const PointSet points(shapes::cut_cube(5, 0.25));
  const Hull hull = checked_hull(points);
  CHECK(hull.facets.size() == 11);
  for (std::size_t f = 0; f < hull.facets.size(); ++f) {
    CHECK(*std::ranges::min_element(hull.facets[f]) == hull.facets[f][0]);
    if (f > 0) CHECK(std::ranges::lexicographical_compare(hull.facets[f - 1], hull.facets[f]));
  }
}

TEST_CASE("convex_hull: small lattices agree with the definition") {
  for (const std::uint64_t range : {1u, 2u, 3u}) {
    for (std::uint32_t seed = 1; seed <= 40; ++seed) {
      CAPTURE(range);
      CAPTURE(seed);
      const PointSet points(shapes::lattice(4 + seed % 17, range, seed));
      const HullOutcome outcome = convex_hull(points);
      if (const auto* flat = std::get_if<FlatInput>(&outcome)) {
        CHECK(check_flat(*flat, points));
      } else {
        CHECK(check_hull(std::get<Hull>(outcome), points));
        CHECK(has_defined_facets(std::get<Hull>(outcome), points));
      }
    }
  }
}

TEST_CASE("convex_hull: random and symmetric points agree with the definition") {
  for (const std::uint32_t n : {4u, 5u, 9u, 24u}) {
    CAPTURE(n);
    for (const auto& list :
         {shapes::in_box(n, 7), shapes::on_sphere(n, 3), shapes::centrally_symmetric(n, 5)}) {
      const PointSet points(list);
      CHECK(has_defined_facets(checked_hull(points), points));
    }
  }
}

TEST_CASE("convex_hull: rationals that are no doubles") {
  check_property("rationals", [](const std::vector<std::array<std::int8_t, 3>>& raw) {
    std::vector<RationalPoint> list;
    for (const auto& r : raw)
      if (list.size() < 14)
        list.emplace_back(Rational(r[0] % 4, 3), Rational(r[1] % 4, 7), Rational(r[2] % 4, 10));
    const PointSet points(list);
    const HullOutcome outcome = convex_hull(points);
    if (const auto* flat = std::get_if<FlatInput>(&outcome)) {
      RC_ASSERT(check_flat(*flat, points));
      return;
    }
    RC_ASSERT(check_hull(std::get<Hull>(outcome), points));
    RC_ASSERT(has_defined_facets(std::get<Hull>(outcome), points));
  });
}

TEST_CASE("convex_hull: the same hull and proofs for any number of threads") {
  std::vector<Point> points = shapes::in_ball(40000, 5);
  points.insert(points.end(), points.begin(), points.begin() + 3000);  // repeated
  const PointSet set(points);
  const Hull alone = checked_hull(set);
  for (const std::size_t jobs : {2u, 3u, 8u}) {
    CAPTURE(jobs);
    const Hull made = std::get<Hull>(convex_hull(set, {.jobs = jobs}));
    CHECK(made.vertices == alone.vertices);
    REQUIRE(made.facets.size() == alone.facets.size());
    for (std::size_t f = 0; f < made.facets.size(); ++f) {
      CHECK(std::ranges::equal(made.facets[f], alone.facets[f]));
    }
    const auto& proofs = made.certificate.inside;
    REQUIRE(proofs.size() == alone.certificate.inside.size());
    for (std::size_t k = 0; k < proofs.size(); ++k) {
      CHECK(proofs[k].point == alone.certificate.inside[k].point);
      CHECK(proofs[k].triangle == alone.certificate.inside[k].triangle);
    }
    std::atomic<bool> stop = true;
    CHECK_THROWS_AS((void)convex_hull(set, {.jobs = jobs, .watch = &stop}), Error);
  }
  CHECK_THROWS_AS((void)convex_hull(set, {.jobs = 0}), Error);
}
