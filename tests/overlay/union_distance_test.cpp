// SPDX-License-Identifier: MIT
// Distances between a surface and a union of parts. Expected values: closed forms, the definition
// (the least distance to a triangle of a facet), and dense rational samples.
#include <doctest/doctest.h>

#include <algorithm>
#include <random>

#include "convexact/hull.hpp"
#include "convexact/overlay.hpp"
#include "expect_error.hpp"
#include "property.hpp"
#include "shapes/makers.hpp"
#include "sweep.hpp"
#include "task/parallel.hpp"
using namespace convexact;

namespace {

Rational squared(const RationalVector3& v) { return v.squaredNorm(); }

ConvexPart solid_part(const std::vector<Point>& points) {
  const PointSet set(points);
  ConvexPart part;
  part.dimension = 3;
  part.solid = to_polytope(std::get<Hull>(convex_hull(set)), set);
  part.vertices = part.solid->vertices;
  part.halfspaces = part.solid->planes;
  part.box = bounding_box(part.vertices);
  return part;
}

ConvexPart part_of_box(const Point& low, const Point& high) {
  std::vector<Point> corners;
  for (int k = 0; k < 8; ++k) {
    corners.push_back(
        {k & 1 ? high[0] : low[0], k & 2 ? high[1] : low[1], k & 4 ? high[2] : low[2]});
  }
  return solid_part(corners);
}

ConvexPart cell(double x, double y, double z) {
  return part_of_box({x, y, z}, {x + 1, y + 1, z + 1});
}

void add_both(std::vector<Halfspace>& list, const RationalVector3& normal,
              const RationalPoint& at) {
  const Rational offset = -normal.dot(at);
  list.emplace_back(normal, offset);
  list.emplace_back(RationalVector3(-normal), Rational(-offset));
}

// Counter-clockwise corners of a convex polygon in a plane.
ConvexPart polygon_part(const std::vector<RationalPoint>& corners) {
  ConvexPart part;
  part.dimension = 2;
  part.vertices = corners;
  const RationalVector3 a = corners[1] - corners[0], b = corners[2] - corners[0];
  const RationalVector3 normal = a.cross(b);
  add_both(part.halfspaces, normal, corners[0]);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const RationalVector3 along = corners[(k + 1) % corners.size()] - corners[k];
    const RationalVector3 outward = along.cross(normal);
    part.halfspaces.emplace_back(outward, Rational(-outward.dot(corners[k])));
  }
  part.box = bounding_box(part.vertices);
  return part;
}

ConvexPart segment_part(const RationalPoint& a, const RationalPoint& b) {
  ConvexPart part;
  part.dimension = 1;
  part.vertices = {a, b};
  const RationalVector3 along = b - a;
  for (int k = 0; k < 3; ++k) {
    const RationalVector3 axis = RationalVector3::Unit(k);
    const RationalVector3 normal = along.cross(axis);
    if (!normal.isZero()) add_both(part.halfspaces, normal, a);
  }
  part.halfspaces.emplace_back(along, Rational(-along.dot(b)));
  part.halfspaces.emplace_back(RationalVector3(-along), Rational(along.dot(a)));
  part.box = bounding_box(part.vertices);
  return part;
}

ConvexPart point_part(const RationalPoint& a) {
  ConvexPart part;
  part.dimension = 0;
  part.vertices = {a};
  for (int k = 0; k < 3; ++k) add_both(part.halfspaces, RationalVector3::Unit(k), a);
  part.box = bounding_box(part.vertices);
  return part;
}

// A piece of a triangle that stands for itself.
UncoveredPiece piece(std::vector<RationalPoint> corners, std::size_t triangle = 0) {
  return {TriangleId(triangle), std::move(corners), Rational(1)};
}

// ---- The definition

Rational to_segment(const RationalPoint& a, const RationalPoint& b, const RationalPoint& x) {
  const RationalVector3 along = b - a, from = x - a;
  const Rational length = squared(along);
  Rational t = length == 0 ? Rational(0) : Rational(from.dot(along) / length);
  t = std::clamp<Rational>(t, 0, 1);
  return squared(from - t * along);
}

Rational to_triangle(const std::array<RationalPoint, 3>& t, const RationalPoint& x) {
  Rational best =
      std::min({to_segment(t[0], t[1], x), to_segment(t[1], t[2], x), to_segment(t[2], t[0], x)});
  const RationalVector3 u = t[1] - t[0], v = t[2] - t[0], normal = u.cross(v);
  if (normal.isZero()) return best;
  const RationalVector3 from = x - t[0];
  const Rational height = from.dot(normal);
  for (int k = 0; k < 3; ++k) {
    const RationalVector3 side = t[(k + 1) % 3] - t[k], there = x - t[k];
    if (normal.dot(side.cross(there)) < 0) return best;
  }
  return std::min<Rational>(best, height * height / squared(normal));
}

