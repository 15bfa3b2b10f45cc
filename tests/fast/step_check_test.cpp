// SPDX-License-Identifier: MIT
// The check of a step accepts removals and refuses what is none: each condition is met by a claim
// that nothing else refuses.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "convexact/error.hpp"
#include "convexact/hull.hpp"
#include "fast/checks.hpp"
#include "fast/mesh.hpp"
#include "number/random.hpp"
#include "shapes/makers.hpp"

using namespace convexact;

namespace {

struct StepClaim {
  HalfspaceId removed;
  std::vector<HalfspaceId> ring, across;
  std::vector<DualTriangle> triangles;
};

// A solid's dual, and the removals of halfspaces whose ring has four.
bool says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// A triangle by places in a ring.
using Places = std::array<std::uint32_t, 3>;

// Every directed edge of the triangles and of the ring turned round is there once, and so is its
// opposite: then the surface has no border, and with k - 2 triangles it is one disk.
bool is_disk_by_definition(std::uint32_t k, const std::vector<Places>& triangles) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  bool is_once = triangles.size() + 2 == k;
  const auto add = [&](std::uint32_t a, std::uint32_t b) {
    is_once = is_once && a != b && edges.emplace(a, b).second;
  };
  for (std::uint32_t m = 0; m < k; ++m) add((m + 1) % k, m);
  for (const auto& [a, b, c] : triangles) {
    add(a, b);
    add(b, c);
    add(c, a);
  }
  return is_once && std::all_of(edges.begin(), edges.end(), [&](const auto& e) {
           return edges.count({e.second, e.first}) == 1;
         });
}

// Of the polygon 0, 1, ..., k - 1: ears cut off in random order, each from a random corner on.
std::vector<Places> random_triangulation(std::uint32_t k, Random& random) {
  std::vector<std::uint32_t> rest(k);
  std::iota(rest.begin(), rest.end(), 0);
  std::vector<Places> triangles;
  while (rest.size() > 2) {
    const std::size_t n = rest.size(), m = uniform_below(random, n);
    Places ear{rest[(m + n - 1) % n], rest[m], rest[(m + 1) % n]};
    std::rotate(ear.begin(), ear.begin() + static_cast<long>(uniform_below(random, 3)), ear.end());
    triangles.insert(
        triangles.begin() + static_cast<long>(uniform_below(random, triangles.size() + 1)), ear);
    rest.erase(rest.begin() + static_cast<long>(m));
  }
  return triangles;
}

struct DualOfPoints {
  PointSet points;
  Hull hull;
  FastDual dual;
  DualSigns signs;

  explicit DualOfPoints(const std::vector<Point>& list)
      : points(list),
        hull(std::get<Hull>(convex_hull(points))),
        dual(FastDual::of(hull, points)),
        signs(dual) {}

  // Why a removal is refused; empty if it is accepted.
  std::string refusal(const StepClaim& r) const {
    try {
      StepCheck(dual).check({r.removed, r.ring, r.across, r.triangles});
      return "";
    } catch (const Error& error) {
      return error.what();
    }
  }

  // A halfspace with a ring of that length; nothing is said about its triangles.
  StepClaim ring_of(std::size_t k) const {
    const HalfEdgeMesh mesh(dual.size(), dual.triangles());
    for (std::size_t i = 0; i < dual.size(); ++i) {
      OneRing ring;
      mesh.one_ring(HalfspaceId(i), ring);
      if (ring.vertices.size() != k) continue;
      StepClaim claim{HalfspaceId(i), ring.vertices, {}, {}};
      for (const std::uint32_t h : ring.outer) claim.across.push_back(mesh.apex(h));
      return claim;
    }
    throw std::runtime_error("no ring of that length");
  }
  // Whether these triangles pass the check that they form a disk, whatever else is wrong with them.
  bool is_taken_for_disk(StepClaim claim, const std::vector<Places>& triangles) const {
    for (const auto& [a, b, c] : triangles) {
      claim.triangles.push_back({claim.ring[a], claim.ring[b], claim.ring[c]});
    }
    const std::string why = refusal(claim);
    return !says(why, "every edge has two sides") && !says(why, "the ring bounds");
  }

