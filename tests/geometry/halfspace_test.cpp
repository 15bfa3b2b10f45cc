// SPDX-License-Identifier: MIT
// Halfspaces: primitive form, canonical order, intersection of planes. Expected values by hand.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "convexact/error.hpp"
#include "convexact/geometry.hpp"
#include "geometry/area_vector.hpp"
#include "integer_halfspace.hpp"
#include "near/near_plane.hpp"
#include "number/arithmetic.hpp"
#include "number/random.hpp"
#include "property.hpp"

using namespace convexact;

TEST_CASE("Halfspace: equal planes are equal vectors") {
  CHECK(halfspace(2, 4, -6, 8) == halfspace(1, 2, -3, 4));
  CHECK(halfspace(2, 4, -6, 7).normal()[0] == 2);  // gcd 1 over all four
  CHECK_FALSE(halfspace(1, 0, 0, 0) == halfspace(-1, 0, 0, 0));
  CHECK_THROWS_AS(halfspace(0, 0, 0, 1), Error);
}

TEST_CASE("Halfspace: the canonical order goes by direction, then by offset") {
  CHECK(halfspace(1, 2, 3, 0) < halfspace(1, 2, 4, 0));
  CHECK(halfspace(2, 4, 6, 1) < halfspace(1, 2, 3, 1));  // same direction; 1/2 < 1
  CHECK(halfspace(2, 4, 6, -1) > halfspace(1, 2, 3, -1));
  CHECK(halfspace(2, 0, 0, 1) < halfspace(1, 1, 0, 5));  // (1, 0, 0) before (1, 1, 0)
  CHECK(same_direction(halfspace(2, 4, 6, 1), halfspace(1, 2, 3, 1)));
  CHECK_FALSE(same_direction(halfspace(-2, -4, -6, 1), halfspace(1, 2, 3, 1)));
}

// By the definition, in fractions.
TEST_CASE("Halfspace: the canonical order of quotients that doubles can and cannot tell apart") {
  const auto quotients = [](const Halfspace& h) {
    const IntegerVector3& n = h.normal();
    const Integer g = gcd(gcd(n[0], n[1]), n[2]);
    return std::array{Rational(n[0], g), Rational(n[1], g), Rational(n[2], g),
                      Rational(h.offset(), g)};
  };
  std::vector<Halfspace> halfspaces;
  for (const unsigned bits : {3u, 52u, 53u, 54u, 200u, 1030u, 2100u}) {
    const Integer large = Integer(1) << bits;
    for (int common = 1; common <= 3; ++common) {  // offsets that leave the normal its divisor
      for (int delta = -1; delta <= 1; ++delta) {
        const Integer g = common == 3 ? Integer(large + 1) : Integer(common);
        halfspaces.emplace_back(IntegerVector3(g * (large + delta), g, 0), Integer(g + 1));
        halfspaces.emplace_back(IntegerVector3(-g * (large + delta), -g, 2 * g), Integer(-1));
        halfspaces.emplace_back(IntegerVector3(g, g * large, 0), Integer(1 + delta));
      }
    }
  }
  // Divisors that no double holds, beside offsets that doubles do.
  for (const unsigned bits : {9u, 1023u, 1024u, 1030u, 1033u}) {
    const Integer g = Integer(1) << bits;
    for (const unsigned offset_bits : {0u, 8u, 1022u, 1023u, 1025u}) {
      halfspaces.emplace_back(IntegerVector3(g, 0, 0), Integer(-((Integer(1) << offset_bits) + 1)));
      halfspaces.emplace_back(IntegerVector3(g, 0, 0), Integer((Integer(1) << offset_bits) + 1));
    }
  }
  halfspaces.emplace_back(IntegerVector3(512, 0, 0), Integer(-1));
  for (const Halfspace& a : halfspaces) {
    for (const Halfspace& b : halfspaces) {
      CHECK((a < b) == (quotients(a) < quotients(b)));
      CHECK((a <=> b == 0) == (a == b));
    }
  }
}

TEST_CASE("area_vector: doubles and rationals give the same, of polygons too") {
  const std::vector<Point> corners{{0.1, 0.2, 0.3}, {1e300, -7, 5e-324}, {3, 1e-200, 2}, {4, 5, 6}};
  std::vector<RationalPoint> exact;
  for (const Point& p : corners) exact.push_back(to_rational(p));
  exact.emplace_back(Rational(1, 3), 0, 0);  // the set is no longer of doubles
  const PointSet doubles(corners), rationals(exact);
  REQUIRE_FALSE(rationals.is_binary());
  const std::vector<std::uint32_t> ring{0, 1, 2, 3};
  RationalVector3 expected = RationalVector3::Zero();  // by the definition, about the origin
  for (std::size_t k = 0; k < ring.size(); ++k) {
    expected += exact[ring[k]].cross(exact[ring[(k + 1) % ring.size()]]);
  }
  CHECK(area_vector(doubles, ring) == expected);
  CHECK(area_vector(rationals, ring) == expected);
  CHECK(area_vector(doubles, std::span(ring).first(2)).isZero(0));
  const PointSet origin(std::vector<Point>(3, Point(0, 0, 0)));
  CHECK(area_vector(origin, PointId(0), PointId(1), PointId(2)).isZero(0));
}