Rational to_part(const ConvexPart& part, const RationalPoint& x) {
  const bool is_inside = std::all_of(part.halfspaces.begin(), part.halfspaces.end(),
                                     [&](const Halfspace& h) { return h(x) <= 0; });
  if (is_inside) return 0;
  const std::vector<RationalPoint>& v = part.vertices;
  Rational best = squared(x - v[0]);
  if (part.solid) {
    for (const auto& facet : part.solid->facets) {
      for (std::size_t k = 1; k + 1 < facet.size(); ++k) {
        best = std::min(best, to_triangle({v[facet[0]], v[facet[k]], v[facet[k + 1]]}, x));
      }
    }
    return best;
  }
  // Any triangle of vertices of a flat part lies in it, and they cover it.
  for (std::size_t i = 0; i < v.size(); ++i) {
    for (std::size_t k = 0; k < v.size(); ++k) {
      best = std::min(best, to_triangle({v[0], v[i], v[k]}, x));
    }
  }
  return best;
}

Rational to_union(const std::vector<ConvexPart>& parts, const RationalPoint& x) {
  Rational best = to_part(parts[0], x);
  for (const ConvexPart& part : parts) best = std::min(best, to_part(part, x));
  return best;
}

// Points of a triangle with barycentric coordinates i/n, k/n.
std::vector<RationalPoint> samples(const std::vector<RationalPoint>& t, int n) {
  std::vector<RationalPoint> list;
  for (int i = 0; i <= n; ++i) {
    for (int k = 0; i + k <= n; ++k) {
      const Rational u(i, n), v(k, n);
      const RationalPoint x = t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]);
      list.push_back(x);
    }
  }
  return list;
}

bool holds_root_of(const Enclosure& bounds, const Rational& square) {
  const Rational low = bounds.low(), high = bounds.high();
  return low >= 0 && low * low <= square && square <= high * high;
}

// Whether the bounds of a distance are as close as they should be, for this squared diameter.
bool is_close(const DirectedDistance& distance, const Rational& squared_diameter) {
  const Rational width = distance.bounds.width() * kDistanceSteps;
  return width * width <= squared_diameter;
}

constexpr double kHalf = 0.5;

// ---- Surfaces

void add_box_faces(std::vector<Point>& points, std::vector<std::vector<std::uint32_t>>& faces,
                   const Point& low, const Point& high, bool inward = false) {
  const auto first = static_cast<std::uint32_t>(points.size());
  for (int k = 0; k < 8; ++k) {
    points.push_back(
        {k & 1 ? high[0] : low[0], k & 2 ? high[1] : low[1], k & 4 ? high[2] : low[2]});
  }
  for (std::vector<std::uint32_t> face : {std::vector<std::uint32_t>{0, 2, 3, 1},
                                          {4, 5, 7, 6},
                                          {0, 1, 5, 4},
                                          {2, 6, 7, 3},
                                          {0, 4, 6, 2},
                                          {1, 3, 7, 5}}) {
    if (inward) std::reverse(face.begin(), face.end());
    for (std::uint32_t& corner : face) corner += first;
    faces.push_back(face);
  }
}

Surface surface_of(std::vector<Point> points, std::vector<std::vector<std::uint32_t>> faces,
                   double unit = 1) {
  for (Point& y : points) y *= unit;
  return make_surface(Mesh{PointSet(points), std::move(faces), {}});
}

Surface box_surface(const Point& low, const Point& high) {
  std::vector<Point> points;
  std::vector<std::vector<std::uint32_t>> faces;
  add_box_faces(points, faces, low, high);
  return surface_of(points, faces);
}

// [0, 3]^2 x [0, 1] without [1, 2]^2 x [0, 1].
Surface ring_surface(double unit) {
  std::vector<Point> points;
  for (const double z : {0.0, 1.0}) {
    for (const auto& [x, y] : {std::pair{0.0, 0.0},
                               {3.0, 0.0},
                               {3.0, 3.0},
                               {0.0, 3.0},
                               {1.0, 1.0},
                               {2.0, 1.0},
                               {2.0, 2.0},
                               {1.0, 2.0}}) {
      points.push_back({x, y, z});
    }
  }
  std::vector<std::vector<std::uint32_t>> faces;
  for (std::uint32_t k = 0; k < 4; ++k) {
    const std::uint32_t n = (k + 1) % 4;
    faces.push_back({k, n, n + 8, k + 8});            // outside
    faces.push_back({n + 4, k + 4, k + 12, n + 12});  // in the hole
    faces.push_back({n, k, k + 4, n + 4});            // below
    faces.push_back({k + 8, n + 8, n + 12, k + 12});  // above
  }
  return surface_of(points, faces, unit);
}