  // By the definition: the new vertices exist and are inside the ring's planes.
  bool is_right(const StepClaim& r) const {
    for (const DualTriangle& t : r.triangles) {
      if (signs.determinant(t[0], t[1], t[2]) != Sign::Positive) return false;
      for (const HalfspaceId p : r.ring) {
        if (signs.height(t[0], t[1], t[2], p) == Sign::Positive) return false;
      }
    }
    return true;
  }

  // Each ring of four with both triangulations of its quadrilateral.
  std::vector<StepClaim> both_of_four() const {
    const HalfEdgeMesh mesh(dual.size(), dual.triangles());
    std::vector<StepClaim> list;
    for (std::size_t i = 0; i < dual.size(); ++i) {
      OneRing ring;
      mesh.one_ring(HalfspaceId(i), ring);
      const auto& v = ring.vertices;
      if (v.size() != 4) continue;
      StepClaim removal{HalfspaceId(i), v, {}, {{v[0], v[1], v[2]}, {v[0], v[2], v[3]}}};
      for (const std::uint32_t h : ring.outer) removal.across.push_back(mesh.apex(h));
      list.push_back(removal);
      removal.triangles = {{v[0], v[1], v[3]}, {v[1], v[2], v[3]}};
      list.push_back(removal);
    }
    return list;
  }
  std::vector<StepClaim> right_ones() const {
    std::vector<StepClaim> list = both_of_four();
    std::erase_if(list, [&](const StepClaim& r) { return !is_right(r); });
    REQUIRE(list.size() > 3);
    return list;
  }
};

DualOfPoints round_solid() { return DualOfPoints(shapes::in_ball(40, 9)); }

}  // namespace

TEST_CASE("StepCheck: accepts a removal and refuses what is not one") {
  const DualOfPoints solid = round_solid();
  int steps = 0, refused = 0;
  for (const StepClaim& removal : solid.both_of_four()) {
    if (!solid.is_right(removal)) {
      CHECK_FALSE(solid.refusal(removal).empty());
      ++refused;
      continue;
    }
    CHECK(solid.refusal(removal) == "");
    ++steps;
    // Each of these is not a disk, or lies on the wrong side.
    StepClaim wrong = removal;
    wrong.triangles = {removal.triangles[0]};
    CHECK(says(solid.refusal(wrong), "k - 2 triangles"));
    wrong.triangles = {removal.triangles[0], removal.triangles[0]};
    CHECK_FALSE(solid.refusal(wrong).empty());
    wrong.triangles[1] = removal.triangles[1];
    std::swap(wrong.triangles[1][0], wrong.triangles[1][1]);
    CHECK_FALSE(solid.refusal(wrong).empty());
  }
  CHECK(steps > 3);
  CHECK(refused > 3);
}

TEST_CASE("StepCheck: rings of nothing, of two, with a stranger, with a repeat") {
  const DualOfPoints solid = round_solid();
  for (const StepClaim& removal : solid.right_ones()) {
    const auto& v = removal.ring;
    CHECK(says(solid.refusal({removal.removed, {}, {}, {}}), "k - 2 triangles"));
    // What lies across is named so that no edge looks dented.
    CHECK(says(solid.refusal({removal.removed, {v[0], v[1]}, {v[0], v[1]}, {}}),
               "the ring bounds the new triangles"));
    StepClaim wrong = removal;
    wrong.triangles[0] = {removal.across[0], v[0], v[1]};
    CHECK(says(solid.refusal(wrong), "corners on the ring"));
    wrong = removal;
    wrong.ring[2] = v[0];
    CHECK_FALSE(solid.refusal(wrong).empty());
  }
}

