// SPDX-License-Identifier: MIT
// What parts leave of a surface. Expected values: closed forms; quarter faces counted; inclusion
// and exclusion in the plane of a triangle; points sampled by the definition.
#include <doctest/doctest.h>

#include <cmath>

#include "overlay_scenes.hpp"
#include "sweep.hpp"
using namespace convexact;
using namespace support;

namespace {

Rational uncovered_share(const SoupTriangle& t, const std::vector<ConvexPart>& parts) {
  const SurfaceCoverage coverage = find_uncovered(surface_of({t}, false), parts);
  Rational sum = 0;
  for (const UncoveredPiece& piece : coverage.uncovered) sum += piece.share;
  CHECK((coverage.uncovered.empty() || coverage.in_one_part == 0));
  return sum;
}

SoupTriangle triangle(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c) {
  return {a, b, c};
}

// 1 inside, 0 on the boundary, -1 outside of a piece of the triangle, x in its plane.
int side_of_piece(const RationalVector3& normal, const UncoveredPiece& piece,
                  const RationalPoint& x) {
  int side = 1;
  for (std::size_t i = 0; i < piece.corners.size(); ++i) {
    const RationalPoint& a = piece.corners[i];
    const RationalVector3 u = piece.corners[(i + 1) % piece.corners.size()] - a, v = x - a;
    const Rational turn = normal.dot(u.cross(v));
    if (turn < 0) return -1;
    if (turn == 0) side = 0;
  }
  return side;
}

const SoupTriangle kTriangle =
    triangle(rational_point(0, 0, 0), rational_point(4, 0, 0), rational_point(0, 4, 0));

}  // namespace

TEST_CASE("find_uncovered: a triangle in one part, in none, and in half of one") {
  CHECK(uncovered_share(kTriangle, {}) == 1);
  CHECK(uncovered_share(kTriangle, {box_part(0, 0, -1, 4, 4, 1)}) == 0);
  CHECK(uncovered_share(kTriangle, {box_part(0, 0, 5, 4, 4, 6)}) == 1);
  CHECK(uncovered_share(kTriangle, {box_part(0, 0, -1, 2, 2, 1)}) == Rational(1, 2));
  CHECK(uncovered_share(kTriangle, {box_part(0, 0, -1, 4, 2, 1)}) == Rational(1, 4));
  CHECK(uncovered_share(kTriangle, {box_part(0, 0, -1, 4, 2, 1), box_part(0, 2, -1, 2, 4, 1)}) ==
        0);
  const SurfaceCoverage coverage =
      find_uncovered(surface_of({kTriangle}, false), std::vector{box_part(0, 0, -1, 4, 4, 1)});
  CHECK(coverage.in_one_part == 1);
}

TEST_CASE("find_uncovered: parts are closed, and what touches covers nothing") {
  // Facets in the triangle's plane cover it, from either side; edges and vertices do not.
  CHECK(uncovered_share(kTriangle, {box_part(0, 0, 0, 4, 4, 1)}) == 0);
  CHECK(uncovered_share(kTriangle, {box_part(0, 0, -1, 4, 4, 0)}) == 0);
  CHECK(uncovered_share(kTriangle, {box_part(0, 0, -1, 2, 2, 0)}) == Rational(1, 2));
  CHECK(uncovered_share(kTriangle, {box_part(0, 0, 0x1p-1074, 4, 4, 1)}) == 1);
  CHECK(uncovered_share(kTriangle, {box_part(-2, -2, -1, 0, 4, 1)}) == 1);
  const ConvexPart roof = part_of({rational_point(0, 1, 0), rational_point(2, 1, 0),
                                   rational_point(1, 0, 1), rational_point(1, 2, 1)});
  CHECK(uncovered_share(kTriangle, {roof}) == 1);
  const SurfaceCoverage whole = find_uncovered(surface_of({kTriangle}, false), std::vector{roof});
  CHECK(whole.uncovered.size() == 1);
}

