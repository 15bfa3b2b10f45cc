// SPDX-License-Identifier: MIT
// How many facets a solid of rounded vertices was meant to have. Expected counts are those of the
// solids before they were rounded, or of points whose position no rounding explains.
#include <doctest/doctest.h>

#include <cmath>
#include <numeric>

#include "convexact/hull.hpp"
#include "convexact/simplify.hpp"
#include "convexact/verify.hpp"
#include "shapes/makers.hpp"
using namespace convexact;

namespace {

constexpr Slack kHalf = {}, kHalf32 = {Precision::Binary32, 0}, kWide = {{}, kRoundingUlps};

Polytope hull_of(const std::vector<Point>& points) {
  const PointSet set(points);
  return to_polytope(std::get<Hull>(convex_hull(set)), set);
}

std::size_t count(const std::vector<Point>& points, const Slack& slack = kHalf) {
  return planar_patches(hull_of(points), slack).size();
}

std::vector<Point> with_corner_up(double ulps) {
  std::vector<Point> cube = shapes::box({1, 1, 1});
  for (Point& p : cube) {
    if (p == Point(1, 1, 1)) p.z() += ulps * 0x1p-52;
  }
  return cube;
}

// A prism over a k-gon in a plane along no axis, rounded to doubles; as thick as that.
std::vector<Point> tilted_plate(int k, double thickness) {
  const Point u(0.36, 0.48, -0.8), v(-0.8, 0.6, 0), n = u.cross(v);
  std::vector<Point> points;
  for (int i = 0; i < k; ++i) {
    const double angle = 2 * M_PI * i / k;
    const Point p = Point(0.1, 0.2, 0.3) + std::cos(angle) * u + std::sin(angle) * v;
    points.push_back(p);
    points.push_back(p + thickness * n);
  }
  return points;
}

// Whether what simplify stores counts as no more facets than it kept: as asked for, or fewer than
// can go.
bool is_as_meant(const std::vector<Point>& points, std::size_t faces, Precision precision) {
  SimplifyRequest request;
  request.faces = faces;
  request.store.mesh = precision;
  const SimplifyOutcome outcome = simplify(PointSet(points), request);
  const Stored& solid = std::get<SimplifyResult>(outcome).solid;
  const auto& stored = solid.mesh.value().mesh.points.doubles();
  return count({stored.begin(), stored.end()}, {precision, 0}) <= solid.exact.planes.size();
}

}  // namespace

TEST_CASE(
    "planar patches: exact facets stay, an ulp is explained by halves from both sides (#13)") {
  CHECK(count(shapes::box({1, 1, 1})) == 6);
  CHECK(hull_of(with_corner_up(1)).facets.size() == 7);
  // (1, 1, 1 + 2^-52) and its neighbours at 1 have half an ulp of 2^-53 each: they meet half-way.
  CHECK(count(with_corner_up(1)) == 6);
  CHECK(count(with_corner_up(2)) == 6);  // the lid tilts: the opposite corner goes down, too
  CHECK(count(with_corner_up(3)) == 7);
  CHECK(count(with_corner_up(4), kHalf32) == 6);
  CHECK(count(with_corner_up(32), kWide) == 6);
  CHECK(count(with_corner_up(1000), kWide) == 7);
}

TEST_CASE("planar patches: rounded solids have the facets that they were meant to have (#13)") {
  CHECK(hull_of(shapes::rounded_dodecahedron()).facets.size() > 12);
  CHECK(count(shapes::rounded_dodecahedron()) == 12);
  CHECK(count(shapes::icosahedron()) == 20);
  CHECK(count(shapes::prism(30)) == 32);
}

TEST_CASE("planar patches: thin clouds are not flattened, whatever their thickness (#13)") {
  // Thinner than 1024 u everything is nearly coplanar. Points at random have no patches.
  for (const double thickness : {0x1p-20, 0x1p-36, 0x1p-42, 0x1p-46}) {
    CAPTURE(thickness);
    std::vector<Point> slab;
    for (const Point& p : shapes::in_ball(40, 5)) {
      const Point n(0.6, 0.48, 0.64);
      slab.push_back(p - (1 - thickness) * n.dot(p) * n);
    }
    const std::size_t facets = hull_of(slab).facets.size();
    CHECK(count(slab) * 10 >= facets * 9);
    CHECK(count(slab, kWide) * 10 >= facets * (thickness < 0x1p-40 ? 5 : 9));
  }
}