TEST_CASE("StepCheck: triangles that own every edge of the ring, and are no disk") {
  const DualOfPoints solid = round_solid();
  const HalfEdgeMesh mesh(solid.dual.size(), solid.dual.triangles());
  int tried = 0;
  for (std::size_t i = 0; i < solid.dual.size(); ++i) {
    OneRing ring;
    mesh.one_ring(HalfspaceId(i), ring);
    const auto& v = ring.vertices;
    if (v.size() != 6) continue;
    StepClaim removal{HalfspaceId(i), v, {}, {}};
    for (const std::uint32_t h : ring.outer) removal.across.push_back(mesh.apex(h));
    // Three ears own all six edges; the fourth triangle is one of them again, not the middle.
    removal.triangles = {
        {v[0], v[1], v[2]}, {v[2], v[3], v[4]}, {v[4], v[5], v[0]}, {v[0], v[1], v[2]}};
    CHECK(says(solid.refusal(removal), "every edge has two sides"));
    ++tried;
  }
  CHECK(tried > 3);
}

TEST_CASE("StepCheck: a disk is what the definition says, of all triangles on a ring of five") {
  const DualOfPoints solid = round_solid();
  const StepClaim ring = solid.ring_of(5);
  std::vector<Places> all;
  for (std::uint32_t a = 0; a < 5; ++a) {
    for (std::uint32_t b = a + 1; b < 5; ++b) {
      for (std::uint32_t c = b + 1; c < 5; ++c) {
        all.push_back({a, b, c});
        all.push_back({a, c, b});
      }
    }
  }
  int disks = 0, differ = 0;
  for (const Places& a : all) {
    for (const Places& b : all) {
      for (const Places& c : all) {
        const bool is_disk = is_disk_by_definition(5, {a, b, c});
        disks += is_disk;
        differ += is_disk != solid.is_taken_for_disk(ring, {a, b, c});
      }
    }
  }
  CHECK(differ == 0);
  CHECK(disks == 5 * 6);  // the triangulations of a pentagon, in six orders
}

TEST_CASE(
    "StepCheck: a disk is what the definition says, of triangulations with one corner moved") {
  const DualOfPoints solid = round_solid();
  Random random(5);
  int disks = 0, others = 0;
  for (const std::uint32_t k : {4u, 6u, 7u, 8u}) {
    const StepClaim ring = solid.ring_of(k);
    for (int round = 0; round < 2000; ++round) {
      std::vector<Places> triangles = random_triangulation(k, random);
      if (round % 4 != 0) {
        triangles[uniform_below(random, triangles.size())][uniform_below(random, 3)] =
            static_cast<std::uint32_t>(uniform_below(random, k));
      }
      const bool is_disk = is_disk_by_definition(k, triangles);
      CHECK(is_disk == solid.is_taken_for_disk(ring, triangles));
      ++(is_disk ? disks : others);
    }
  }
  CHECK(disks > 2000);
  CHECK(others > 2000);
}

TEST_CASE("StepCheck: a cap that is open to infinity") {
  // Without a face of the cube the four around it are parallel in pairs: det = 0.
  const DualOfPoints cube(shapes::cube());
  for (const StepClaim& removal : cube.both_of_four()) {
    CHECK(says(cube.refusal(removal), "every new triangle has a vertex"));
  }
}

TEST_CASE("StepCheck: new vertices that lie strictly inside the plane that is removed") {
  // A right cap under a plane elsewhere, of which the new vertices stay clear.
  const DualOfPoints solid = round_solid();
  int tried = 0;
  for (const StepClaim& removal : solid.right_ones()) {
    for (std::size_t j = 0; j < solid.dual.size(); ++j) {
      const HalfspaceId other(j);
      const auto cuts = [&](const DualTriangle& t) {
        return solid.signs.height(t[0], t[1], t[2], other) != Sign::Negative;
      };
      if (std::any_of(removal.triangles.begin(), removal.triangles.end(), cuts)) continue;
      if (std::count(removal.ring.begin(), removal.ring.end(), other) > 0) continue;
      StepClaim wrong = removal;
      wrong.removed = other;
      CHECK(says(solid.refusal(wrong), "on or beyond the removed plane"));
      ++tried;
    }
  }
  CHECK(tried > 3);
}