// By the definition: 0 in the solid, else the distance to the nearest triangle.
Rational to_solid(const Surface& surface, const Winding* winding, const RationalPoint& x) {
  if (winding != nullptr) {
    const std::optional<long> number = (*winding)(x);
    if (!number || *number != 0) return 0;
  }
  std::optional<Rational> best;
  for (const auto& [a, b, c] : surface.triangles) {
    const Rational next = to_triangle({surface.points[a], surface.points[b], surface.points[c]}, x);
    if (!best || next < *best) best = next;
  }
  return *best;
}

}  // namespace

TEST_CASE("union_distance: cubes, their facets, edges and corners; the lowest part on a tie") {
  const std::vector<ConvexPart> parts{cell(0, 0, 0), cell(3, 0, 0), cell(1, 0, 0)};
  const UnionDistance distance(parts);
  CHECK(distance.parts().size() == 3);
  const auto expect = [&](const RationalPoint& x, std::size_t part, const RationalPoint& nearest,
                          const Rational& square) {
    const NearestPart found = distance(x);
    CHECK(found.part == part);
    CHECK(found.nearest == nearest);
    CHECK(found.squared == square);
  };
  expect({Rational(1, 2), Rational(1, 3), 2}, 0, {Rational(1, 2), Rational(1, 3), 1}, 1);
  expect({-1, 2, Rational(1, 2)}, 0, {0, 1, Rational(1, 2)}, 2);
  expect({-1, -1, -1}, 0, {0, 0, 0}, 3);
  expect({5, 2, 2}, 1, {4, 1, 1}, 3);
  // Between the second cube and the third; on the common side of the first and the third.
  expect({Rational(5, 2), 0, 0}, 1, {3, 0, 0}, Rational(1, 4));
  expect({1, Rational(1, 2), Rational(1, 2)}, 0, {1, Rational(1, 2), Rational(1, 2)}, 0);
  expect({1, Rational(1, 2), 4}, 0, {1, Rational(1, 2), 1}, 9);
  CHECK(distance.nearest_in(1, {0, 0, 0}) == RationalPoint(3, 0, 0));
}

TEST_CASE("union_distance: no part is refused") {
  CHECK(error_of([] { return UnionDistance({}).parts().size(); }).code() ==
        ErrorCode::InvalidArgument);
}

TEST_CASE("union_distance: polygons, segments and points") {
  const std::vector<ConvexPart> square{polygon_part({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}})};
  const UnionDistance to_square(square);
  CHECK(to_square({1, Rational(1, 3), 5}).nearest == RationalPoint(1, Rational(1, 3), 0));
  CHECK(to_square({1, 4, 1}).nearest == RationalPoint(1, 2, 0));
  CHECK(to_square({-1, -1, 1}).squared == 3);
  CHECK(to_square({1, 1, 0}).squared == 0);
  CHECK(to_square({2, 2, 0}).squared == 0);

  const std::vector<ConvexPart> mixed{point_part({5, 5, 5}), segment_part({0, 0, 0}, {1, 1, 0}),
                                      square[0]};
  const UnionDistance to_mixed(mixed);
  CHECK(to_mixed({5, 5, 7}).part == 0);
  CHECK(to_mixed({5, 5, 7}).squared == 4);
  CHECK(to_mixed({1, 1, 1}).part == 1);  // as near as the square
  CHECK(to_mixed({1, 1, 1}).squared == 1);
  CHECK(to_mixed({1, Rational(1, 2), 1}).part == 2);
  const std::vector<ConvexPart> segment{segment_part({0, 0, 0}, {3, 3, 3})};
  CHECK(UnionDistance(segment)({1, 0, 0}).nearest ==
        RationalPoint(Rational(1, 3), Rational(1, 3), Rational(1, 3)));
  CHECK(UnionDistance(segment)({-1, 0, 0}).nearest == RationalPoint(0, 0, 0));
}

