// SPDX-License-Identifier: MIT
// Surfaces, winding numbers and solids of meshes whose answers are closed forms.
#include "convexact/surface.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <optional>
#include <random>

#include "cells.hpp"
#include "convexact/io.hpp"
#include "convexact/overlay.hpp"
#include "expect_error.hpp"
#include "surface/common_point.hpp"
#include "surface/flat_polygon.hpp"

using namespace convexact;
using namespace support;

namespace {

Mesh reversed(Mesh mesh) {
  for (auto& polygon : mesh.polygons) std::reverse(polygon.begin(), polygon.end());
  return mesh;
}

Mesh joined(const Mesh& a, const Mesh& b) {
  std::vector<Point> points(a.points.doubles().begin(), a.points.doubles().end());
  points.insert(points.end(), b.points.doubles().begin(), b.points.doubles().end());
  Mesh mesh{PointSet(points), a.polygons, {}};
  for (auto polygon : b.polygons) {
    for (std::uint32_t& corner : polygon) corner += std::uint32_t(a.points.size());
    mesh.polygons.push_back(polygon);
  }
  return mesh;
}

Mesh cube(double low, double high) { return box_mesh({{low, low, low}, {high, high, high}}); }

Rational volume_of(const Mesh& mesh) {
  const Measured volume = solid_volume(make_surface(mesh), 96, true);
  CHECK(volume.bounds.contains(*volume.exact));
  return *volume.exact;
}

RationalPoint at(const Rational& x, const Rational& y, const Rational& z) { return {x, y, z}; }

// A grid of 5 by 5 squares whose sides are glued, on random points of a grid: a torus, or if one
// side is glued the other way round, a Klein bottle. It crosses itself.
Mesh glued_grid(bool is_klein, std::mt19937& random) {
  std::set<std::array<int, 3>> taken;
  std::vector<Point> points;
  while (points.size() < 25) {
    const std::array<int, 3> p{int(random() % 8), int(random() % 8), int(random() % 8)};
    if (taken.insert(p).second) points.emplace_back(p[0], p[1], p[2]);
  }
  const auto corner = [&](std::uint32_t i, std::uint32_t j) {
    const std::uint32_t row = i == 5 && is_klein ? 10 - j : j;
    return i % 5 * 5 + row % 5;
  };
  Mesh mesh{PointSet(points), {}, {}};
  for (std::uint32_t i = 0; i < 5; ++i) {
    for (std::uint32_t j = 0; j < 5; ++j) {
      const std::uint32_t a = corner(i, j), b = corner(i + 1, j), c = corner(i + 1, j + 1),
                          d = corner(i, j + 1);
      mesh.polygons.push_back({a, b, c});
      mesh.polygons.push_back({a, c, d});
    }
  }
  for (auto& polygon : mesh.polygons) {
    if (random() % 2 == 0) std::swap(polygon[0], polygon[1]);
  }
  return mesh;
}

// The sum of the solid angles of the triangles over 4 pi [van Oosterom and Strackee 1983].
double turns_about(const Surface& surface, const Point& x) {
  double sum = 0;
  for (const auto& triangle : surface.triangles) {
    const Point a = surface.points.doubles()[triangle[0].index()] - x,
                b = surface.points.doubles()[triangle[1].index()] - x,
                c = surface.points.doubles()[triangle[2].index()] - x;
    sum += 2 * std::atan2(a.dot(b.cross(c)), a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() +
                                                 b.dot(c) * a.norm() + c.dot(a) * b.norm());
  }
  return sum / (4 * 3.14159265358979323846);
}

}  // namespace

