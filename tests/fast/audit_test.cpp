// SPDX-License-Identifier: MIT
// Everything that the filtered engine decides without exact numbers is decided again: signs by a
// determinant of rationals, caps by the exact engine's explicit polytopes.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <variant>

#include "auditor.hpp"
#include "convexact/hull.hpp"
#include "convexact/io.hpp"
#include "shapes/makers.hpp"

using namespace convexact;

namespace {

std::vector<Point> mesh(const std::string& name) {
  const Mesh mesh = read_mesh(std::string(std::getenv("CONVEXACT_TEST_DATA")) + "/" + name);
  const auto points = mesh.points.doubles();
  return {points.begin(), points.end()};
}

}  // namespace

TEST_CASE("FilteredLoop: certified signs and enclosures are true on a scan, and most suffice") {
  const auto [tally, counts] = audit::run(mesh("bunny.obj"), 40, 18);
  CHECK(tally.signs_checked > 1000);
  CHECK(tally.caps_checked > 150);
  // 7 to 12 in a hundred signs are zeros of planes with a common vertex; hardly any other is left.
  CHECK(counts.signs.filtered > 0.85 * double(counts.signs.filtered + counts.signs.incident));
  CHECK(counts.signs.incident > 0);
  CHECK(counts.signs.extended + counts.signs.exact < 0.001 * double(counts.signs.filtered));
  CHECK(counts.doubtful + counts.exact < 0.01 * double(counts.evaluations));
}

TEST_CASE("FilteredLoop: certified signs and enclosures are true on a symmetric mesh with ties") {
  const auto [tally, counts] = audit::run(mesh("spot.obj"), 10, 18);
  CHECK(tally.signs_checked > 1000);
  CHECK(tally.caps_checked > 100);
  CHECK(counts.exact > 0);  // its mirror images tie exactly
  CHECK(counts.signs.filtered > 0.85 * double(counts.signs.filtered + counts.signs.incident));
}

TEST_CASE("FilteredLoop: certified signs and enclosures are true on a mesh of revolution") {
  const auto [tally, counts] = audit::run(mesh("teapot.obj"), 20, 1200);  // of 1,752
  CHECK(tally.signs_checked > 500);
  CHECK(tally.caps_checked > 100);
  // A fifth of the signs are zero by incidence; strips of revolution make others that are not.
  CHECK(counts.signs.filtered > 0.75 * double(counts.signs.filtered + counts.signs.incident));
  CHECK(counts.signs.extended + counts.signs.exact < 0.02 * double(counts.signs.filtered));
}

TEST_CASE("FilteredLoop: certified signs and enclosures are true near the worst case") {
  std::size_t signs = 0, unknown = 0, caps = 0;
  const auto add = [&](const std::vector<Point>& points) {
    const auto [tally, counts] = audit::run(points, 1);
    signs += tally.signs_checked;
    unknown += tally.unknown_signs;
    caps += tally.caps_checked;
  };
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    CAPTURE(seed);
    add(shapes::nearly_coplanar(24, seed));
    add(shapes::needle(24, 1e12, seed));
    add(shapes::slab(24, 1e9, seed));
    add(shapes::offset_ball(24, 1e8, seed));
    add(shapes::scaled_ball(24, -300, seed));
    add(shapes::wide_exponents(16, 40, seed));
    add(shapes::lattice(24, 2, seed));
  }
  add(shapes::prism(17));
  add(shapes::antiprism(20));
  add(shapes::cylinder(12, 4));
  add(shapes::fibonacci_sphere(80));
  CHECK(signs > 4000);
  CHECK(unknown > 500);
  CHECK(caps > 1900);
}

TEST_CASE("FastDual: rounded dual points are as close as promised") {
  for (const std::vector<Point>& points :
       {shapes::in_ball(60, 1), shapes::offset_ball(40, 1e8, 2), shapes::needle(40, 1e12, 3),
        shapes::lattice(40, 3, 4), shapes::huge(30, 5), shapes::subnormal(30, 9, 6),
        shapes::wide_exponents(20, 300, 7)}) {
    const PointSet set(points);
    const HullOutcome outcome = convex_hull(set);
    REQUIRE(std::holds_alternative<Hull>(outcome));
    const FastDual dual = FastDual::of(std::get<Hull>(outcome), set);
    // The powers of two by which the axes were scaled multiply up to the unit of volume.
    long exponent_sum = 0;
    for (int k = 0; k < 3; ++k) {
      const auto coordinate = [&](const Triple<double>& p) {
        return k == 0 ? p.x : k == 1 ? p.y : p.z;
      };
      std::size_t largest = 0;
      for (std::size_t i = 0; i < dual.size(); ++i) {
        if (std::abs(coordinate(dual.near(HalfspaceId(i)))) >
            std::abs(coordinate(dual.near(HalfspaceId(largest))))) {
          largest = i;
        }
      }
      const auto exact = [&](std::size_t i) {
        const Halfspace& h = dual.exact(HalfspaceId(i));
        return Rational(Rational(h.normal()[k]) / -h(dual.center()));
      };
      const double top = coordinate(dual.near(HalfspaceId(largest)));
      CHECK(std::abs(top) <= 1);
      CHECK(std::abs(top) >= 0.5);
      // The power of two that brings the exact coordinate to the rounded one.
      const Rational ratio = abs(exact(largest) / to_rational(top));
      long exponent = static_cast<long>(bit_length(numerator(ratio))) -
                      static_cast<long>(bit_length(denominator(ratio))) - 1;
      while (scale_by_power_of_two(ratio, -exponent) > Rational(5, 4)) ++exponent;
      exponent_sum += exponent;
      for (std::size_t i = 0; i < dual.size(); ++i) {
        const Rational q = scale_by_power_of_two(exact(i), -exponent);
        const Rational near = to_rational(coordinate(dual.near(HalfspaceId(i))));
        const Rational both = near + to_rational(coordinate(dual.rest(HalfspaceId(i))));
        const Rational underflow = scale_by_power_of_two(Rational(1), -1074);
        CHECK(abs(near - q) <= abs(near) * to_rational(FastDual::kNearError) + underflow);
        CHECK(abs(both - q) <= abs(near) * to_rational(FastDual::kLongError) + underflow);
      }
    }
    CHECK(dual.volume_exponent() == -exponent_sum);
  }
}