TEST_CASE("StepCheck: the triangulation whose inner edge is a dent") {
  const DualOfPoints solid = round_solid();
  int tried = 0;
  for (const StepClaim& removal : solid.both_of_four()) {
    bool exists = true;
    for (const DualTriangle& t : removal.triangles) {
      exists = exists && solid.signs.determinant(t[0], t[1], t[2]) == Sign::Positive &&
               solid.signs.height(t[0], t[1], t[2], removal.removed) != Sign::Negative;
    }
    if (!exists || solid.is_right(removal)) continue;
    CHECK(says(solid.refusal(removal), "every inner edge is convex"));
    ++tried;
  }
  CHECK(tried > 0);
}

TEST_CASE("StepCheck: what is said to lie across an edge of the ring") {
  const DualOfPoints solid = round_solid();
  int dents = 0;
  for (const StepClaim& removal : solid.right_ones()) {
    const auto& v = removal.ring;
    StepClaim wrong = removal;
    wrong.across.push_back(wrong.across[0]);
    CHECK(says(solid.refusal(wrong), "every edge of the ring has an outside"));
    for (std::size_t m = 0; m < 4; ++m) {
      const auto owner =
          std::find_if(removal.triangles.begin(), removal.triangles.end(), [&](const auto& t) {
            return std::count(t.begin(), t.end(), v[m]) +
                       std::count(t.begin(), t.end(), v[(m + 1) % 4]) ==
                   2;
          });
      REQUIRE(owner != removal.triangles.end());
      const auto& [a, b, c] = *owner;
      // The removed plane itself, as if the new vertex stood where it cuts: a dent.
      wrong = removal;
      wrong.across[m] = removal.removed;
      if (solid.signs.height(a, b, c, removal.removed) == Sign::Positive) {
        CHECK(says(solid.refusal(wrong), "every edge of the ring is convex"));
        ++dents;
      }
      // The third corner of the new triangle: the same triangle on both sides.
      wrong.across[m] = a != v[m] && a != v[(m + 1) % 4]   ? a
                        : b != v[m] && b != v[(m + 1) % 4] ? b
                                                           : c;
      CHECK(says(solid.refusal(wrong), "no edge is there twice"));
    }
  }
  CHECK(dents > 3);
}

TEST_CASE("StepCheck: a dent that only exact numbers see") {
  // z >= 0, four sides that nearly meet above, x + z <= 1, -x + z <= 1, y + z <= 1 and
  // -y + z <= 1 + 2^-60, and a lid z <= 1/2: the wrong fill of its ring dents by 2^-60.
  const Integer one = Integer(1) << 60;
  const auto plane = [&](int x, int y, int z, const Integer& d) {
    return Halfspace(IntegerVector3(x * one, y * one, z * one), d);
  };
  const std::vector<Halfspace> planes = {plane(0, 0, -1, 0),        plane(1, 0, 1, -one),
                                         plane(-1, 0, 1, -one),     plane(0, 1, 1, -one),
                                         plane(0, -1, 1, -one - 1), plane(0, 0, 2, -one)};
  const RationalPoint center(Rational(0), Rational(0), Rational(1, 4));
  const DualHull solid = dual_of(planes, center).dual;
  const FastDual dual = FastDual::of(solid, center);
  const HalfEdgeMesh mesh(dual.size(), dual.triangles());
  std::size_t accepted = 0, refused = 0;
  for (std::size_t i = 0; i < dual.size(); ++i) {
    const IntegerVector3& n = solid.halfspaces[i].normal();
    if (n[0] != 0 || n[1] != 0 || n[2] < 0) continue;
    OneRing ring;
    mesh.one_ring(HalfspaceId(i), ring);
    const auto& v = ring.vertices;
    REQUIRE(v.size() == 4);
    std::vector<HalfspaceId> across;
    for (const std::uint32_t h : ring.outer) across.push_back(mesh.apex(h));
    for (const std::size_t k : {0u, 1u}) {
      const std::vector<DualTriangle> fill = {{v[k], v[k + 1], v[k + 2]},
                                              {v[k], v[k + 2], v[(k + 3) % 4]}};
      try {
        StepCheck(dual).check({HalfspaceId(i), v, across, fill});
        ++accepted;
      } catch (const Error& error) {
        CHECK(says(error.what(), "every inner edge is convex"));
        ++refused;
      }
    }
  }
  CHECK(accepted == 1);
  CHECK(refused == 1);
}