TEST_CASE("make_surface: a cube, however it is written") {
  const Surface surface = make_surface(cube(0, 1));
  CHECK(surface.points.size() == 8);
  CHECK(surface.triangles.size() == 12);
  CHECK(surface.is_closed);
  CHECK(surface.components.size() == 1);
  CHECK(surface.fans.empty());
  const Surface turned = make_surface(reversed(cube(0, 1)));
  CHECK(turned.triangles == surface.triangles);
  CHECK(turned.components[0].is_reversed);
  CHECK(turned.components[0].turned == 12);
  const Surface kept = make_surface(reversed(cube(0, 1)), {.orient = Orient::Keep});
  CHECK(kept.is_closed);
  CHECK(kept.triangles != surface.triangles);
  // Points once for each face, and one that no face uses, twice.
  Mesh loose;
  std::vector<Point> points;
  const Mesh original = cube(0, 1);
  for (const auto& polygon : original.polygons) {
    auto& own = loose.polygons.emplace_back();
    for (const std::uint32_t corner : polygon) {
      own.push_back(std::uint32_t(points.size()));
      points.push_back(original.points.doubles()[corner]);
    }
  }
  points.emplace_back(5, 5, 5);
  points.emplace_back(5, 5, 5);
  loose.points = PointSet(points);
  const Surface welded = make_surface(loose);
  CHECK(welded.triangles == surface.triangles);
  CHECK(welded.repeated_points == 17);
  CHECK(welded.unused.size() == 1);
}

TEST_CASE("make_surface: winding numbers of a cube") {
  const Surface surface = make_surface(cube(0, 1));
  const Winding winding(surface);
  const Rational half(1, 2);
  CHECK(winding(at(half, half, half)) == 1);
  CHECK(winding(at(Rational(1, 3), Rational(1, 3), Rational(1, 7))) == 1);
  CHECK(winding(at(2, half, half)) == 0);
  CHECK(winding(at(half, half, -1)) == 0);
  CHECK(winding(at(half, half, 2)) == 0);
  CHECK(winding(at(0, 0, -1)) == 0);
  CHECK(winding(at(0, half, half)) == std::nullopt);
  CHECK(winding(at(0, 0, half)) == std::nullopt);
  CHECK(winding(at(1, 1, 1)) == std::nullopt);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    RationalPoint middle = RationalPoint::Zero();
    for (const PointId p : surface.triangles[t]) middle += surface.points[p] / Rational(3);
    CHECK(winding.beside(TriangleId(t), middle) == std::pair(0L, 1L));
  }
}

TEST_CASE("solid_volume: cells, crossing cubes, shells in shells") {
  CHECK(volume_of(mesh_of_cells(l_cells())) == 3);
  CHECK(volume_of(mesh_of_cells(ring_cells())) == 8);
  CHECK(volume_of(mesh_of_cells(cross_cells())) == 7);
  // 8 + 8 - 1.
  CHECK(volume_of(joined(cube(0, 2), cube(1, 3))) == 15);
  CHECK(volume_of(joined(cube(0, 2), reversed(cube(1, 3)))) == 15);
  // A void in a cube, as given and with everything turned; and a body in the void.
  const Mesh shell = joined(cube(0, 4), reversed(cube(1, 3)));
  CHECK(volume_of(shell) == 64 - 8);
  CHECK(volume_of(reversed(shell)) == 64 - 8);
  const Mesh body = joined(shell, box_mesh({{1.5, 1.5, 1.5}, {2.5, 2.5, 2.5}}));
  CHECK(volume_of(body) == 64 - 8 + 1);
  CHECK(volume_of(reversed(body)) == 64 - 8 + 1);
  // One cube twice, also in opposite directions, and a cube within a cube.
  CHECK(volume_of(joined(cube(0, 1), cube(0, 1))) == 1);
  CHECK(volume_of(joined(cube(0, 2), cube(0.5, 1))) == 8);
  CHECK(volume_of(joined(cube(0, 1), cube(1, 2))) == 2);
  CHECK(volume_of(joined(box_mesh({{0, 0, 0}, {1, 1, 1}}), box_mesh({{1, 0, 0}, {2, 2, 1}}))) == 3);
}

TEST_CASE("make_surface: nesting is reported, and does not depend on the order") {
  const Mesh shell = joined(cube(0, 4), reversed(cube(1, 3)));
  const Surface good = make_surface(shell), bad = make_surface(reversed(shell));
  CHECK(good.triangles == bad.triangles);
  CHECK_FALSE(good.components[0].is_reversed);
  CHECK(bad.components[0].is_reversed);
  CHECK(bad.components[1].is_reversed);
  const Winding winding(bad);
  CHECK(winding(at(Rational(1, 2), 2, 2)) == 1);
  CHECK(winding(at(2, 2, 2)) == 0);
}

