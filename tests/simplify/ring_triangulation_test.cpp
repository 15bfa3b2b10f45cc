// SPDX-License-Identifier: MIT
// T_i is judged by its definition: k - 2 triangles with no ring point beyond any of them and the
// removed point beyond or level with all. Valences up to 10,000.
#include "simplify/ring_triangulation.hpp"

#include <doctest/doctest.h>

#include <set>

#include "property.hpp"
#include "shapes/makers.hpp"

using namespace convexact;

namespace {

std::vector<HalfspaceId> ring_of(std::size_t k) {
  std::vector<HalfspaceId> ring;
  for (std::size_t t = 0; t < k; ++t) ring.emplace_back(t);
  return ring;
}

// Integer dual points (x, y, z) / 2^scale around the vertical axis.
DualPoint around(std::size_t t, std::size_t k, double z) {
  const shapes::CirclePoint c = shapes::on_circle(t, k);
  const auto fixed = [](double v) { return Integer(static_cast<long long>(v * 0x1p40)); };
  return {{fixed(c.cosine), fixed(c.sine), fixed(z)}, Integer(1) << 40};
}

// Every ring edge once, every other edge in both directions, k - 2 triangles: a disk (the planes'
// test below rules out the rest).
void check_topology(const RingTriangulation& roof, std::size_t k) {
  REQUIRE(roof.triangles.size() == k - 2);
  REQUIRE(roof.planes.size() == k - 2);
  std::set<std::pair<HalfspaceId, HalfspaceId>> edges;
  for (const DualTriangle& t : roof.triangles) {
    for (int e = 0; e < 3; ++e) CHECK(edges.insert({t[e], t[(e + 1) % 3]}).second);
  }
  std::size_t rim = 0;
  for (const auto& [from, to] : edges) {
    if (edges.count({to, from}) == 1) continue;
    ++rim;
    CHECK(to.index() == (from.index() + 1) % k);
  }
  CHECK(rim == k);
}

}  // namespace

TEST_CASE("triangulate_ring: a triangle is its own triangulation") {
  const std::vector<DualPoint> points = {around(0, 3, 0), around(1, 3, 0), around(2, 3, 0)};
  Random random(1);
  const RingTriangulation roof = triangulate_ring(points, ring_of(3), random);
  REQUIRE(roof.triangles.size() == 1);
  CHECK(roof.triangles[0] == DualTriangle{HalfspaceId(0), HalfspaceId(1), HalfspaceId(2)});
  CHECK_FALSE(roof.is_bounded());  // the plane z = 0 goes through the origin
}

TEST_CASE("triangulate_ring: a square folds along the higher diagonal") {
  // Corners 0 and 2 are higher, so the edge between them is on the hull seen from above.
  const std::vector<DualPoint> points = {around(0, 4, 2), around(1, 4, 1), around(2, 4, 2),
                                         around(3, 4, 1)};
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Random random(seed);
    const RingTriangulation roof = triangulate_ring(points, ring_of(4), random);
    check_topology(roof, 4);
    for (const DualTriangle& t : roof.triangles) {
      CHECK(std::count(t.begin(), t.end(), HalfspaceId(0)) == 1);
      CHECK(std::count(t.begin(), t.end(), HalfspaceId(2)) == 1);
    }
    CHECK(roof.is_bounded());
  }
}

TEST_CASE("triangulate_ring: no ring point lies beyond any triangle") {
  check_property("weakly convex rings", [](std::uint8_t size, std::uint64_t seed, bool flat_sides) {
    const std::size_t k = 3 + size % 30;
    Random random(seed);
    // Points around the axis at random heights; the apex, far above, sees a convex ring. Coarse
    // heights make many quadruples coplanar. With flat_sides the ring comes in vertical planes
    // through the apex at infinity: three of its points are level with it.
    std::vector<DualPoint> points;
    for (std::size_t t = 0; t < k; ++t) {
      const double z = 1 + static_cast<double>(uniform_below(random, 3));
      points.push_back(around(t, k, z));
      if (flat_sides && t + 1 < k) {
        // Half way to the next corner, lower than both: still a vertex of the hull's underside.
        DualPoint next = around(t + 1, k, 0);
        DualPoint middle{points.back().n + next.n, Integer(2) << 40};
        middle.n[2] = 0;
        points.push_back(middle);
      }
    }
    const RingTriangulation roof = triangulate_ring(points, ring_of(points.size()), random);
    check_topology(roof, points.size());
    for (std::size_t t = 0; t < roof.triangles.size(); ++t) {
      for (const DualPoint& p : points) RC_ASSERT_FALSE(is_beyond(p, roof.planes[t]));
      for (const HalfspaceId corner : roof.triangles[t]) {
        RC_ASSERT(height(roof.planes[t], points[corner.index()]) == 0);
      }
      // Direction "straight up" is not below the plane: x . up >= 0.
      RC_ASSERT(roof.planes[t].x[2] >= 0);
    }
  });
}

TEST_CASE("triangulate_ring: valence 10,000, wavy and flat") {
  constexpr std::size_t kValence = 10000;
  for (const bool wavy : {false, true}) {
    CAPTURE(wavy);
    Random random(7);
    std::vector<DualPoint> points;
    for (std::size_t t = 0; t < kValence; ++t) {
      points.push_back(around(t, kValence, wavy && t % 2 == 0 ? 2 : 1));
    }
    const RingTriangulation roof = triangulate_ring(points, ring_of(kValence), random);
    check_topology(roof, kValence);
    CHECK(roof.is_bounded());
    for (int sample = 0; sample < 10000; ++sample) {
      const std::size_t t = uniform_below(random, roof.planes.size());
      const std::size_t p = uniform_below(random, kValence);
      CHECK_FALSE(is_beyond(points[p], roof.planes[t]));
    }
  }
}
