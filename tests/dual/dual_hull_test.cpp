// SPDX-License-Identifier: MIT
// The dual hull, read off a primal hull and computed from halfspaces, and the way back. Truth is
// the definition (tests/support/definitional_dual.hpp) and, for cubes, written out by hand.
#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "convexact/dual.hpp"
#include "convexact/error.hpp"
#include "halfspace_arrangement.hpp"
#include "integer_halfspace.hpp"
#include "shapes/makers.hpp"
#include "simplify_points.hpp"

using namespace convexact;

namespace {

std::vector<Halfspace> unit_cube() {
  return {halfspace(1, 0, 0, -1), halfspace(-1, 0, 0, 0), halfspace(0, 1, 0, -1),
          halfspace(0, -1, 0, 0), halfspace(0, 0, 1, -1), halfspace(0, 0, -1, 0)};
}

const RationalPoint kMiddle = RationalPoint::Constant(Rational(1, 2));

std::set<RationalPoint, definition::PointOrder> as_set(const std::vector<RationalPoint>& points) {
  return {points.begin(), points.end()};
}

// What is promised of any dual hull, and its agreement with the definition.
void check_dual(const DualHull& dual, const DualHull& expected) {
  REQUIRE(dual.halfspaces == expected.halfspaces);
  CHECK(as_set(dual.vertices) == as_set(expected.vertices));
  CHECK(dual.vertices.size() == expected.vertices.size());
  CHECK(dual.triangles.size() == 2 * dual.halfspaces.size() - 4);
  AdjacencyMatrix matrix(dual.halfspaces.size());
  for (const DualTriangle& t : dual.triangles) matrix.add(t);
  CHECK(matrix.is_closed_manifold());
  const auto vertices = as_set(expected.vertices);
  for (const auto& [a, b, c] : dual.triangles) {
    const Halfspace &p = dual.halfspaces[a.index()], &q = dual.halfspaces[b.index()],
                    &r = dual.halfspaces[c.index()];
    REQUIRE(p.normal().dot(q.normal().cross(r.normal())) > 0);
    CHECK(vertices.count(meet(p, q, r)) == 1);
  }
  for (std::size_t i = 0; i < dual.halfspaces.size(); ++i) {
    CHECK(dual.halfspaces[i](dual.vertices.at(dual.witness[i])) == 0);
  }
}

void check_points(const std::vector<Point>& doubles) {
  const PointSet points(doubles);
  const HullOutcome outcome = convex_hull(points);
  const DualHull expected = dual_of_doubles(doubles);
  check_dual(dual_of(std::get<Hull>(outcome), points), expected);
  // The same solid given as halfspaces, shuffled by reversal.
  std::vector<Halfspace> reversed = expected.halfspaces;
  std::reverse(reversed.begin(), reversed.end());
  const HalfspaceDual again = dual_of(reversed, center_of(expected));
  check_dual(again.dual, expected);
  CHECK(again.redundant.empty());
  for (std::size_t i = 0; i < again.rows.size(); ++i) {
    CHECK(again.rows[i] == reversed.size() - 1 - i);
  }
}

}  // namespace

TEST_CASE("dual_of: hulls of points agree with the definition") {
  check_points(shapes::tetrahedron());
  check_points(shapes::cube());
  check_points(shapes::icosahedron());
  check_points(shapes::dodecahedron());
  check_points(shapes::cut_cube(1, 0.5));
  check_points(shapes::pyramid(12));
  check_points(shapes::prism(9));
  check_points(shapes::grid(3));
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    CAPTURE(seed);
    check_points(shapes::lattice(14, 2, seed));
    check_points(shapes::in_ball(12, seed));
  }
}