TEST_CASE("find_uncovered: an ulp that matters is found, and one that does not is not") {
  const double less = std::nextafter(4.0, 0.0), more = std::nextafter(4.0, 5.0);
  CHECK(uncovered_share(kTriangle, {box_part(0, 0, -1, 4, 4, 1)}) == 0);
  const Rational u = to_rational(4.0 - less);
  CHECK(uncovered_share(kTriangle, {box_part(0, 0, -1, less, 4, 1)}) == u * u / 16);
  CHECK(uncovered_share(kTriangle, {box_part(0, 0, -1, more, 4, 1)}) == 0);
  CHECK(uncovered_share(kTriangle, {box_part(0, 0, -1, less, 4, 1), box_part(3, 0, -1, 5, 1, 1)}) ==
        0);
  // Two halves that miss each other by an ulp, and that overlap by one.
  const double below = std::nextafter(2.0, 0.0);
  CHECK(uncovered_share(kTriangle, {box_part(0, 0, -1, below, 4, 1), box_part(2, 0, -1, 4, 4, 1)}) >
        0);
  CHECK(uncovered_share(kTriangle,
                        {box_part(0, 0, -1, 2, 4, 1), box_part(below, 0, -1, 4, 4, 1)}) == 0);
}

TEST_CASE("find_uncovered: flat parts cover what lies in their plane only") {
  CHECK(uncovered_share(kTriangle, {box_part(0, 0, 0, 4, 4, 0)}) == 0);
  CHECK(uncovered_share(kTriangle, {box_part(0, 0, 0, 2, 2, 0)}) == Rational(1, 2));
  CHECK(uncovered_share(kTriangle, {box_part(1, 0, -1, 1, 4, 1)}) == 1);  // across
  CHECK(uncovered_share(kTriangle, {box_part(0, 0, 0, 4, 0, 0)}) == 1);   // a segment on its side
  CHECK(uncovered_share(kTriangle, {box_part(0, 0, 0, 0, 0, 0)}) == 1);
  CHECK(uncovered_share(kTriangle, {box_part(0, 0, 0, 2, 2, 0), box_part(0, 2, 0, 2, 4, 1),
                                    box_part(2, 0, -1, 4, 2, 0)}) == 0);
}

TEST_CASE("find_uncovered: triangles without area are segments and points") {
  const RationalPoint a = rational_point(0, 0, 0), b = rational_point(1, 1, 2),
                      c = rational_point(4, 4, 8);
  for (const SoupTriangle& t :
       {triangle(a, b, c), triangle(c, a, b), triangle(a, a, c), triangle(c, a, c)}) {
    CHECK(uncovered_share(t, {}) == 1);
    CHECK(uncovered_share(t, {box_part(0, 0, 0, 4, 4, 8)}) == 0);
    CHECK(uncovered_share(t, {box_part(0, 0, 0, 1, 4, 8)}) == Rational(3, 4));
    CHECK(uncovered_share(t, {box_part(1, 0, 0, 2, 4, 8)}) == Rational(3, 4));
    CHECK(uncovered_share(t, {box_part(0, 0, 0, 2, 4, 8), box_part(2, 2, 4, 9, 9, 9)}) == 0);
    CHECK(uncovered_share(t, {part_of({b, c})}) == Rational(1, 4));
    CHECK(uncovered_share(t, {part_of({b, c}), part_of({a, b})}) == 0);
    CHECK(uncovered_share(t, {box_part(1, 0, 0, 1, 4, 8)}) == 1);  // one point
    const SurfaceCoverage coverage =
        find_uncovered(surface_of({t}, false), std::vector{box_part(1, 0, 0, 2, 4, 8)});
    REQUIRE(coverage.uncovered.size() == 2);
    for (const UncoveredPiece& piece : coverage.uncovered) CHECK(piece.corners.size() == 2);
  }
  const SoupTriangle point = triangle(b, b, b);
  CHECK(uncovered_share(point, {}) == 1);
  CHECK(uncovered_share(point, {box_part(1, 0, 0, 2, 4, 8)}) == 0);
  CHECK(uncovered_share(point, {box_part(2, 0, 0, 2, 4, 8)}) == 1);
  CHECK(uncovered_share(point, {part_of({b})}) == 0);
}