TEST_CASE("union_distance: as the definition says, for random parts of any dimension" * sweep) {
  check_property("union_distance: brute force", [] {
    const auto seed = *rc::gen::inRange<std::uint64_t>(1, 1000000);
    std::mt19937_64 random(seed);
    const auto coordinate = [&] { return static_cast<double>(random() % 13) - 6; };
    std::vector<ConvexPart> parts;
    const std::size_t count = 1 + random() % 4;
    while (parts.size() < count) {
      const Point at(coordinate(), coordinate(), coordinate());
      std::vector<Point> points;
      for (int k = 0; k < 8; ++k) {
        points.push_back(at + Point(coordinate(), coordinate(), coordinate()) * kHalf);
      }
      const RationalPoint a = to_rational(points[0]), b = to_rational(points[1]),
                          c = to_rational(points[2]);
      const RationalVector3 ab = b - a, ac = c - a, normal = ab.cross(ac);
      switch (random() % 6) {
        case 0:
          parts.push_back(point_part(a));
          break;
        case 1:
          if (a != b) parts.push_back(segment_part(a, b));
          break;
        case 2:
          if (!normal.isZero()) parts.push_back(polygon_part({a, b, c}));
          break;
        default:
          if (std::holds_alternative<Hull>(convex_hull(PointSet(points)))) {
            parts.push_back(solid_part(points));
          }
      }
    }
    const UnionDistance distance(parts);
    for (int k = 0; k < 10; ++k) {
      const RationalPoint x(Rational(coordinate()) / 3, Rational(coordinate()) / 2,
                            Rational(coordinate()));
      const NearestPart found = distance(x);
      RC_ASSERT(found.squared == to_union(parts, x));
      RC_ASSERT(squared(x - found.nearest) == found.squared);
      RC_ASSERT(to_part(parts[found.part], found.nearest) == 0);
      for (std::size_t p = 0; p < found.part; ++p) RC_ASSERT(to_part(parts[p], x) > found.squared);
    }
  });
}

TEST_CASE("union_distance: at any scale, far away, and of parts of very different sizes") {
  for (const int exponent : {-300, 0, 300}) {
    const double unit = std::ldexp(1.0, exponent);
    const std::vector<ConvexPart> parts{part_of_box({0, 0, 0}, {unit, unit, unit}),
                                        part_of_box({3 * unit, 0, 0}, {4 * unit, unit, unit})};
    const UnionDistance distance(parts);
    const Rational u = to_rational(unit);
    CHECK(distance({-u, -u, -u}).squared == 3 * u * u);
    CHECK(distance({2 * u, 0, 2 * u}).squared == 2 * u * u);
    CHECK(distance({2 * u, 0, 2 * u}).part == 0);
    CHECK(distance({2 * u + u / 1000000, 0, 2 * u}).part == 1);
    // So far that doubles of the frame overflow.
    const Rational far = scale_by_power_of_two(u, 1100);
    const NearestPart found = distance({far, 0, 0});
    CHECK(found.part == 1);
    CHECK(found.squared == (far - 4 * u) * (far - 4 * u));
    const DirectedDistance directed =
        surface_to_union(std::vector{piece({{-u, 0, 0}, {-u, u, 0}, {0, 0, 0}})}, distance, u * u);
    CHECK(holds_root_of(directed.bounds, u * u));
    CHECK(is_close(directed, u * u));
  }
  const double tiny = 0x1p-200;
  const std::vector<ConvexPart> parts{cell(0, 0, 0),
                                      part_of_box({2, 0, 0}, {2 + 0x1p-50, tiny, tiny})};
  const UnionDistance distance(parts);
  CHECK(distance({2, 0, 2 * to_rational(tiny)}).squared == to_rational(tiny) * to_rational(tiny));
}

TEST_CASE("union_distance: the order of the parts changes the name of the nearest one only") {
  std::vector<ConvexPart> parts{cell(0, 0, 0), cell(2, 0, 0), cell(0, 2, 0), cell(2, 2, 0)};
  std::vector<ConvexPart> reversed(parts.rbegin(), parts.rend());
  const UnionDistance distance(parts), other(reversed);
  for (const Point& y : shapes::lattice(60, 4, 3)) {
    const RationalPoint x = to_rational(y);
    CHECK(distance(x).squared == other(x).squared);
  }
  CHECK(distance({Rational(3, 2), Rational(3, 2), 0}).part == 0);
  CHECK(other({Rational(3, 2), Rational(3, 2), 0}).part == 0);
}