TEST_CASE("make_surface: a single side") {
  // A strip of five triangles that closes with a half turn: triangles k, k+1, k+2 modulo 5.
  Mesh strip;
  strip.points =
      PointSet(std::vector<Point>{{0, 0, 0}, {2, 0, 1}, {3, 2, 0}, {1, 3, 2}, {-1, 2, 1}});
  for (std::uint32_t k = 0; k < 5; ++k) strip.polygons.push_back({k, (k + 1) % 5, (k + 2) % 5});
  const Surface surface = make_surface(strip);
  CHECK_FALSE(surface.is_closed);
  CHECK(surface.components.size() == 1);
  CHECK_FALSE(surface.components[0].is_orientable);
  CHECK(surface.components[0].border_edges == 5);
  CHECK(surface.contradictions > 0);
  CHECK(error_of([&] { return Winding(surface); }).code() == ErrorCode::InvalidArgument);
}

TEST_CASE("make_surface: boxes that share an edge or a corner") {
  for (const double y : {1.0, 2.0}) {
    const Mesh two = joined(cube(0, 1), box_mesh({{1, 1, y - 1}, {2, 2, y}}));
    const Surface surface = make_surface(two);
    CHECK(surface.is_closed);
    CHECK(surface.components.size() == (y == 1.0 ? 1 : 2));
    CHECK(surface.components[0].branching_edges == (y == 1.0 ? 1 : 0));
    CHECK(volume_of(two) == 2);
  }
}

TEST_CASE("make_surface: sheets, borders and triangles without area") {
  Mesh open = cube(0, 1);
  open.polygons.pop_back();
  const Surface box = make_surface(open);
  CHECK_FALSE(box.is_closed);
  CHECK(box.components[0].border_edges == 4);

  Mesh sheet{
      PointSet(std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), {{0, 1, 2}, {0, 2, 1}}, {}};
  const Surface doubled = make_surface(sheet);
  CHECK(doubled.is_closed);
  CHECK(*solid_volume(doubled, 64, true).exact == 0);
  CHECK(Winding(doubled)(at(Rational(1, 4), Rational(1, 4), 0)) == std::nullopt);
  CHECK(Winding(doubled)(at(Rational(1, 4), Rational(1, 4), 1)) == 0);

  Mesh flat{
      PointSet(std::vector<Point>{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}), {{0, 1, 2}, {0, 0, 1}}, {}};
  const Surface lines = make_surface(flat);
  CHECK(lines.triangles.size() == 2);
  CHECK(lines.flat_triangles == 2);
  CHECK(lines.components[0].is_flat);
  CHECK(error_of([] { return make_surface(Mesh{}); }).code() == ErrorCode::InvalidArgument);
}

TEST_CASE("make_surface: a triangle with two equal corners, from whichever it begins") {
  const PointSet points(std::vector<Point>{{0, 0, 0}, {1, 0, 0}});
  const Surface first = make_surface({points, {{0, 0, 1}}, {}});
  for (const std::vector<std::uint32_t>& polygon :
       std::vector<std::vector<std::uint32_t>>{{0, 1, 0}, {1, 0, 0}, {0, 1, 1}, {0, 0, 1, 1}}) {
    CHECK(make_surface({points, {polygon}, {}}).triangles == first.triangles);
  }
}