TEST_CASE("find_uncovered: cells and boxes, mapped and scaled, face by face") {
  Random random(21);
  for (int round = 0; round < 30; ++round) {
    CAPTURE(round);
    // Cells of size 2; boxes with integer corners, so that each face falls into four squares, and
    // each of its two triangles into one square and two halves.
    std::set<Cell> cells;
    const std::size_t count = 1 + uniform_below(random, 12);
    const auto below = [&](std::uint64_t n) { return static_cast<int>(uniform_below(random, n)); };
    while (cells.size() < count) cells.insert({below(3), below(3), below(3)});
    std::vector<IntegerBox> boxes;
    for (int i = 0; i < 9; ++i) {
      IntegerBox& box = boxes.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) {
        box.low[k] = below(6);
        box.high[k] = box.low[k] + 1 + below(4);
      }
    }
    const Soup soup = boundary_of(cells, 2);
    const IntegerMap map = random_map(random);
    const long power = round % 4 == 0 ? 300 : round % 4 == 1 ? -300 : 0;
    const Surface surface = surface_of(scaled(map(soup), power));
    std::vector<ConvexPart> parts;
    for (const IntegerBox& box : boxes) parts.push_back(scaled(map(box.part()), power));
    const auto shares = shares_of(find_uncovered(surface, parts));
    std::reverse(parts.begin(), parts.end());
    CHECK(shares == shares_of(find_uncovered(surface, parts)));
    // By definition: a point of each of 16 equal small triangles. They lie in one square each.
    std::vector<std::pair<std::vector<RationalPoint>, Rational>> expected;
    for (const SoupTriangle& t : soup) {
      int uncovered = 0;
      for (int i = 0; i < 4; ++i) {
        for (int j = 0; i + j < 4; ++j) {
          for (int up = 0; up < (i + j < 3 ? 2 : 1); ++up) {
            const Rational u = Rational(3 * i + 1 + up, 12), v = Rational(3 * j + 1 + up, 12);
            const RationalPoint x = t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]);
            const bool is_held =
                std::any_of(boxes.begin(), boxes.end(), [&](const IntegerBox& box) {
                  for (int k = 0; k < 3; ++k) {
                    if (x[k] < box.low[k] || x[k] > box.high[k]) return false;
                  }
                  return true;
                });
            uncovered += !is_held;
          }
        }
      }
      SoupTriangle mapped = scaled(map(Soup{t}), power).front();
      std::sort(mapped.begin(), mapped.end(), comes_before);
      expected.push_back({{mapped.begin(), mapped.end()}, Rational(uncovered, 16)});
    }
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
      SoupTriangle corners = corners_of(surface, t);
      std::sort(corners.begin(), corners.end(), comes_before);
      const auto found = shares.find(t);
      const Rational share = found == shares.end() ? Rational(0) : found->second;
      const std::vector<RationalPoint> key(corners.begin(), corners.end());
      const auto same = std::find_if(expected.begin(), expected.end(),
                                     [&](const auto& entry) { return entry.first == key; });
      REQUIRE(same != expected.end());
      CHECK(share == same->second);
    }
  }
}