TEST_CASE("farthest_found: a corner, or a centroid; the first of equal ones; nothing of nothing") {
  const std::vector<ConvexPart> parts{cell(0, 0, 0), cell(3, 0, 0)};
  const UnionDistance distance(parts);
  CHECK(!farthest_found({}, distance));
  // A square from one cube to the other: its corners are covered, its centroid is not.
  const Rational half(1, 2);
  const auto between = farthest_found(
      std::vector{piece({{1, 0, half}, {3, 0, half}, {3, 1, half}, {1, 1, half}}, 7)}, distance);
  REQUIRE(between);
  CHECK(between->triangle == TriangleId(7));
  CHECK(between->point == RationalPoint(2, half, half));
  CHECK(between->nearest.part == 0);
  CHECK(between->nearest.squared == 1);
  // Two triangles with the same farthest distance, and one nearer.
  const auto first = farthest_found(std::vector{piece({{0, 0, 1}, {1, 0, 1}, {0, 0, 2}}, 0),
                                                piece({{0, 0, 1}, {1, 0, 1}, {0, 0, 3}}, 1),
                                                piece({{3, 0, 1}, {4, 0, 1}, {3, 0, 3}}, 2)},
                                    distance);
  REQUIRE(first);
  CHECK(first->triangle == TriangleId(1));
  CHECK(first->point == RationalPoint(0, 0, 3));
  CHECK(first->nearest.squared == 4);
  // A distance that doubles of the frame cannot tell from 0.
  const Rational tiny = scale_by_power_of_two(Rational(1), -200);
  const auto close =
      farthest_found(std::vector{piece({{0, 0, 1}, {1, 0, 1}, {0, 0, 1 + tiny}}, 0)}, distance);
  REQUIRE(close);
  CHECK(close->nearest.squared == tiny * tiny);
}

TEST_CASE("is_within: below the distance not, at it and above it") {
  const std::vector<ConvexPart> parts{cell(0, 0, 0)};
  const UnionDistance distance(parts);
  // Largest distance: the corner (2, 2, 2), at the square root of 3.
  const std::vector<UncoveredPiece> pieces{piece({{1, 1, 1}, {2, 1, 1}, {2, 2, 2}}, 4)};
  const Rational ulp = scale_by_power_of_two(Rational(1), -400);
  CHECK(is_within(pieces, distance, 3).reach == Reach::Within);
  CHECK(is_within(pieces, distance, 3 + ulp).reach == Reach::Within);
  const WithinDistance beyond = is_within(pieces, distance, 3 - ulp);
  CHECK(beyond.reach == Reach::Beyond);
  REQUIRE(beyond.witness);
  CHECK(beyond.witness->point == RationalPoint(2, 2, 2));
  CHECK(beyond.witness->triangle == TriangleId(4));
  CHECK(beyond.witness->nearest.squared == 3);
  CHECK(is_within({}, distance, 0).reach == Reach::Within);
  CHECK(is_within(pieces, distance, 0).reach == Reach::Beyond);
  CHECK(error_of([&] { return is_within(pieces, distance, -1); }).code() ==
        ErrorCode::InvalidArgument);
}

TEST_CASE("is_within: a piece that no single part is near takes subdivision") {
  // A gap of 2 between two cubes: the middle is at distance 1, the corners are covered.
  const std::vector<ConvexPart> parts{cell(0, 0, 0), cell(3, 0, 0)};
  const UnionDistance distance(parts);
  const Rational half(1, 2), few = Rational(1, 1000);
  const std::vector<UncoveredPiece> pieces{piece({{1, 0, half}, {3, 0, half}, {3, 1, half}})};
  CHECK(is_within(pieces, distance, 1 + few).reach == Reach::Within);
  // Middles of sides hit the middle of the gap.
  CHECK(is_within(pieces, distance, 1).reach == Reach::Within);
  // Farthest at the left: neither a corner nor the centroid is beyond, a middle is.
  const std::vector<UncoveredPiece> skew{piece({{1, 0, half}, {3, 0, half}, {1, 1, half}})};
  const WithinDistance beyond = is_within(skew, distance, 1 - few);
  CHECK(beyond.reach == Reach::Beyond);
  REQUIRE(beyond.witness);
  CHECK(beyond.witness->nearest.squared > 1 - few);
  CHECK(beyond.witness->nearest.squared == to_union(parts, beyond.witness->point));
  CHECK(beyond.witness->nearest.squared <= 1);
}