TEST_CASE("make_surface: polygons are cut into triangles with their area") {
  const std::vector<Point> points = {{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {2, 3, 0},
                                     {2, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}};
  // A U with corners on its sides, tilted so that no coordinate is constant.
  std::vector<Point> tilted;
  for (const Point& p : points)
    tilted.emplace_back(p[0] + p[1], p[1] - 2 * p[0], 3 * p[0] + 5 * p[1]);
  const auto area_of = [](const Surface& s) {
    RationalVector3 sum = RationalVector3::Zero();
    for (const auto& [a, b, c] : s.triangles) {
      sum += RationalVector3(s.points[b] - s.points[a])
                 .cross(RationalVector3(s.points[c] - s.points[a]));
    }
    return sum;
  };
  const Mesh mesh{PointSet(tilted), {{0, 1, 2, 3, 4, 5, 6, 7}}, {}};
  const Surface surface = make_surface(mesh);
  CHECK(surface.triangles.size() == 6);
  CHECK(surface.fans.empty());
  CHECK(surface.flat_triangles == 0);
  // Twice 10, the area of the U, times the cofactors of the tilt.
  const RationalVector3 u = to_rational(Point(1, -2, 3)), v = to_rational(Point(1, 1, 5));
  CHECK(area_of(surface) == RationalVector3(u.cross(v) * Rational(20)));
  // From another corner, and the other way round.
  const Mesh rotated{PointSet(tilted), {{3, 4, 5, 6, 7, 0, 1, 2}}, {}};
  CHECK(make_surface(rotated).triangles == surface.triangles);
  const Surface back = make_surface({PointSet(tilted), {{7, 6, 5, 4, 3, 2, 1, 0}}, {}});
  CHECK(area_of(back) == RationalVector3(-area_of(surface)));

  const Surface bent =
      make_surface({PointSet(std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}}),
                    {{0, 1, 2, 3}},
                    {}});
  CHECK(bent.fans == std::vector<std::size_t>{0});
  CHECK(bent.triangles.size() == 2);
  const Surface bow =
      make_surface({PointSet(std::vector<Point>{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}),
                    {{0, 1, 2, 3}},
                    {}});
  CHECK(bow.fans == std::vector<std::size_t>{0});
  // It has an area, and each of its corners looks like an ear.
  const Surface pentagram = make_surface(
      {PointSet(std::vector<Point>{{2, 0, 0}, {4, 2, 0}, {3, 4, 0}, {1, 4, 0}, {0, 2, 0}}),
       {{0, 2, 4, 1, 3}},
       {}});
  CHECK(pentagram.fans == std::vector<std::size_t>{0});
}

// The ear with the lowest tip first, by the definition: every corner is asked again after each cut.
std::vector<std::array<PointId, 3>> ears_by_definition(const PointSet& points,
                                                       std::vector<PointId> corners) {
  const PlaneView view(points, 2);
  const auto ear_at = [&](std::size_t k) {
    const std::size_t n = corners.size();
    return std::array<PointId, 3>{corners[(k + n - 1) % n], corners[k], corners[(k + 1) % n]};
  };
  const auto is_ear = [&](std::size_t k) {
    const auto ear = ear_at(k);
    return view.turn(ear[0], ear[1], ear[2]) == Sign::Positive &&
           std::none_of(corners.begin(), corners.end(), [&](PointId p) {
             return std::find(ear.begin(), ear.end(), p) == ear.end() && view.is_in(ear, p);
           });
  };
  std::vector<std::array<PointId, 3>> triangles;
  while (corners.size() > 3) {
    std::optional<std::size_t> tip;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      if (is_ear(k) && (!tip || corners[k] < corners[*tip])) tip = k;
    }
    REQUIRE(tip);
    triangles.push_back(ear_at(*tip));
    corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(*tip));
  }
  triangles.push_back({corners[0], corners[1], corners[2]});
  return triangles;
}

TEST_CASE("clip_ears: the lowest ear first, by the definition, on polygons around a point") {
  std::mt19937 random(17);
  for (int round = 0; round < 60; ++round) {
    // Directions in order, at any distances: the polygon is simple. Multiples of them are integers.
    std::vector<std::array<int, 2>> directions;
    for (int x = -5; x <= 5; ++x) {
      for (int y = -5; y <= 5; ++y) {
        if (std::gcd(x, y) == 1 && random() % 3 != 0) directions.push_back({x, y});
      }
    }
    std::sort(directions.begin(), directions.end(), [](const auto& a, const auto& b) {
      return std::atan2(a[1], a[0]) < std::atan2(b[1], b[0]);
    });
    std::vector<Point> at;
    std::vector<PointId> corners;
    for (const auto& [x, y] : directions) {
      const double far = 1 + random() % 9;
      at.emplace_back(far * x, far * y, 0);
    }
    // As in a surface, ids are in the order of the points.
    std::vector<Point> points = at;
    const auto comes_before = [](const Point& a, const Point& b) {
      return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
    };
    std::sort(points.begin(), points.end(), comes_before);
    for (const Point& p : at) {
      const auto found = std::lower_bound(points.begin(), points.end(), p, comes_before);
      corners.emplace_back(static_cast<std::size_t>(found - points.begin()));
    }
    const PointSet set(points);
    const auto clipped = clip_ears(set, corners);
    REQUIRE(clipped.index() == 0);
    CHECK(std::get<0>(clipped) == ears_by_definition(set, corners));
  }
}

