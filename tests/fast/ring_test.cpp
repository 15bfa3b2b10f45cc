// SPDX-License-Identifier: MIT
// Ring triangulation, by wrapping and by insertion, with true answers and with lies.
#include "fast/ring.hpp"

#include <doctest/doctest.h>

#include <set>

#include "number/random.hpp"

using namespace convexact;

namespace {

// Points in convex position, (t, t^2) for ascending t, lifted to integer heights. `beyond` is the
// exact sign of a determinant of small integers: below the plane, seen from far up.
struct Lifted {
  std::vector<std::array<long, 3>> points;
  std::array<std::uint32_t, 3> triangle{};

  explicit Lifted(std::uint32_t k, std::uint64_t seed) {
    Random random(seed);
    for (std::uint32_t m = 0; m < k; ++m) {
      const long t = static_cast<long>(m) - static_cast<long>(k / 2);
      points.push_back({t, t * t, static_cast<long>(uniform_below(random, 1 + seed * 50))});
    }
  }
  void set_triangle(std::uint32_t low, std::uint32_t middle, std::uint32_t high) {
    REQUIRE(low < middle);
    REQUIRE(middle < high);
    triangle = {low, middle, high};
  }
  bool is_beyond(std::uint32_t m) const {
    const auto edge = [&](std::uint32_t v, int k) { return points[v][k] - points[triangle[0]][k]; };
    const std::uint32_t b = triangle[1], c = triangle[2];
    const long x = edge(b, 1) * edge(c, 2) - edge(b, 2) * edge(c, 1);
    const long y = edge(b, 2) * edge(c, 0) - edge(b, 0) * edge(c, 2);
    const long z = edge(b, 0) * edge(c, 1) - edge(b, 1) * edge(c, 0);
    return x * edge(m, 0) + y * edge(m, 1) + z * edge(m, 2) > 0;
  }
};

struct Liar {
  Random random;
  void set_triangle(std::uint32_t, std::uint32_t, std::uint32_t) {}
  bool is_beyond(std::uint32_t) { return random() % 2 == 0; }
};

// From the definition: k - 2 triangles whose edges are the polygon's and pairs of inner ones, each
// hanging on its parent.
void check_polygon(std::uint32_t k, const std::vector<RingTriangle>& triangles) {
  REQUIRE(triangles.size() == k - 2);
  std::multiset<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& [low, middle, high, parent] = triangles[t];
    REQUIRE(low < middle);
    REQUIRE(middle < high);
    REQUIRE(high < k);
    for (const auto& edge : {std::pair{low, middle}, {middle, high}, {low, high}})
      edges.insert(edge);
    if (parent == kNone) {
      CHECK(t == 0);
      CHECK(low == 0);
      CHECK(high == k - 1);
    } else {
      REQUIRE(parent < t);
      const RingTriangle& above = triangles[parent];
      CHECK(((low == above.low && high == above.middle) ||
             (low == above.middle && high == above.high)));
    }
  }
  for (const auto& edge : edges) {
    const bool rim = edge.second == edge.first + 1 || (edge.first == 0 && edge.second == k - 1);
    CHECK(edges.count(edge) == (rim ? 1 : 2));
  }
}

}  // namespace

TEST_CASE("RingTriangulator: no ring point is beyond a triangle") {
  RingTriangulator triangulator;
  std::vector<RingTriangle> triangles;
  for (std::uint32_t k = 3; k <= 48; ++k) {
    for (std::uint64_t seed = 0; seed < 6; ++seed) {  // seed 0: all heights are 0
      CAPTURE(k);
      CAPTURE(seed);
      Lifted ring(k, seed);
      triangulator.run(k, ring, seed, triangles);
      check_polygon(k, triangles);
      for (const RingTriangle& t : triangles) {
        ring.set_triangle(t.low, t.middle, t.high);
        for (std::uint32_t m = 0; m < k; ++m) REQUIRE_FALSE(ring.is_beyond(m));
      }
    }
  }
}

TEST_CASE("RingTriangulator: ends with a triangulation whatever it is told") {
  RingTriangulator triangulator;
  std::vector<RingTriangle> triangles;
  Liar liar;
  for (std::uint32_t k = 3; k <= 200; k += k < 40 ? 1 : 23) {
    CAPTURE(k);
    triangulator.run(k, liar, k, triangles);
    check_polygon(k, triangles);
  }
}