TEST_CASE("is_within: undecided where two parts are at exactly the tolerance, with the bracket") {
  const std::vector<ConvexPart> parts{cell(0, 0, 0), cell(3, 0, 0)};
  const UnionDistance distance(parts);
  // No halving of [1, 4] meets x = 2, where the distance is 1; all others are nearer.
  const std::vector<UncoveredPiece> pieces{piece({{1, 0, 0}, {4, 0, 0}})};
  for (const Rational& square :
       {Rational(1), Rational(1 - scale_by_power_of_two(Rational(1), -60))}) {
    const WithinDistance found = is_within(pieces, distance, square);
    CHECK(found.reach == Reach::Undecided);
    REQUIRE(found.bracket);
    CHECK(found.bracket->low <= square);
    CHECK(square < found.bracket->high);
    CHECK(found.bracket->high - 1 < Rational(1, 100000));
    CHECK(found.bracket->high >= 1);
    REQUIRE(found.witness);
    CHECK(found.witness->nearest.squared == found.bracket->low);
  }
  CHECK(is_within(pieces, distance, Rational(999, 1000)).reach == Reach::Beyond);
  CHECK(is_within(pieces, distance, Rational(1001, 1000)).reach == Reach::Within);
}

TEST_CASE("is_within, surface_to_union: agree with dense samples of random triangles" * sweep) {
  std::mt19937_64 random(5);
  const auto coordinate = [&] { return Rational(static_cast<long>(random() % 17) - 8) / 2; };
  for (int round = 0; round < 12; ++round) {
    const double shift = static_cast<double>(round % 4) + 1;
    const std::vector<ConvexPart> parts{cell(0, 0, 0), cell(shift, 1, 0), cell(-3, shift, 2)};
    const UnionDistance distance(parts);
    std::vector<UncoveredPiece> pieces;
    Rational largest = 0;
    for (std::size_t t = 0; t < 3; ++t) {
      std::vector<RationalPoint> corners;
      for (int k = 0; k < 3; ++k) corners.push_back({coordinate(), coordinate(), coordinate()});
      for (const RationalPoint& x : samples(corners, 6)) {
        largest = std::max(largest, to_union(parts, x));
      }
      pieces.push_back(piece(std::move(corners), t));
    }
    const DirectedDistance directed = surface_to_union(pieces, distance, 100);
    CHECK(is_close(directed, 100));
    const Rational low = directed.bounds.low(), high = directed.bounds.high();
    CHECK(largest <= high * high);
    REQUIRE(directed.at);
    CHECK(holds_root_of(Enclosure(low, high, 64), distance(*directed.at).squared));
    CHECK(is_within(pieces, distance, high * high).reach != Reach::Beyond);
    CHECK(is_within(pieces, distance, largest * Rational(99, 100)).reach == Reach::Beyond);
    const Rational more = high + Rational(1, 10);
    CHECK(is_within(pieces, distance, more * more).reach == Reach::Within);
  }
}

TEST_CASE("surface_to_union: closed forms") {
  const std::vector<ConvexPart> parts{cell(0, 0, 0), cell(3, 0, 0)};
  const UnionDistance distance(parts);
  CHECK(surface_to_union({}, distance, 1).bounds.high() == 0);
  CHECK(!surface_to_union({}, distance, 1).at);
  // Across the gap: 1, in the interior of a side.
  const DirectedDistance gap =
      surface_to_union(std::vector{piece({{1, 0, 0}, {4, 0, 0}, {4, 1, 0}})}, distance, 20);
  CHECK(gap.bounds.contains(1));
  CHECK(is_close(gap, 20));
  // A corner of a square: the square root of 2; of a point, of a segment: 1 and 2.
  CHECK(holds_root_of(
      surface_to_union(std::vector{piece({{0, 0, 2}, {1, 0, 2}, {1, 2, 2}, {0, 2, 2}})}, distance,
                       20)
          .bounds,
      2));
  CHECK(surface_to_union(std::vector{piece({{0, 0, 2}})}, distance, 20).bounds.contains(1));
  CHECK(surface_to_union(std::vector{piece({{0, 0, 1}, {0, 0, 3}})}, distance, 20)
            .bounds.contains(2));
  CHECK(error_of([&] { return surface_to_union({}, distance, 0); }).code() ==
        ErrorCode::InvalidArgument);
}