TEST_CASE("make_surface: faces that are none") {
  const std::vector<Point> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  for (const std::vector<std::uint32_t>& face :
       {std::vector<std::uint32_t>{}, std::vector<std::uint32_t>{0, 1, 3}}) {
    const Mesh mesh{PointSet(points), {face}, {}};
    CHECK(error_of([&] { return make_surface(mesh); }).code() == ErrorCode::InvalidArgument);
  }
}

TEST_CASE("winding numbers and volumes of random unions of cells") {
  std::mt19937 random(17);
  for (int round = 0; round < 60; ++round) {
    std::set<Cell> cells;
    const std::size_t count = 1 + random() % 12;
    while (cells.size() < count) {
      cells.insert({int(random() % 3), int(random() % 3), int(random() % 3)});
    }
    CAPTURE(round);
    const Surface surface = make_surface(mesh_of_cells(cells));
    REQUIRE(surface.is_closed);
    CHECK(*solid_volume(surface, 96, true).exact == Rational(cells.size()));
    const Winding winding(surface);
    const Rational half(1, 2);
    for (int k = 0; k < 125; ++k) {
      const Cell cell{k % 5 - 1, k / 5 % 5 - 1, k / 25 - 1};
      const std::optional<long> at_center =
          winding(at(cell[0] + half, cell[1] + half, cell[2] + half));
      CHECK((at_center && (*at_center != 0) == cells.contains(cell)));
      // A square lies on the boundary if just one of the cells beside it is there.
      for (int axis = 0; axis < 3; ++axis) {
        Cell before = cell;
        --before[axis];
        RationalPoint middle = at(cell[0] + half, cell[1] + half, cell[2] + half);
        middle[axis] -= half;
        CHECK((winding(middle) == std::nullopt) ==
              (cells.contains(cell) != cells.contains(before)));
      }
    }
  }
}

TEST_CASE("winding numbers: powers of two change none, up to the ends of the doubles") {
  std::mt19937 random(19);
  const Mesh mesh = joined(mesh_of_cells(l_cells()), joined(cube(8, 12), reversed(cube(9, 10))));
  const Surface surface = make_surface(mesh);
  const Winding winding(surface);
  // On corners, edges and faces, on none of them, and between doubles.
  std::vector<RationalPoint> places;
  for (int k = 0; k < 200; ++k) {
    const auto coordinate = [&] { return Rational(int(random() % 40) - 3, 1 + int(random() % 3)); };
    places.push_back({coordinate(), coordinate(), coordinate()});
  }
  for (const int exponent : {1019, 700, -700, -1022, -1070}) {
    CAPTURE(exponent);
    std::vector<Point> points;
    for (const Point& p : mesh.points.doubles()) {
      points.push_back(p.unaryExpr([&](double x) { return std::ldexp(x, exponent); }));
    }
    const Surface scaled = make_surface({PointSet(points), mesh.polygons, {}});
    const Winding other(scaled);
    for (const RationalPoint& x : places) {
      const RationalPoint there = x * scale_by_power_of_two(Rational(1), exponent);
      CHECK(other(there) == winding(x));
      const RationalVector3 up(1, 2, 3);
      CHECK(other.towards(there, up) == winding.towards(x, up));
    }
  }
}