TEST_CASE("Halfspace: through three doubles, and through the same rationals") {
  const Halfspace top = Halfspace::through(Point(0, 0, 0.5), Point(1, 0, 0.5), Point(0, 1, 0.5));
  CHECK(top == halfspace(0, 0, 2, -1));
  check_property("doubles and rationals give the same halfspace",
                 [](const std::array<std::int32_t, 9>& raw, int shift) {
                   std::array<Point, 3> p;
                   for (int k = 0; k < 9; ++k)
                     p[k / 3][k % 3] = std::ldexp(raw[k], (k * (shift % 300)) % 300);
                   const Point u = p[1] - p[0], v = p[2] - p[0];
                   RC_PRE(u.cross(v).norm() > 0);
                   const Halfspace fast = Halfspace::through(p[0], p[1], p[2]);
                   const Halfspace slow =
                       Halfspace::through(to_rational(p[0]), to_rational(p[1]), to_rational(p[2]));
                   RC_ASSERT(fast == slow);
                   for (const Point& x : p) RC_ASSERT(fast(to_rational(x)) == 0);
                 });
}

TEST_CASE("Halfspace: full mantissas, with exponents around where 128 bits no longer suffice") {
  Random random(2604);
  for (const int spread : {0, 7, 8, 9, 10, 60}) {
    for (int repeat = 0; repeat < 200; ++repeat) {
      std::array<Point, 3> p;
      for (int k = 0; k < 9; ++k) {
        // Odd 53-bit integers of either sign, times powers of two that are `spread` apart at most.
        const double mantissa = static_cast<double>(random() >> 12 | 1 | std::uint64_t{1} << 52);
        const auto shift = static_cast<int>(uniform_below(random, spread + 1));
        p[k / 3][k % 3] = std::ldexp(random() % 2 == 0 ? mantissa : -mantissa, shift - 40);
      }
      const Halfspace fast = Halfspace::through(p[0], p[1], p[2]);
      REQUIRE(fast == Halfspace::through(to_rational(p[0]), to_rational(p[1]), to_rational(p[2])));
    }
  }
  // The largest differences: opposite signs, all bits set.
  const double most = std::ldexp(9007199254740991.0, 8);
  const Point a(-most, -most, -most), b(most, most, -most), c(-most, most, most), d(1, 1, 1);
  for (const auto& [x, y, z] : {std::array{a, b, c}, std::array{b, c, a}, std::array{a, b, d}}) {
    CHECK(Halfspace::through(x, y, z) ==
          Halfspace::through(to_rational(x), to_rational(y), to_rational(z)));
  }
}

TEST_CASE("Halfspace: extreme doubles") {
  const Point a(1e300, 0, 0), b(0, 5e-324, 0), c(0, 0, 1);
  const Halfspace h = Halfspace::through(a, b, c);
  for (const Point& p : {a, b, c}) CHECK(h(to_rational(p)) == 0);
  CHECK_THROWS_AS(Halfspace::through(a, a, b), Error);
}

TEST_CASE("plane_value: n.x + d times the denominator") {
  const Halfspace h(IntegerVector3(1, -2, 3), Integer(-4));
  const RationalPoint x(Rational(1, 2), Rational(1, 3), Rational(5));
  const HomogeneousPoint p = clear_denominators(x);
  CHECK(p.w == 6);
  CHECK(plane_value(h, p) == 6 * h(x));
}

TEST_CASE("near_direction, scaled_direction and unit_vector: long normals, and none") {
  const Integer unit = Integer(1) << 3000u;
  const IntegerVector3 v(3 * unit, -6 * unit, Integer(0));
  CHECK(near_direction(v) == Point(0.5, -1, 0));
  CHECK(scaled_direction(v) == Point(0.375, -0.75, 0));
  CHECK(unit_vector(v).isApprox(Point(0.5, -1, 0) / std::sqrt(1.25), 0x1p-50));
  const IntegerVector3 none = IntegerVector3::Zero();
  CHECK(near_direction(none) == Point::Zero());
  CHECK(scaled_direction(none) == Point::Zero());
  CHECK(unit_vector(none) == Point::Zero());
}

TEST_CASE("meet: three planes, or none") {
  const RationalPoint x =
      meet(halfspace(1, 0, 0, -1), halfspace(0, 2, 0, -1), halfspace(1, 1, 1, 0));
  CHECK(x == RationalPoint(Rational(1), Rational(1, 2), Rational(-3, 2)));
  CHECK_THROWS_AS((void)meet(halfspace(1, 0, 0, 0), halfspace(2, 0, 0, 1), halfspace(0, 1, 0, 0)),
                  Error);
}

TEST_CASE("PointSet: a point that is not finite is named") {
  std::vector<Point> points(3, Point(0, 0, 0));
  points[2].y() = std::nan("");
  CHECK_THROWS_WITH_AS(PointSet{points}, doctest::Contains("point 2"), Error);
}
