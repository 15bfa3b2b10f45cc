// SPDX-License-Identifier: MIT
// The surface is judged by what it stands for: the solid that its halfspaces bound, whose volume
// and facets come from the definition (tests/support/halfspace_arrangement.hpp).
#include "simplify/dual_surface.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "convexact/error.hpp"
#include "convexact/measure.hpp"
#include "halfspace_arrangement.hpp"
#include "hard_halfspaces.hpp"
#include "shapes/makers.hpp"
#include "simplify_points.hpp"

using namespace convexact;

namespace {

// Solids with many ties and planes that share points, and some without.
std::vector<DualHull> sample_duals() {
  std::vector<DualHull> duals;
  for (const std::vector<Point>& points :
       {shapes::cut_cube(5, 0.25), shapes::chamfered_box({1, 2, 3}, 0.25), shapes::octahedron(),
        shapes::icosahedron(), shapes::lattice(24, 2, 2), shapes::in_ball(16, 1)}) {
    duals.push_back(dual_of_doubles(points));
  }
  return duals;
}

DualSurface surface_of(const DualHull& dual, std::uint64_t seed = 1) {
  return {dual.halfspaces, dual.triangles, center_of(dual), seed};
}

bool same_solid(const Polytope& a, const Polytope& b) {
  return a.planes == b.planes && a.facets.size() == b.facets.size() && volume(a) == volume(b);
}

// Removes what can be removed, in a random order, until `left` halfspaces are left or none can be.
std::vector<Removal> remove_at_random(DualSurface& surface, std::size_t left, Random& random) {
  std::vector<Removal> made;
  std::vector<std::size_t> order(surface.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  shuffle(std::span(order), random);
  for (const std::size_t i : order) {
    if (surface.left() == left) break;
    const Removal removal = surface.removal_of(HalfspaceId(i));
    if (!removal.cost) continue;
    surface.apply(removal);
    made.push_back(removal);
  }
  return made;
}

}  // namespace

TEST_CASE("DualSurface: what is applied and undone in reverse leaves the matrix as it was") {
  Random random(5);
  for (const DualHull& dual : sample_duals()) {
    DualSurface surface = surface_of(dual);
    std::vector<std::vector<DualTriangle>> before;
    std::vector<Removal> made;
    for (std::size_t i = 0; i < dual.halfspaces.size(); ++i) {
      const Removal removal = surface.removal_of(HalfspaceId(i));
      if (!removal.cost) continue;
      before.push_back(surface.triangles());
      surface.apply(removal);
      made.push_back(removal);
      CHECK_FALSE(surface.has(HalfspaceId(i)));
      CHECK(surface.left() == dual.halfspaces.size() - made.size());
      REQUIRE(surface.adjacency().is_closed_manifold());
    }
    REQUIRE_FALSE(made.empty());
    while (!made.empty()) {
      surface.undo(made.back());
      CHECK(surface.has(made.back().removed));
      CHECK(surface.triangles() == before.back());
      REQUIRE(surface.adjacency().is_closed_manifold());
      made.pop_back();
      before.pop_back();
    }
    CHECK(surface.left() == dual.halfspaces.size());
  }
}

TEST_CASE("DualSurface: the cost of a removal is what the solid gains, and undo takes it back") {
  for (const DualHull& dual : sample_duals()) {
    DualSurface surface = surface_of(dual);
    const auto solid = [&] { return to_polytope(dual.halfspaces, surface.triangles()); };
    const Rational at_first = volume(solid());
    for (std::size_t i = 0; i < dual.halfspaces.size(); ++i) {
      const Removal removal = surface.removal_of(HalfspaceId(i));
      if (!removal.cost) continue;
      surface.apply(removal);
      CHECK(volume(solid()) == Rational(at_first + removal.cost->rational()));
      surface.undo(removal);
    }
  }
}

TEST_CASE("DualSurface: halfspaces that were removed can be put back in any order") {
  Random random(9);
  for (const DualHull& dual : sample_duals()) {
    DualSurface surface = surface_of(dual);
    const Polytope whole = to_polytope(dual.halfspaces, dual.triangles);
    std::vector<Removal> made = remove_at_random(surface, 4, random);
    REQUIRE_FALSE(made.empty());
    shuffle(std::span(made), random);
    for (const Removal& removal : made) {
      const std::size_t left = surface.left();
      CHECK(surface.insert(removal.removed));
      CHECK(surface.left() == left + 1);
      REQUIRE(surface.adjacency().is_closed_manifold());
    }
    CHECK(same_solid(to_polytope(dual.halfspaces, surface.triangles()), whole));
  }
}

TEST_CASE("DualSurface: insert after removal gives back the same solid") {
  for (const DualHull& dual : sample_duals()) {
    DualSurface surface = surface_of(dual);
    const Polytope whole = to_polytope(dual.halfspaces, dual.triangles);
    for (std::size_t i = 0; i < dual.halfspaces.size(); ++i) {
      const Removal removal = surface.removal_of(HalfspaceId(i));
      if (!removal.cost) continue;
      surface.apply(removal);
      REQUIRE(surface.insert(HalfspaceId(i)));
      CHECK(same_solid(to_polytope(dual.halfspaces, surface.triangles()), whole));
    }
  }
}

TEST_CASE("DualSurface: halfspaces inserted into a tetrahedron bound what the definition says") {
  // Parallel and equal planes, planes through common points, planes that touch; most end redundant.
  // Every halfspace holds the origin strictly, so it is a center of all of them.
  const std::vector<Halfspace> tetrahedron = {
      Halfspace(IntegerVector3(-1, -1, -1), -8), Halfspace(IntegerVector3(-1, 1, 1), -8),
      Halfspace(IntegerVector3(1, -1, 1), -8), Halfspace(IntegerVector3(1, 1, -1), -8)};
  for (std::uint32_t i = 0; i < 40; ++i) {
    CAPTURE(i);
    const DualHull start = dual_of(tetrahedron, RationalPoint::Zero()).dual;
    std::vector<Halfspace> all = start.halfspaces;
    const hard::Halfspaces more(i);
    for (const Halfspace& h : more.all()) {
      if (all.size() < 12) all.push_back(h);
    }
    const definition::HalfspaceArrangement arrangement(all);
    DualSurface surface(all, start.triangles, RationalPoint::Zero());
    definition::Subset chosen = 0xf;
    for (std::size_t k = 4; k < all.size(); ++k) {
      CAPTURE(k);
      const auto place = all.begin() + static_cast<std::ptrdiff_t>(k);
      if (std::find(all.begin(), place, *place) != place) {  // the definition would count it twice
        CHECK_FALSE(surface.insert(HalfspaceId(k)));
        continue;
      }
      const Rational before = arrangement.volume(chosen).value();
      chosen |= definition::Subset{1} << k;
      const Rational after = arrangement.volume(chosen).value();
      CHECK(surface.insert(HalfspaceId(k)) == (after < before));
      REQUIRE(surface.adjacency().is_closed_manifold());
      definition::Subset present = 0;
      for (std::size_t j = 0; j < all.size(); ++j) {
        if (surface.has(HalfspaceId(j))) present |= definition::Subset{1} << j;
      }
      // The same solid, from halfspaces that are all needed.
      CHECK(arrangement.volume(present) == after);
      CHECK(volume(to_polytope(all, surface.triangles())) == after);
      std::size_t count = 0;
      for (std::size_t j = 0; j < all.size(); ++j) {
        if (!surface.has(HalfspaceId(j))) continue;
        ++count;
        CHECK(arrangement.volume(present & ~(definition::Subset{1} << j)) != after);
      }
      CHECK(surface.left() == count);
    }
  }
}

TEST_CASE("DualSurface: a plane that touches the solid is redundant, and so is one it makes so") {
  // The cube |x| <= 1; x + y <= 2 touches an edge, x + y + z <= 3 a corner.
  std::vector<Halfspace> all;
  for (int k = 0; k < 3; ++k) {
    for (const int sign : {-1, 1}) {
      IntegerVector3 normal = IntegerVector3::Zero();
      normal[k] = sign;
      all.emplace_back(normal, -1);
    }
  }
  std::sort(all.begin(), all.end());
  const DualHull cube = dual_of(all, RationalPoint::Zero()).dual;
  all.emplace_back(IntegerVector3(1, 1, 0), -2);
  all.emplace_back(IntegerVector3(1, 1, 1), -3);
  all.emplace_back(IntegerVector3(1, 1, 0), -1);  // cuts, and leaves x <= 1 and y <= 1 their facets
  all.emplace_back(IntegerVector3(2, 1, 0), -1);
  DualSurface surface(all, cube.triangles, RationalPoint::Zero());
  CHECK_FALSE(surface.insert(HalfspaceId(6)));
  CHECK_FALSE(surface.insert(HalfspaceId(7)));
  CHECK(surface.triangles() == surface_of(cube).triangles());
  CHECK(surface.insert(HalfspaceId(8)));
  CHECK(surface.left() == 7);
  CHECK(volume(to_polytope(all, surface.triangles())) == Rational(7));
  // 2x + y <= 1 runs from (0, 1) to (1, -1): x + y <= 1 only touches the edge at the one, and x <=
  // 1 the edge at the other. What is left is a trapezoid of widths 2 and 1 and height 2, times 2.
  CHECK(surface.insert(HalfspaceId(9)));
  CHECK_FALSE(surface.has(HalfspaceId(8)));
  CHECK(surface.left() == 6);
  CHECK(volume(to_polytope(all, surface.triangles())) == Rational(6));
}

TEST_CASE("DualSurface: a center on a plane is refused") {
  const DualHull dual = dual_of_doubles(shapes::octahedron());
  const RationalPoint corner(1, 0, 0);
  CHECK_THROWS_AS(DualSurface(dual.halfspaces, dual.triangles, corner), Error);
}

namespace {

// Rebuilds the triangulation from what it is told.
class Recorder : public RingObserver {
 public:
  void started(const DualTriangle& first) override { triangles.push_back(first); }
  void inserted(HalfspaceId corner, std::span<const DualTriangle> lost,
                std::span<const DualTriangle> gained) override {
    ++insertions;
    for (const DualTriangle& t : lost) {
      const auto found = std::find(triangles.begin(), triangles.end(), t);
      REQUIRE(found != triangles.end());
      triangles.erase(found);
    }
    CHECK(gained.size() == lost.size() + 1);
    for (const DualTriangle& t : gained) {
      CHECK(std::count(t.begin(), t.end(), corner) == 1);
      triangles.push_back(t);
    }
  }
  std::vector<DualTriangle> triangles;
  std::size_t insertions = 0;
};

}  // namespace

TEST_CASE("RingObserver: what it is told adds up to the triangulation, and changes nothing") {
  for (const DualHull& dual : sample_duals()) {
    DualSurface watched = surface_of(dual, 3), alone = surface_of(dual, 3);
    for (std::size_t i = 0; i < dual.halfspaces.size(); ++i) {
      Recorder recorder;
      const Removal removal = watched.removal_of(HalfspaceId(i), &recorder);
      CHECK(recorder.insertions + 3 == removal.ring.size());
      CHECK(removal.roof.triangles == alone.removal_of(HalfspaceId(i)).roof.triangles);
      std::vector<DualTriangle> expected = removal.roof.triangles;
      std::sort(expected.begin(), expected.end());
      std::sort(recorder.triangles.begin(), recorder.triangles.end());
      CHECK(recorder.triangles == expected);
    }
  }
}
