// SPDX-License-Identifier: MIT
// Mass properties. Expected values: closed forms of boxes and tetrahedra, put together by the
// parallel axis theorem; what must not change when a solid is described otherwise.
#include "convexact/mass.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <random>

#include "cells.hpp"
#include "convexact/io.hpp"
#include "overlay_scenes.hpp"

using namespace convexact;
using namespace support;

namespace {

using Moments = std::array<Rational, 6>;

// A box, or with a negative sign a hole of its shape: volume, and moments about the origin.
struct Piece {
  RationalPoint low, high;
  int sign = 1;
};

MassProperties put_together(const std::vector<Piece>& pieces) {
  constexpr std::pair<int, int> kEntries[] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};
  MassProperties sum;
  sum.volume = 0;
  sum.center = RationalPoint::Zero();
  for (Rational& m : sum.moments) m = 0;
  for (const Piece& piece : pieces) {
    const RationalVector3 size = piece.high - piece.low, middle = (piece.high + piece.low) / 2;
    const Rational volume = piece.sign * size[0] * size[1] * size[2];
    sum.volume += volume;
    sum.center += volume * middle;
    for (std::size_t e = 0; e < 6; ++e) {
      const auto [i, k] = kEntries[e];
      const Rational own = i == k ? Rational(volume * size[i] * size[i] / 12) : Rational(0);
      sum.moments[e] += own + volume * middle[i] * middle[k];
    }
  }
  sum.center = sum.center / sum.volume;
  for (std::size_t e = 0; e < 6; ++e) {
    const auto [i, k] = kEntries[e];
    sum.moments[e] -= sum.volume * sum.center[i] * sum.center[k];
  }
  return sum;
}

void check_same(const MassProperties& a, const MassProperties& b) {
  CHECK(a.volume == b.volume);
  CHECK(a.center == b.center);
  for (std::size_t e = 0; e < 6; ++e) CHECK(a.moments[e] == b.moments[e]);
}

Mesh boxes(const std::vector<Piece>& pieces) {
  std::vector<RationalPoint> points;
  Mesh mesh;
  for (const Piece& piece : pieces) {
    const auto first = static_cast<std::uint32_t>(points.size());
    for (unsigned k = 0; k < 8; ++k) {
      RationalPoint p;
      for (unsigned axis = 0; axis < 3; ++axis) {
        p[axis] = (k >> axis & 1) != 0 ? piece.high[axis] : piece.low[axis];
      }
      points.push_back(p);
    }
    static constexpr std::uint32_t kFaces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                                   {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    for (const auto& face : kFaces) {
      std::vector<std::uint32_t> polygon;
      for (const std::uint32_t c : face) polygon.push_back(first + c);
      if (piece.sign < 0) std::reverse(polygon.begin(), polygon.end());
      mesh.polygons.push_back(polygon);
    }
  }
  mesh.points = PointSet(points);
  return mesh;
}

MassProperties mass_of(const Mesh& mesh) {
  const auto found = mass_properties(make_surface(mesh, {.orient = Orient::Keep}));
  REQUIRE(found);
  return *found;
}

}  // namespace

TEST_CASE("mass: a box, a box with a cavity, boxes that lie apart") {
  const Piece box{rational_point(1, 2, 3), rational_point(2, 4, 6)};
  const MassProperties own = mass_of(boxes({box}));
  check_same(own, put_together({box}));
  const Moments inertia = own.inertia();
  CHECK(inertia[0] == Rational(6 * (4 + 9), 12));
  CHECK(inertia[1] == Rational(6 * (1 + 9), 12));
  CHECK(inertia[2] == Rational(6 * (1 + 4), 12));
  for (std::size_t e = 3; e < 6; ++e) CHECK(inertia[e] == 0);

  const std::vector<Piece> hollow{{rational_point(0, 0, 0), rational_point(4, 4, 4)},
                                  {rational_point(1, 1, 0.5), rational_point(2, 3, 3), -1}};
  check_same(mass_of(boxes(hollow)), put_together(hollow));
  const std::vector<Piece> apart{{rational_point(0, 0, 0), rational_point(1, 1, 1)},
                                 {rational_point(5, -3, 2), rational_point(6, 0, 4)}};
  check_same(mass_of(boxes(apart)), put_together(apart));
}