TEST_CASE("make_surface: the order of points and faces, and their sizes, change nothing") {
  std::mt19937 random(18);
  const Mesh mesh = joined(mesh_of_cells(l_cells()), joined(cube(8, 12), reversed(cube(9, 10))));
  const Surface surface = make_surface(mesh);
  for (const int exponent : {0, 500, -500, -1070}) {
    CAPTURE(exponent);
    std::vector<std::uint32_t> place(mesh.points.size());
    for (std::uint32_t k = 0; k < place.size(); ++k) place[k] = k;
    std::shuffle(place.begin(), place.end(), random);
    std::vector<Point> points(place.size());
    for (std::uint32_t k = 0; k < place.size(); ++k) {
      points[place[k]] =
          mesh.points.doubles()[k].unaryExpr([&](double x) { return std::ldexp(x, exponent); });
    }
    Mesh shuffled{PointSet(points), mesh.polygons, {}};
    for (auto& polygon : shuffled.polygons) {
      for (std::uint32_t& corner : polygon) corner = place[corner];
      std::rotate(polygon.begin(), polygon.begin() + long(random() % polygon.size()),
                  polygon.end());
    }
    std::shuffle(shuffled.polygons.begin(), shuffled.polygons.end(), random);
    const Surface other = make_surface(shuffled);
    CHECK(other.triangles == surface.triangles);
    CHECK(other.component == surface.component);
    // 3 cells, and a cube of 4 without one of 1.
    const Rational unit = to_rational(Point(std::ldexp(1.0, exponent), 0, 0))[0];
    CHECK(*solid_volume(other, 96, true).exact == Rational(66 * unit * unit * unit));
  }
}

TEST_CASE("winding numbers of tangled tori are sums of solid angles; Klein bottles have none") {
  std::mt19937 random(19);
  long largest = 0;
  for (int round = 0; round < 20; ++round) {
    CAPTURE(round);
    const Surface torus = make_surface(glued_grid(false, random));
    REQUIRE(torus.is_closed);
    CHECK(torus.components[0].is_orientable);
    CHECK(torus.contradictions == 0);
    const Winding winding(torus);
    for (int k = 0; k < 50; ++k) {
      const auto coordinate = [&] { return double(random() % 7000) / 1024 + 0x1p-30; };
      const Point x(coordinate(), coordinate(), coordinate());
      const std::optional<long> found = winding(to_rational(x));
      REQUIRE(found.has_value());
      CHECK(turns_about(torus, x) == doctest::Approx(double(*found)).epsilon(1e-6));
      largest = std::max(largest, std::abs(*found));
    }
    const Surface bottle = make_surface(glued_grid(true, random));
    CHECK_FALSE(bottle.is_closed);
    CHECK_FALSE(bottle.components[0].is_orientable);
    CHECK(bottle.components[0].border_edges == 0);
    CHECK(bottle.contradictions > 0);
  }
  CHECK(largest > 1);
}

TEST_CASE("make_surface: points that are no doubles, T-junctions") {
  const Mesh unit = cube(0, 1);
  std::vector<RationalPoint> points;
  for (std::size_t k = 0; k < unit.points.size(); ++k) {
    points.push_back(unit.points[PointId(k)] / Rational(3));
  }
  const Surface third = make_surface({PointSet(points), unit.polygons, {}});
  CHECK(third.triangles == make_surface(unit).triangles);
  CHECK(*solid_volume(third, 96, true).exact == Rational(1, 27));
  const Winding winding(third);
  CHECK(winding(at(Rational(1, 3), Rational(1, 4), Rational(1, 4))) == std::nullopt);
  CHECK(winding(at(Rational(3, 10), Rational(1, 4), Rational(1, 4))) == 1);
  CHECK(winding(at(Rational(4, 10), Rational(1, 4), Rational(1, 4))) == 0);

  // One side of a cube is two rectangles, whose common side ends within edges of the others.
  Mesh halved = unit;
  halved.polygons.erase(halved.polygons.begin());
  const Mesh halves{PointSet(std::vector<Point>{
                        {0, 0, 0}, {0, 1, 0}, {0, 0, 0.5}, {0, 1, 0.5}, {0, 0, 1}, {0, 1, 1}}),
                    {{0, 2, 3, 1}, {2, 4, 5, 3}},
                    {}};
  CHECK_FALSE(make_surface(joined(halved, halves)).is_closed);
}

// ---- Triangles in one plane, needles, and edges with any number of triangles

