// SPDX-License-Identifier: MIT
// Surface area and mean width. Expected values: closed forms to 50 digits, computed from roots and
// arctangents of integers; widths averaged over many directions (the definition, to three digits).
#include <doctest/doctest.h>

#include <cmath>

#include "convexact/measure.hpp"
#include "moved_polytope.hpp"
#include "number/precision.hpp"
#include "polytope_by_definition.hpp"
#include "property.hpp"
#include "refine_decimal.hpp"
#include "shapes/makers.hpp"
using namespace convexact;

namespace {

Enclosure root(int x, long precision) { return sqrt(Enclosure(Integer(x), precision)); }
Enclosure number(const Rational& x, long precision) { return Enclosure(x, precision); }

constexpr long kBits = 200;

// Both enclose the same number and are narrow: to within 2^-180 of it.
bool agree(const Enclosure& a, const Enclosure& b) {
  const Enclosure difference = a - b;
  return difference.contains(0) && difference.width() < scale_by_power_of_two(a.high(), -180);
}

}  // namespace

TEST_CASE("surface_area: closed forms") {
  const auto area = [](const std::vector<Point>& points) {
    return surface_area(solid(points), kBits);
  };
  CHECK(agree(area(shapes::cube()), number(24, kBits)));
  CHECK(agree(area(shapes::box({1, 2, 3})), number(88, kBits)));
  CHECK(area(shapes::cube()).width() == 0);  // every radicand is 1
  // Edge e = sqrt(8): sqrt(3) e^2; octahedron with e = sqrt(2): 2 sqrt(3) e^2.
  CHECK(agree(area(shapes::tetrahedron()), number(8, kBits) * root(3, kBits)));
  CHECK(agree(area(shapes::octahedron()), number(4, kBits) * root(3, kBits)));
  // Corner simplex: three half squares and an equilateral triangle of edge sqrt(2).
  CHECK(agree(area({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}),
              number(Rational(3, 2), kBits) + root(3, kBits) / number(2, kBits)));
  const Polytope cube = solid(shapes::cube());
  CHECK(refine_decimal([&](long p) { return surface_area(cube, p); }, 17) == "24");
  const Polytope octahedron = solid(shapes::octahedron());
  CHECK(refine_decimal([&](long p) { return surface_area(octahedron, p); }, 21) ==
        "6.92820323027550917411");
}

TEST_CASE("facet_areas: the radicand is that of the primitive direction") {
  // x = 1/2 has the plane (2, 0, 0, -1).
  for (const RootTerm& area : facet_areas(solid(shapes::prism(4)))) {
    CHECK((area.radicand == 1 || area.radicand == 2));
    CHECK(area.factor > 0);
  }
}

TEST_CASE("mean_width: closed forms") {
  const auto width = [](const std::vector<Point>& points) {
    return mean_width(solid(points), kBits);
  };
  CHECK(agree(width(shapes::cube()), number(3, kBits)));          // 3a/2
  CHECK(agree(width(shapes::box({1, 2, 4})), number(7, kBits)));  // (a + b + c)/2
  // Regular tetrahedron of edge e = sqrt(8): six edges of exterior angle pi - acos(1/3) =
  // acos(-1/3) = atan2(sqrt(8), -1), so 6 sqrt(8) atan2(sqrt(8), -1) / (4 pi).
  const Enclosure pi4 = number(4, kBits) * Enclosure::pi(kBits);
  CHECK(agree(width(shapes::tetrahedron()),
              number(6, kBits) * root(8, kBits) * atan2(root(8, kBits), number(-1, kBits)) / pi4));
  // Octahedron of edge sqrt(2): twelve edges of exterior angle acos(1/3).
  CHECK(agree(width(shapes::octahedron()),
              number(12, kBits) * root(2, kBits) * atan2(root(8, kBits), number(1, kBits)) / pi4));
  const Polytope cube = solid(shapes::cube());
  CHECK(refine_decimal([&](long p) { return mean_width(cube, p); }, 17) == "3.0000000000000000");
}

TEST_CASE("mean_width: the average of the width over all directions") {
  for (const auto& points :
       {shapes::in_ball(12, 4), shapes::pyramid(5), shapes::lattice(9, 2, 1)}) {
    double sum = 0;
    const auto directions = shapes::fibonacci_sphere(20000);
    for (const Point& u : directions) {
      double most = -1e9, least = 1e9;
      for (const Point& p : points) {
        most = std::max(most, u.dot(p));
        least = std::min(least, u.dot(p));
      }
      sum += most - least;
    }
    const double average = sum / static_cast<double>(directions.size());
    const double width = mean_width(solid(points), 64).low_double();
    CHECK(std::abs(width - average) < 1e-3 * average);
  }
}

TEST_CASE("area and mean width: scale, translation and order of lists") {
  check_property("metamorphic", [](std::uint16_t seed, std::int8_t k) {
    const Polytope p = solid(shapes::in_box(8, seed));
    const Enclosure area = surface_area(p, kBits), width = mean_width(p, kBits);
    const Polytope larger = scaled(p, k);
    RC_ASSERT(surface_area(larger, kBits).low() == scale_by_power_of_two(area.low(), 2 * k));
    RC_ASSERT(mean_width(larger, kBits).high() == scale_by_power_of_two(width.high(), k));
    for (const Polytope& q : {translated(p, {Rational(k, 7), 10, -3}), shuffled(p, seed)}) {
      RC_ASSERT(agree(surface_area(q, kBits), area));
      RC_ASSERT(agree(mean_width(q, kBits), width));
    }
  });
}

TEST_CASE("area and mean width: grow with the solid") {
  const Polytope inner = solid(shapes::cut_cube(3, 0.25)), outer = solid(shapes::cut_cube(2, 0.25));
  CHECK((surface_area(outer, 64) - surface_area(inner, 64)).sign() == Sign::Positive);
  CHECK((mean_width(outer, 64) - mean_width(inner, 64)).sign() == Sign::Positive);
}
