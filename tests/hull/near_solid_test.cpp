// SPDX-License-Identifier: MIT
// The planes of near_solid(): no vertex is farther beyond one than its error, in rationals; and the
// error does not grow as facets get small.
#include "hull/near_solid.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "convexact/number.hpp"

using namespace convexact;

namespace {

// n.v + d for the doubles n, d as they are.
Rational value(const NearSolid::Plane& plane, const Point& v) {
  Rational sum = to_rational(plane.offset);
  for (int k = 0; k < 3; ++k) sum += to_rational(plane.normal[k]) * to_rational(v[k]);
  return sum;
}

double largest_error(const NearSolid& solid) {
  double largest = 0;
  for (const NearSolid::Plane& plane : solid.planes) largest = std::max(largest, plane.error);
  return largest;
}

void check_planes(const NearSolid& solid) {
  REQUIRE(!solid.planes.empty());
  for (const NearSolid::Plane& plane : solid.planes) {
    const Rational most = to_rational(plane.error);
    CHECK(std::all_of(solid.vertices.begin(), solid.vertices.end(),
                      [&](const Point& v) { return value(plane, v) <= most; }));
  }
}

// Rings of the unit sphere, and its poles.
std::vector<Point> sphere(int rings, int sides) {
  std::vector<Point> points{{0, 0, 1}, {0, 0, -1}};
  for (int i = 1; i < rings; ++i) {
    for (int k = 0; k < sides; ++k) {
      const double up = M_PI * i / rings, around = 2 * M_PI * k / sides;
      points.emplace_back(std::sin(up) * std::cos(around), std::sin(up) * std::sin(around),
                          std::cos(up));
    }
  }
  return points;
}

}  // namespace

TEST_CASE("near_solid: no vertex is beyond a plane by more than its error") {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> in_cube(-2, 2);
  for (int round = 0; round < 20; ++round) {
    std::vector<Point> points(60);
    // Flatter from round to round, down to slivers of 2^-38.
    const double height = std::ldexp(1, -2 * round);
    for (Point& p : points) p = {in_cube(random), in_cube(random), height * in_cube(random)};
    check_planes(near_solid(points));
  }
}

TEST_CASE("near_solid: facets of many corners, and planes far from the origin") {
  // A prism of 40 sides around (1.5, 1.5): its corners were rounded, so its lids are polygons of
  // 40 corners, as their z are equal, and its sides are not planar to the last bit.
  std::vector<Point> points;
  for (int k = 0; k < 40; ++k) {
    const double around = 2 * M_PI * k / 40;
    for (const double z : {1.25, 1.75}) {
      points.emplace_back(1.5 + 0.4 * std::cos(around), 1.5 + 0.4 * std::sin(around), z);
    }
  }
  check_planes(near_solid(points));
}

TEST_CASE("near_solid: the error of a small facet is that of a large one of its shape") {
  const double coarse = largest_error(near_solid(sphere(4, 8)));
  const NearSolid fine = near_solid(sphere(20, 40));
  check_planes(fine);
  // Rings near a pole are narrower triangles in the finer one, by a factor of five.
  CHECK(largest_error(fine) < 8 * coarse);
  // A cube of width w has volume w^3, and errors that do not depend on w.
  const auto cube = [](double w) {
    std::vector<Point> points;
    for (int k = 0; k < 8; ++k) points.emplace_back(k & 1 ? w : 0, k & 2 ? w : 0, k & 4 ? w : 0);
    return near_solid(points);
  };
  CHECK(cube(1).volume == 1);
  CHECK(cube(0x1p-20).volume == 0x1p-60);
  CHECK(largest_error(cube(1)) == largest_error(cube(0x1p-20)));
}