TEST_CASE("common points: a triangle strictly inside another one, in any plane, from any corner") {
  const std::vector<RationalPoint> flat = {at(0, 0, 0), at(8, 0, 0), at(0, 8, 0),
                                           at(1, 1, 0), at(2, 1, 0), at(1, 2, 0)};
  // The plane of z = 0, and planes that are parallel to no axis.
  for (const RationalVector3& lift :
       {RationalVector3(0, 0, 0), RationalVector3(1, 0, 0), RationalVector3(1, 3, 0)}) {
    for (int turn = 0; turn < 3; ++turn) {
      std::vector<RationalPoint> points;
      for (const RationalPoint& p : flat) {
        const RationalPoint q(p[0], p[1], lift[0] * p[0] + lift[1] * p[1]);
        points.push_back(at(q[turn], q[(turn + 1) % 3], q[(turn + 2) % 3]));
      }
      const PointSet set(points);
      std::array<std::uint32_t, 3> small{3, 4, 5};
      do {
        const Triangle s{PointId(small[0]), PointId(small[1]), PointId(small[2])};
        for (std::uint32_t k = 0; k < 3; ++k) {
          const Triangle big{PointId(k), PointId((k + 1) % 3), PointId((k + 2) % 3)};
          CHECK(have_common_point(set, s, big));
          CHECK(have_common_point(set, big, s));
          CHECK(cross(set, s, big));
          CHECK(cross(set, big, s));
        }
      } while (std::next_permutation(small.begin(), small.end()));
    }
  }
}

TEST_CASE(
    "solid_volume: a shell whose face lies in one triangle of another shell is not within it") {
  // 8^3, whatever lies in it: the small box touches the large one from inside, so that it is no
  // cavity. x + y < 8 and x > y on its top, which lies in one triangle, however the square is cut.
  const Mesh box = box_mesh({{5, 1, 7}, {6, 1.5, 8}});
  for (const Mesh& inner : {box, reversed(box)}) {
    CHECK(volume_of(joined(cube(0, 8), inner)) == 512);
    CHECK(volume_of(joined(inner, cube(0, 8))) == 512);
  }
  // Apart from it, and inside out, the small box is a cavity.
  CHECK(volume_of(joined(cube(0, 8), reversed(box_mesh({{5, 1, 6}, {6, 1.5, 7}})))) ==
        512 - Rational(1, 2));
}

TEST_CASE("make_surface: the sign of the volume of needles is the exact one") {
  const auto is_reversed = [](const Mesh& mesh) {
    return make_surface(mesh).components[0].is_reversed;
  };
  const char* folder = std::getenv("CONVEXACT_TEST_DATA");
  REQUIRE(folder != nullptr);
  CHECK_FALSE(is_reversed(read_mesh(std::string(folder) + "/faults/m43.obj")));
  std::mt19937_64 random(43);
  const auto draw = [&] { return std::ldexp(double(random() >> 11), -52) - 1; };
  std::size_t reversed_ones = 0;
  for (int run = 0; run < 3000; ++run) {
    const Point along(draw(), draw(), draw());
    const double width = std::ldexp(1.0, -40 - run % 14);
    std::vector<Point> p;
    for (int k = 0; k < 4; ++k) {
      p.emplace_back(draw() * along + width * Point(draw(), draw(), draw()));
    }
    const Mesh mesh{PointSet(p), {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}, {}};
    const RationalPoint o = to_rational(p[0]);
    const Rational six = RationalVector3(to_rational(p[1]) - o)
                             .dot(RationalVector3(to_rational(p[2]) - o)
                                      .cross(RationalVector3(to_rational(p[3]) - o)));
    if (six == 0) continue;
    CAPTURE(run);
    CHECK(is_reversed(mesh) == (six < 0));
    reversed_ones += six < 0;
  }
  CHECK(reversed_ones > 1000);
}

TEST_CASE("make_surface: an edge with one triangle is a border, one with three or more branches") {
  const std::vector<Point> points = {{0, 0, 0}, {0, 0, 1},  {1, 0, 0},
                                     {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  for (std::uint32_t triangles = 1; triangles <= 4; ++triangles) {
    Mesh fan{PointSet(points), {}, {}};
    for (std::uint32_t k = 0; k < triangles; ++k) fan.polygons.push_back({0, 1, 2 + k});
    const SurfaceComponent component = make_surface(fan).components.at(0);
    CHECK(component.border_edges == 2 * triangles + (triangles == 1 ? 1 : 0));
    CHECK(component.branching_edges == (triangles > 2 ? 1 : 0));
  }
}