TEST_CASE("dual_of: rows of the input that are redundant") {
  std::vector<Halfspace> rows = unit_cube();
  rows.push_back(halfspace(2, 0, 0, -2));   // 6: x <= 1 again
  rows.push_back(halfspace(0, 1, 0, -3));   // 7: y <= 3
  rows.push_back(halfspace(1, 1, 0, -2));   // 8: touches an edge
  rows.push_back(halfspace(1, 1, 1, -3));   // 9: touches a vertex
  rows.push_back(halfspace(1, 1, 1, -9));   // 10: far away, and weaker than 9
  rows.push_back(halfspace(1, -1, 0, -9));  // 11: far away
  rows.push_back(halfspace(0, 1, 0, -3));   // 12: y <= 3 again
  const HalfspaceDual result = dual_of(rows, kMiddle);
  CHECK(result.dual.halfspaces.size() == 6);
  CHECK(result.dual.vertices.size() == 8);
  CHECK(result.redundant == std::vector<std::size_t>{6, 7, 8, 9, 10, 11, 12});
  for (std::size_t i = 0; i < 6; ++i) CHECK(rows[result.rows[i]] == result.dual.halfspaces[i]);
}

TEST_CASE("dual_of: unbounded halfspaces and a bad center are refused") {
  std::vector<Halfspace> rows = unit_cube();
  CHECK_THROWS_AS((void)dual_of(rows, RationalPoint::Zero()), Error);  // on three planes
  rows.pop_back();                                                     // open below
  CHECK_THROWS_WITH_AS((void)dual_of(rows, kMiddle), doctest::Contains("unbounded"), Error);
  rows.erase(rows.begin() + 4, rows.end());  // a tube: its dual points lie in a plane
  CHECK_THROWS_WITH_AS((void)dual_of(rows, kMiddle), doctest::Contains("unbounded"), Error);
  CHECK_THROWS_WITH_AS((void)dual_of(std::vector<Halfspace>(), kMiddle),
                       doctest::Contains("unbounded"), Error);
}

TEST_CASE("to_polytope: there and back again") {
  const DualHull octahedron = dual_of_doubles(shapes::octahedron());
  const Polytope solid = to_polytope(octahedron.halfspaces, octahedron.triangles);
  // Each vertex of the octahedron is two dual triangles; they merge.
  CHECK(solid.vertices.size() == 6);
  CHECK(solid.planes == octahedron.halfspaces);
  for (std::size_t f = 0; f < solid.facets.size(); ++f) {
    REQUIRE(solid.facets[f].size() == 3);
    const auto& corners = solid.facets[f];
    CHECK(Halfspace::through(solid.vertices[corners[0]], solid.vertices[corners[1]],
                             solid.vertices[corners[2]]) == solid.planes[f]);
  }
}

TEST_CASE("to_polytope: the polytope of a hull, whatever the dual's triangulation") {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    CAPTURE(seed);
    const DualHull dual = dual_of_doubles(shapes::lattice(20, 2, seed));
    const Polytope solid = to_polytope(dual.halfspaces, dual.triangles);
    CHECK(as_set(solid.vertices) == as_set(dual.vertices));
    CHECK(solid.vertices.size() == dual.vertices.size());
    CHECK(solid.planes == dual.halfspaces);
    std::size_t corner_count = 0;
    for (std::size_t f = 0; f < solid.facets.size(); ++f) {
      const auto& corners = solid.facets[f];
      corner_count += corners.size();
      const RationalVector3 normal = solid.planes[f].normal().cast<Rational>();
      for (std::size_t c = 0; c < corners.size(); ++c) {
        const RationalPoint &u = solid.vertices[corners[c]],
                            &v = solid.vertices[corners[(c + 1) % corners.size()]],
                            &w = solid.vertices[corners[(c + 2) % corners.size()]];
        CHECK(solid.planes[f](u) == 0);
        CHECK(normal.dot(RationalVector3(v - u).cross(RationalVector3(w - v))) > 0);
      }
    }
    // Euler: V - E + F = 2, and every edge has two facets.
    CHECK(solid.vertices.size() + solid.facets.size() == corner_count / 2 + 2);
  }
}