TEST_CASE(
    "planar patches: of a thin plate only polygons that keep their corners are merged (#13)") {
  // Ten facets, three of which meet in each corner.
  CHECK(count(tilted_plate(8, 1)) == 10);
  CHECK(count(tilted_plate(8, 0x1p-40)) == 10);
  CHECK(count(tilted_plate(8, 0x1p-44)) == 10);
  // With a point in the middle of one lid it is no corner that could remain one.
  std::vector<Point> plate = tilted_plate(8, 0x1p-44);
  Point middle(0, 0, 0);
  for (std::size_t i = 1; i < plate.size(); i += 2) middle += plate[i] / 8;
  const Point n = Point(0.36, 0.48, -0.8).cross(Point(-0.8, 0.6, 0));
  plate.push_back(middle + 0x1p-46 * n);
  REQUIRE(hull_of(plate).vertices.size() == 17);
  CHECK(count(plate) > 10);
}

TEST_CASE("planar patches: what simplify stores has the facets that it kept (#13)") {
  struct Input {
    const char* name;
    std::vector<Point> points;
  };
  for (const Input& input :
       {Input{"ball", shapes::in_ball(60, 1)}, Input{"prism", shapes::prism(17)},
        Input{"sphere", shapes::rounded_dodecahedron()}, Input{"plate", tilted_plate(30, 0x1p-10)},
        Input{"thin plate", tilted_plate(30, 0x1p-20)}}) {
    CAPTURE(input.name);
    for (const std::size_t faces : {4u, 6u, 9u, 14u}) {
      CAPTURE(faces);
      CHECK(is_as_meant(input.points, faces, Precision::Binary64));
      CHECK(is_as_meant(input.points, faces, Precision::Binary32));
    }
  }
}

TEST_CASE("planar patches: each facet is in one patch (#13)") {
  const Polytope solid = hull_of(shapes::rounded_dodecahedron());
  std::vector<std::uint32_t> all;
  for (const auto& patch : planar_patches(solid, kHalf)) {
    all.insert(all.end(), patch.begin(), patch.end());
  }
  std::sort(all.begin(), all.end());
  std::vector<std::uint32_t> expected(solid.facets.size());
  std::iota(expected.begin(), expected.end(), 0u);
  CHECK(all == expected);
}

TEST_CASE("precision_of: binary32 if every number is one and one needs its digits (#13)") {
  CHECK(precision_of(PointSet(shapes::box({1, 1, 1}))) == Precision::Binary64);
  CHECK(precision_of(PointSet(std::vector<Point>{{0.1F, 1, 2}})) == Precision::Binary32);
  CHECK(precision_of(PointSet(std::vector<Point>{{0.1F, 0.1, 2}})) == Precision::Binary64);
  CHECK(precision_of(PointSet(std::vector<Point>{{1e300, 0.1F, 2}})) == Precision::Binary64);
  CHECK(precision_of(PointSet(std::vector<Point>{{65535, 1, 2}})) == Precision::Binary64);
  CHECK(precision_of(PointSet(std::vector<Point>{{65537, 1, 2}})) == Precision::Binary32);
}

TEST_CASE("unit_in_last_place: the distance to the next number (#13)") {
  for (const double x : {1.0, 1.5, 0x1.fffffffffffffp0, 3.7e-310, 1e300, 0x1p-1022}) {
    CHECK(unit_in_last_place(Precision::Binary64, to_rational(x)) ==
          to_rational(std::nextafter(x, INFINITY)) - to_rational(x));
    CHECK(unit_in_last_place(Precision::Binary64, to_rational(-x)) ==
          unit_in_last_place(Precision::Binary64, to_rational(x)));
  }
  for (const float x : {1.0F, 1.5F, 3e-40F, 1e30F}) {
    CHECK(unit_in_last_place(Precision::Binary32, to_rational(x)) ==
          to_rational(std::nextafter(x, INFINITY)) - to_rational(x));
  }
  CHECK(unit_in_last_place(Precision::Binary64, 0) == to_rational(0x1p-1074));
}