TEST_CASE("mass: a tetrahedron") {
  Mesh mesh;
  mesh.points = PointSet(std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}});
  mesh.polygons = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  const MassProperties own = mass_of(mesh);
  CHECK(own.volume == 1);
  CHECK(own.center == RationalPoint(Rational(1, 4), Rational(1, 2), Rational(3, 4)));
  // Of a corner at right angles: 3 V a^2 / 80, and -V a b / 80.
  CHECK(own.moments[0] == Rational(3, 80));
  CHECK(own.moments[1] == Rational(12, 80));
  CHECK(own.moments[2] == Rational(27, 80));
  CHECK(own.moments[3] == Rational(-2, 80));
  CHECK(own.moments[4] == Rational(-3, 80));
  CHECK(own.moments[5] == Rational(-6, 80));
}

TEST_CASE("mass: what the surface winds about twice counts once") {
  // Cubes of 2 that have a cube of 1 in common: 8 + 8 - 1 = 15.
  const Piece a{rational_point(0, 0, 0), rational_point(2, 2, 2)},
      b{rational_point(1, 1, 1), rational_point(3, 3, 3)},
      common{rational_point(1, 1, 1), rational_point(2, 2, 2), -1};
  const MassProperties crossing = mass_of(boxes({a, b}));
  CHECK(crossing.volume == 15);
  check_same(crossing, put_together({a, b, common}));
  // A box in a box of the same orientation, once and twice.
  const Piece inner{rational_point(0.5, 0.5, 0.5), rational_point(1, 1, 1)};
  check_same(mass_of(boxes({a, inner})), put_together({a}));
  check_same(mass_of(boxes({a, a})), put_together({a}));
  // The same as a union of parts.
  std::vector<ConvexPart> parts;
  for (const Piece& piece : {a, b}) parts.push_back(part_of(box_corners(piece.low, piece.high)));
  const auto united = mass_properties(parts);
  REQUIRE(united);
  check_same(*united, crossing);
  CHECK(!mass_properties(std::span<const ConvexPart>()));
}

TEST_CASE("mass: faces that touch along an edge; open and flat surfaces") {
  const Mesh mesh =
      read_mesh(std::string(std::getenv("CONVEXACT_TEST_DATA")) + "/cases/edge_inv.obj");
  const auto found = mass_properties(make_surface(mesh, {}));
  REQUIRE(found);
  CHECK(found->volume == 2);
  Mesh open = boxes({{rational_point(0, 0, 0), rational_point(1, 1, 1)}});
  open.polygons.pop_back();
  CHECK_THROWS_AS((void)mass_properties(make_surface(open, {})), Error);
  Mesh flat;
  flat.points = PointSet(std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  flat.polygons = {{0, 1, 2}, {2, 1, 0}};
  CHECK(!mass_properties(make_surface(flat, {})));
}

TEST_CASE("mass: scaled, moved, and of solids of cells") {
  std::mt19937_64 random(49);
  for (int round = 0; round < 12; ++round) {
    CAPTURE(round);
    std::set<Cell> cells;
    while (cells.size() < 6) {
      cells.insert({static_cast<int>(random() % 3), static_cast<int>(random() % 3),
                    static_cast<int>(random() % 3)});
    }
    std::vector<Piece> pieces;
    for (const Cell& c : cells) {
      pieces.push_back(
          {rational_point(c[0], c[1], c[2]), rational_point(c[0] + 1, c[1] + 1, c[2] + 1)});
    }
    const MassProperties own = mass_of(mesh_of_cells(cells));
    check_same(own, put_together(pieces));
    // By 2^-3, and to another place.
    for (Piece& piece : pieces) {
      piece.low = piece.low / 8 + rational_point(100, -7, 0.5);
      piece.high = piece.high / 8 + rational_point(100, -7, 0.5);
    }
    const MassProperties moved = put_together(pieces);
    CHECK(moved.volume * 512 == own.volume);
    CHECK(moved.moments[4] * (512 * 64) == own.moments[4]);
    check_same(mass_of(boxes(pieces)), moved);
  }
}
