// SPDX-License-Identifier: MIT
// The worked example of docs/construction.md, number by number: the unit cube without the corner at
// (1, 1, 1), cut where x + y + z = 5/2. Every value is in closed form there.
#include <doctest/doctest.h>

#include "convexact/dual.hpp"
#include "definitional_greedy.hpp"
#include "expect_error.hpp"
#include "integer_halfspace.hpp"
#include "matrix_table.hpp"
#include "simplify/cap.hpp"
#include "simplify/exact_engine.hpp"
#include "simplify/replay.hpp"

using namespace convexact;

namespace {

const RationalPoint kCenter = RationalPoint::Constant(Rational(1, 2));

// In canonical order: -x, -y, -z, then z, y, x, and last the cut.
const std::vector<Halfspace> kHalfspaces = {
    halfspace(-1, 0, 0, 0), halfspace(0, -1, 0, 0), halfspace(0, 0, -1, 0), halfspace(0, 0, 1, -1),
    halfspace(0, 1, 0, -1), halfspace(1, 0, 0, -1), halfspace(2, 2, 2, -5)};

DualHull solid() { return dual_of(kHalfspaces, kCenter).dual; }

std::vector<std::uint32_t> values(const std::vector<HalfspaceId>& ids) {
  std::vector<std::uint32_t> v;
  for (const HalfspaceId id : ids) v.push_back(id.value);
  return v;
}

}  // namespace

TEST_CASE("worked example: ids are positions in canonical order") {
  CHECK(solid().halfspaces == kHalfspaces);
  CHECK(std::is_sorted(kHalfspaces.begin(), kHalfspaces.end()));
}

TEST_CASE("worked example: dual points") {
  // A side is at distance 1/2: its dual point is 2 n. The cut: w = 5 - 3 = 2, so (2, 2, 2)/2.
  for (std::size_t i = 0; i < 6; ++i) {
    const DualPoint side = polar(kHalfspaces[i], kCenter);
    CHECK(side.n == IntegerVector3(kHalfspaces[i].normal() * Integer(2)));
    CHECK(side.w == 1);
  }
  const DualPoint cut = polar(kHalfspaces[6], kCenter);
  CHECK(cut.n == IntegerVector3(1, 1, 1));
  CHECK(cut.w == 1);
}

TEST_CASE("worked example: ten dual triangles are ten vertices") {
  const DualHull cube = solid();
  CHECK(cube.triangles.size() == 10);
  CHECK(cube.vertices.size() == 10);
  const Polytope polytope = to_polytope(cube.halfspaces, cube.triangles);
  CHECK(polytope.vertices.size() == 10);
  CHECK(polytope.facets.size() == 7);
  CHECK(definition::HalfspaceArrangement(kHalfspaces).volume(0x7f) == Rational(47, 48));
}

TEST_CASE("worked example: the adjacency matrix") {
  const DualHull cube = solid();
  AdjacencyMatrix matrix(7);
  for (const DualTriangle& t : cube.triangles) matrix.add(t);
  CHECK(matrix.is_closed_manifold());
  CHECK(table_of(matrix) ==
        ". 3 1 4 2 . .\n"
        "2 . 5 0 . 3 .\n"
        "4 0 . . 5 1 .\n"
        "1 5 . . 0 6 4\n"
        "3 . 0 6 . 2 5\n"
        ". 2 4 1 6 . 3\n"
        ". . . 5 3 4 .\n");
  CHECK(values(matrix.one_ring(HalfspaceId(6))) == std::vector<std::uint32_t>{3, 5, 4});
}

TEST_CASE("worked example: removing the cut") {
  std::vector<DualPoint> points;
  for (const Halfspace& h : kHalfspaces) points.push_back(polar(h, kCenter));
  const std::vector<HalfspaceId> ring = {HalfspaceId(3), HalfspaceId(5), HalfspaceId(4)};
  Random random(1);
  const RingTriangulation roof = triangulate_ring(points, ring, random);
  REQUIRE(roof.triangles.size() == 1);
  CHECK(roof.triangles[0] == DualTriangle{ring[0], ring[1], ring[2]});
  // The dual plane (1, 1, 1).p = 2, the polar of the corner (1, 1, 1) = c + (1, 1, 1)/2.
  CHECK(roof.planes[0].x == IntegerVector3(1, 1, 1));
  CHECK(roof.planes[0].d == 2);
  CHECK(polar(roof.planes[0], kCenter) == RationalPoint::Constant(Rational(1)));
  CHECK(height(roof.planes[0], points[6]) == 1);  // 3 - 2: the cut lies beyond
  CHECK(roof.is_bounded());
  // The cap: a corner tetrahedron with legs 1/2, so 1/6 (1/2)^3 = 1/48.
  std::vector<DualPlane> base;
  for (std::size_t t = 0; t < 3; ++t) {
    base.push_back(
        plane_through(points[6], points[ring[t].index()], points[ring[(t + 1) % 3].index()]));
  }
  CHECK(polar(base[0], kCenter) == RationalPoint(Rational(1), Rational(1, 2), Rational(1)));
  CHECK(polar(base[1], kCenter) == RationalPoint(Rational(1), Rational(1), Rational(1, 2)));
  CHECK(polar(base[2], kCenter) == RationalPoint(Rational(1, 2), Rational(1), Rational(1)));
  const Cap cap = make_cap(ring, base, roof);
  CHECK(cap.vertices.size() == 4);
  CHECK(cap.sides.size() == 3);
  CHECK(volume(cap) == Rational(1, 48));
}

TEST_CASE("worked example: the run") {
  const Run run = simplify_exact(solid(), kCenter, {.verify = VerifyLevel::Full});
  REQUIRE(run.steps.size() >= 1);
  const Step& first = run.steps[0];
  CHECK(first.removed == HalfspaceId(6));
  CHECK(first.cost == Rational(1, 48));
  CHECK(values(first.tie) == std::vector<std::uint32_t>{6});
  CHECK(values(first.ring) == std::vector<std::uint32_t>{3, 5, 4});
  CHECK(first.left == 6);
  // Without the cut it is a cube: nothing but its sides bounds it, and they come in parallels.
  CHECK(run.steps.size() == 1);
  CHECK(run.stop == StopReason::AllUnbounded);
  CHECK(run.triangles.size() == 8);
  CHECK(values(survivors(run)) == std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5});
  CHECK(values(survivors(run, 0)) == std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 6});
}

TEST_CASE("worked example: the other removals, from the definition") {
  // Without x <= 1 the cut alone bounds x: the solid is then 0 <= x <= 5/2 - y - z over the unit
  // square, of volume 5/2 - 1/2 - 1/2 = 3/2, so the cap takes 3/2 - 47/48 = 25/48.
  const definition::HalfspaceArrangement arrangement(kHalfspaces);
  for (const unsigned upper : {3u, 4u, 5u}) {
    CHECK(arrangement.volume(0x7f & ~(1u << upper)) == Rational(3, 2));
  }
  for (const unsigned lower : {0u, 1u, 2u}) {
    CHECK_FALSE(arrangement.is_bounded(0x7f & ~(1u << lower)));
  }
}

TEST_CASE("worked example: replaying a removal that leaves it unbounded is refused") {
  const Run cut = replay(solid(), kCenter, std::vector{HalfspaceId(6)});
  CHECK(cut.steps.at(0).cost == Rational(1, 48));
  const Error error = error_of([] {
    return replay(solid(), kCenter, std::vector{HalfspaceId(6), HalfspaceId(0)});
  });
  CHECK(error.code() == ErrorCode::InvalidArgument);
  CHECK(std::string(error.what()).find("step 2") != std::string::npos);
}