TEST_CASE("find_uncovered: a triangle and random solids, by inclusion and exclusion and by points" *
          sweep) {
  Random random(34);
  int partly = 0;
  for (int round = 0; round < 40; ++round) {
    CAPTURE(round);
    const auto entry = [&] { return static_cast<double>(uniform_below(random, 7)) - 3; };
    SoupTriangle t;
    do {
      for (RationalPoint& corner : t) {
        for (Rational& x : corner) x = to_rational(entry());
      }
    } while (affine_dimension(t) < 2);
    std::vector<ConvexPart> parts;
    const std::size_t count = 1 + uniform_below(random, 3);
    for (std::size_t i = 0; i < count; ++i) parts.push_back(grid_part(random, 5, 3));
    const Surface surface = surface_of({t}, false);
    const SurfaceCoverage coverage = find_uncovered(surface, parts);
    Rational uncovered = 0;
    for (const UncoveredPiece& piece : coverage.uncovered) uncovered += piece.share;
    const Rational covered = measure_of_union(
        parts, [&](const std::vector<const ConvexPart*>& set) { return common_share(t, set); });
    CHECK(covered + uncovered == 1);
    partly += covered > 0 && uncovered > 0;
    const SoupTriangle own = corners_of(surface, 0);
    const RationalVector3 u = own[1] - own[0], v = own[2] - own[0], normal = u.cross(v);
    for (int i = 1; i < 17; ++i) {
      for (int j = 1; i + j < 17; ++j) {
        const RationalPoint x = own[0] + Rational(i, 17) * u + Rational(j, 17) * v;
        const bool is_held = std::any_of(parts.begin(), parts.end(),
                                         [&](const ConvexPart& part) { return holds(part, x); });
        int best = -1, inside = 0;
        for (const UncoveredPiece& piece : coverage.uncovered) {
          const int side = side_of_piece(normal, piece, x);
          best = std::max(best, side);
          inside += side == 1;
        }
        CHECK(inside <= 1);
        if (is_held) CHECK(best < 1);
        if (!is_held) CHECK(best >= 0);
      }
    }
    // Corners are strictly convex, so every piece has an area and a share of its own.
    for (const UncoveredPiece& piece : coverage.uncovered) {
      CHECK(piece.share > 0);
      for (std::size_t i = 0; i < piece.corners.size(); ++i) {
        const std::size_t m = piece.corners.size();
        const RationalVector3 e = piece.corners[(i + 1) % m] - piece.corners[i],
                              f = piece.corners[(i + 2) % m] - piece.corners[(i + 1) % m];
        CHECK(normal.dot(e.cross(f)) > 0);
      }
    }
  }
  CHECK(partly > 10);
}

TEST_CASE("find_uncovered: solids that meet facets of others but for last bits" * sweep) {
  Random random(35);
  for (int round = 0; round < 60; ++round) {
    CAPTURE(round);
    // A facet of one solid, some of its corners moved, under copies that are moved as well.
    const ConvexPart solid = nearly_grid_part(random, 6, 2);
    const auto& facet = solid.solid->facets[uniform_below(random, solid.solid->facets.size())];
    SoupTriangle t;
    for (std::size_t k = 0; k < 3; ++k) {
      t[k] = solid.vertices[facet[k]];
      if (uniform_below(random, 4) == 0) t[k][0] += to_rational(0x1p-51);
    }
    if (affine_dimension(t) < 2) continue;
    std::vector<ConvexPart> parts{solid, nearly_grid_part(random, 5, 2)};
    std::vector<RationalPoint> points = solid.vertices;
    for (RationalPoint& p : points) {
      if (uniform_below(random, 2) == 0) p[1] -= to_rational(0x1p-51);
    }
    parts.push_back(part_of(points));
    if (parts.back().dimension < 3) continue;
    const Rational covered = measure_of_union(
        parts, [&](const std::vector<const ConvexPart*>& set) { return common_share(t, set); });
    CHECK(covered + uncovered_share(t, parts) == 1);
  }
}

TEST_CASE("find_uncovered: an interrupted search stops") {
  const std::atomic<bool> stop = true;
  CHECK_THROWS_AS((void)find_uncovered(surface_of({kTriangle}, false), {}, Watch(&stop)), Error);
}