TEST_CASE("union_to_surface: open surfaces") {
  const Surface square = surface_of({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, {{0, 1, 2, 3}});
  const auto expect = [&](const ConvexPart& part, const Rational& square_of_distance) {
    const std::vector<ConvexPart> parts{part};
    const DirectedDistance found = union_to_surface(parts, square, nullptr, 32);
    CHECK(holds_root_of(found.bounds, square_of_distance));
    CHECK(is_close(found, 32));
    if (square_of_distance > 0) {
      REQUIRE(found.at);
      CHECK(to_part(part, *found.at) == 0);
      const Rational low = found.bounds.low();
      CHECK(to_solid(square, nullptr, *found.at) >= low * low * Rational(999999, 1000000));
    } else {
      CHECK(!found.at);
    }
  };
  expect(cell(0, 0, 2), 9);
  expect(cell(1, 2, 0), 1);
  expect(cell(6, 1, 0), 10);
  expect(cell(5, 5, 0), 9);
  expect(polygon_part({{1, 1, 0}, {2, 1, 0}, {2, 2, 0}}), 0);
  expect(polygon_part({{1, 1, 0}, {2, 1, 0}, {2, 2, 3}}), 9);
  expect(segment_part({1, 1, 1}, {2, 7, 1}), 10);
  expect(point_part({7, 8, 12}), 169);
}

TEST_CASE("union_to_surface: closed solids, and parts inside, equal, sticking out and apart") {
  const Surface cube = box_surface({0, 0, 0}, {2, 2, 2});
  const Winding winding(cube);
  const auto expect = [&](std::vector<ConvexPart> parts, const Rational& square_of_distance) {
    for (int turn = 0; turn < 2; ++turn) {
      const DirectedDistance found = union_to_surface(parts, cube, &winding, 12);
      CHECK(holds_root_of(found.bounds, square_of_distance));
      CHECK(is_close(found, 12));
      CHECK(found.at.has_value() == (square_of_distance > 0));
      std::reverse(parts.begin(), parts.end());
    }
  };
  expect({part_of_box({kHalf, kHalf, kHalf}, {1, 1, 1})}, 0);
  expect({cell(0, 0, 0), cell(1, 1, 1)}, 0);
  expect({part_of_box({0, 0, 0}, {2, 2, 2})}, 0);
  expect({part_of_box({1, 0, 0}, {3, 1, 1}), cell(0, 0, 0)}, 1);
  expect({cell(0, 0, 0), cell(2, 2, 2)}, 3);
  expect({cell(3, 0, 0), part_of_box({-1, -1, 0}, {1, 1, 1})}, 4);
  expect({segment_part({1, 1, 1}, {1, 1, 5}), point_part({0, 0, 0})}, 9);
  // Within, distances to the surface do not count; without winding numbers they do.
  const std::vector<ConvexPart> middle{point_part({1, 1, 1})};
  CHECK(union_to_surface(middle, cube, nullptr, 12).bounds.contains(1));
}

TEST_CASE("union_to_surface: cubes inside of cubes, as solid and as parts; one part sticks out") {
  Mesh mesh;
  std::vector<Point> points;
  std::vector<ConvexPart> parts;
  for (const double half : {1.0, 2.0, 3.0, 4.0}) {
    const Surface cube = box_surface({-half, -half, -half}, {half, half, half});
    const auto first = static_cast<std::uint32_t>(points.size());
    for (const Point& p : cube.points.doubles()) points.push_back(p);
    for (const auto& [i, j, k] : cube.triangles) {
      mesh.polygons.push_back({first + i.value, first + j.value, first + k.value});
    }
    parts.push_back(part_of_box({-half, -half, -half}, {half, half, half}));
  }
  mesh.points = PointSet(points);
  const Surface nested = make_surface(mesh, {.orient = Orient::Keep});
  const Winding winding(nested);
  const Rational diameter = 192;  // squared
  const DirectedDistance none = union_to_surface(parts, nested, &winding, diameter);
  CHECK(holds_root_of(none.bounds, 0));
  CHECK(is_close(none, diameter));
  parts.push_back(part_of_box({-1, -1, -1}, {7, 1, 1}));  // 3 beyond x = 4
  CHECK(holds_root_of(union_to_surface(parts, nested, &winding, diameter).bounds, 9));
}

TEST_CASE("union_to_surface: a hull closes the hole of a ring, at any scale") {
  for (const int exponent : {-300, 0, 300}) {
    const double unit = std::ldexp(1.0, exponent);
    const Surface ring = ring_surface(unit);
    REQUIRE(ring.is_closed);
    const Winding winding(ring);
    const std::vector<ConvexPart> hull{part_of_box({0, 0, 0}, {3 * unit, 3 * unit, unit})};
    const Rational diameter = hull[0].box.squared_diameter(), half = to_rational(unit / 2);
    const DirectedDistance found = union_to_surface(hull, ring, &winding, diameter);
    CHECK(found.bounds.contains(half));
    CHECK(is_close(found, diameter));
    REQUIRE(found.at);
    CHECK(winding(*found.at) == 0);
    const std::vector<ConvexPart> walls{
        part_of_box({0, 0, 0}, {3 * unit, unit, unit}),
        part_of_box({0, 2 * unit, 0}, {3 * unit, 3 * unit, unit}),
        part_of_box({0, unit, 0}, {unit, 2 * unit, unit}),
        part_of_box({2 * unit, unit, 0}, {3 * unit, 2 * unit, unit})};
    const DirectedDistance none = union_to_surface(walls, ring, &winding, diameter);
    CHECK(none.bounds.contains(0));
    CHECK(is_close(none, diameter));
  }
}

TEST_CASE("union_to_surface: the farthest point is in the interior of a part that fills a void") {
  std::vector<Point> points;
  std::vector<std::vector<std::uint32_t>> faces;
  add_box_faces(points, faces, {0, 0, 0}, {3, 3, 3});
  add_box_faces(points, faces, {1, 1, 1}, {2, 2, 2}, true);
  const Surface hollow = surface_of(points, faces);
  const Winding winding(hollow);
  const std::vector<ConvexPart> parts{part_of_box({0, 0, 0}, {3, 3, 3})};
  const DirectedDistance found = union_to_surface(parts, hollow, &winding, 27);
  CHECK(found.bounds.contains(Rational(1, 2)));
  CHECK(is_close(found, 27));
  REQUIRE(found.at);
  const RationalVector3 off =
      *found.at - RationalPoint(Rational(3, 2), Rational(3, 2), Rational(3, 2));
  CHECK(squared(off) < Rational(1, 10000));
}

TEST_CASE("union_to_surface: no sample of random parts is beyond the bounds" * sweep) {
  std::mt19937_64 random(11);
  const auto coordinate = [&] { return static_cast<double>(random() % 9) * kHalf; };
  const Surface ring = ring_surface(1);
  const Winding winding(ring);
  for (int round = 0; round < 6; ++round) {
    const std::vector<ConvexPart> parts{solid_part(shapes::lattice(7, 2, round + 1)),
                                        part_of_box({0, 0, 0}, {1, 1 + coordinate(), 1})};
    for (const Winding* inside : {static_cast<const Winding*>(nullptr), &winding}) {
      const DirectedDistance found = union_to_surface(parts, ring, inside, 20);
      CHECK(is_close(found, 20));
      const Rational high = found.bounds.high();
      Rational largest = 0;
      for (const ConvexPart& part : parts) {
        for (std::size_t k = 0; k + 3 < part.vertices.size(); ++k) {
          for (const RationalPoint& x :
               samples({part.vertices[k], part.vertices[k + 1], part.vertices[k + 2]}, 4)) {
            const RationalPoint y = (x + part.vertices[k + 3]) / Rational(2);
            largest = std::max({largest, to_solid(ring, inside, x), to_solid(ring, inside, y)});
          }
        }
      }
      CHECK(largest <= high * high);
      if (found.at) {
        CHECK(holds_root_of(found.bounds, to_solid(ring, inside, *found.at)));
      }
    }
  }
}

TEST_CASE("union_to_surface: what it refuses") {
  const Surface cube = box_surface({0, 0, 0}, {1, 1, 1});
  const std::vector<ConvexPart> parts{cell(0, 0, 0)};
  const auto code = [](auto&& action) { return error_of(action).code(); };
  CHECK(code([&] { return union_to_surface({}, cube, nullptr, 1); }) == ErrorCode::InvalidArgument);
  CHECK(code([&] { return union_to_surface(parts, cube, nullptr, 0); }) ==
        ErrorCode::InvalidArgument);
  CHECK(code([&] { return union_to_surface(parts, Surface{}, nullptr, 1); }) ==
        ErrorCode::InvalidArgument);
}

TEST_CASE("UnionDistance: any threads may ask at the same time") {
  // Unit cubes at x in [2 i, 2 i + 1]: of a point above one of them, at height 1 + h, the squared
  // distance is h^2.
  std::vector<ConvexPart> parts;
  for (int i = 0; i < 10; ++i) parts.push_back(part_of_box({2.0 * i, 0, 0}, {2.0 * i + 1, 1, 1}));
  const UnionDistance distance(parts);
  std::vector<Rational> squared(400);
  for_each_in_parallel(squared.size(), 8, [&](std::size_t k) {
    const RationalPoint x(Rational(2 * (k % 10)) + Rational(1, 3), Rational(1, 2), Rational(1 + k));
    squared[k] = distance(x).squared;
  });
  for (std::size_t k = 0; k < squared.size(); ++k) CHECK(squared[k] == Rational(k * k));
}
