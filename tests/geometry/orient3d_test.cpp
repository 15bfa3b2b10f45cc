// SPDX-License-Identifier: MIT
// orient3d: against the 4x4 determinant of the rows (x, y, z, 1) in rationals.
#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "convexact/geometry.hpp"
#include "exact_determinant.hpp"
#include "geometry/orient3d_stages.hpp"
#include "number/random.hpp"
#include "property.hpp"

using namespace convexact;

namespace {

using Points = std::array<Point, 4>;

Sign sign_by_definition(const Points& p) {
  std::vector<std::vector<Rational>> rows;
  for (const Point& x : p)
    rows.push_back({to_rational(x[0]), to_rational(x[1]), to_rational(x[2]), Rational(1)});
  return sign_of(exact_determinant(rows));
}

/// How often each stage decided; every sign is compared with the definition.
struct Stages {
  std::array<int, 5> count{};

  void decide(const Points& p) {
    const StagedSign result = orient3d_staged(p[0], p[1], p[2], p[3]);
    CHECK(result.sign == sign_by_definition(p));
    CHECK(orient3d(p[1], p[0], p[2], p[3]) == -result.sign);
    ++count[static_cast<std::size_t>(result.stage)];
  }
  int operator[](Orient3dStage stage) const { return count[static_cast<std::size_t>(stage)]; }
};

Point random_point(Random& random) {
  return {uniform_unit(random) - 0.5, uniform_unit(random) - 0.5, uniform_unit(random) - 0.5};
}

// d is rounded from a random point in the plane of a, b, c.
Points nearly_coplanar(Random& random) {
  Points p{random_point(random), random_point(random), random_point(random), Point()};
  const double s = uniform_unit(random), t = uniform_unit(random);
  p[3] = p[0] + s * (p[1] - p[0]) + t * (p[2] - p[0]);
  return p;
}

Points scaled(Points p, int exponent) {
  for (Point& x : p) x *= std::ldexp(1.0, exponent);
  return p;
}

}  // namespace

TEST_CASE("orient3d: the documented example") {
  const Point o(0, 0, 0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  CHECK(orient3d(o, x, y, z) == Sign::Negative);
  CHECK(is_beyond(o, x, y, z));
  CHECK_FALSE(is_beyond(o, x, y, Point(7, 9, 0)));
  CHECK_FALSE(is_beyond(o, x, y, Point(7, 9, -0x1p-1074)));
  CHECK(is_beyond(o, x, y, Point(7, 9, 0x1p-1074)));
}

TEST_CASE("orient3d: random points are decided by doubles") {
  Random random(1);
  Stages stages;
  for (int i = 0; i < 2000; ++i)
    stages.decide(
        {random_point(random), random_point(random), random_point(random), random_point(random)});
  CHECK(stages[Orient3dStage::A] == 2000);
}

TEST_CASE("orient3d: nearly coplanar points reach the later stages, and are decided right") {
  Random random(2);
  Stages stages;
  for (int i = 0; i < 4000; ++i) stages.decide(nearly_coplanar(random));
  CHECK(stages[Orient3dStage::A] < 400);
  CHECK(stages[Orient3dStage::B] > 100);
  CHECK(stages[Orient3dStage::C] > 100);
  CHECK(stages[Orient3dStage::Rationals] == 0);
}

TEST_CASE("orient3d: coplanar points with roundoff in their differences are decided last") {
  Random random(3);
  Stages stages;
  for (int i = 0; i < 500; ++i) {
    // In the plane z = x + y exactly: y is x times a small number, x has 50 bits and any size.
    Points p;
    for (Point& q : p) {
      const auto exponent = static_cast<int>(uniform_below(random, 20)) - 60;
      const double x = std::ldexp(static_cast<double>(random() >> 14), exponent);
      const std::array<double, 4> factors{0.5, 1, 2, -1};
      const double factor = factors[uniform_below(random, 4)];
      q = Point(x, factor * x, (1 + factor) * x);
    }
    stages.decide(p);
  }
  CHECK(stages[Orient3dStage::D] > 100);
}

TEST_CASE("orient3d: a grid of neighboring doubles around a plane") {
  Stages stages;
  const double ulp = 0x1p-53;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) {
      for (int k = 0; k < 6; ++k) {
        const Point p(0.5 + i * ulp, 0.5 + j * ulp, 0.5 + k * ulp);
        stages.decide({p, Point(12, 12, 12), Point(24, 24, 25), Point(-3, -3, -3.5)});
        stages.decide({Point(12, 12, 12), Point(24, 24, 25), p, Point(18, 18, 18.5)});
        stages.decide({p, Point(17.3, 17.3, 17.3), Point(24, 24, 24), Point(1e-9, 1e-9, 3)});
      }
    }
  }
  CHECK(stages[Orient3dStage::A] < 500);
}

TEST_CASE("orient3d: powers of two change nothing, in and out of the range of expansions") {
  Random random(4);
  Stages stages;
  for (int i = 0; i < 200; ++i) {
    const Points near = nearly_coplanar(random);
    for (const int exponent : {-900, -400, -250, -100, 0, 100, 300, 338, 345, 700, 1020})
      stages.decide(scaled(near, exponent));
  }
  CHECK(stages[Orient3dStage::Rationals] > 500);
  CHECK(stages[Orient3dStage::Rationals] < 1500);
}

TEST_CASE("orient3d: subnormal, huge and mixed coordinates") {
  const std::array<double, 12> values{0,       0x1p-1074, -0x1p-1074, 1e-310, 1e300, -1e300,
                                      0x1p338, 0x1p-306,  0x1p1023,   1,      -1,    0x1.8p-1073};
  Random random(5);
  Stages stages;
  for (int i = 0; i < 3000; ++i) {
    Points p;
    for (Point& x : p)
      for (int k = 0; k < 3; ++k) x[k] = values[uniform_below(random, values.size())];
    stages.decide(p);
  }
  CHECK(stages[Orient3dStage::Rationals] > 2000);
}

TEST_CASE("orient3d: small integers") {
  check_property("small integers", [](const std::array<std::array<std::int8_t, 3>, 4>& raw) {
    Points p;
    for (int i = 0; i < 4; ++i) p[i] = Point(raw[i][0] % 4, raw[i][1] % 4, raw[i][2] % 4);
    RC_ASSERT(orient3d(p[0], p[1], p[2], p[3]) == sign_by_definition(p));
  });
}
