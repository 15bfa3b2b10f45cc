// SPDX-License-Identifier: MIT
// Masses of models. Expected values: the closed form of a box; the eigenvalues of rounded tensors
// by their characteristic polynomial, in fractions.
#include "wire/model_body.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "convexact/geometry.hpp"
#include "convexact/mass.hpp"

using namespace convexact;

namespace {

// Of so many sides, moved and turned by a shear, so that nothing in it is a short decimal.
MassProperties box(double x, double y, double z, double slant) {
  std::vector<Point> corners;
  for (int k = 0; k < 8; ++k) {
    const double a = k & 1 ? x : 0, b = k & 2 ? y : 0, c = k & 4 ? z : 0;
    corners.emplace_back(a + slant * b + x / 2, b + slant * c, c);
  }
  const ConvexPart part = convex_part(PointSet(std::move(corners)));
  REQUIRE(part.solid.has_value());
  return mass_properties(*part.solid);
}

// Whether the roots of the characteristic polynomial of a symmetric matrix are all >= 0: its
// coefficients then alternate in sign.
bool has_no_negative_root(const Rational& trace, const Rational& minors,
                          const Rational& determinant) {
  return trace >= 0 && minors >= 0 && determinant >= 0;
}

bool may_be_of_body(const std::array<double, 6>& tensor) {
  std::array<Rational, 6> m;
  Rational half = 0;
  for (int k = 0; k < 3; ++k) half += to_rational(tensor[std::size_t(k)]) / 2;
  for (std::size_t k = 0; k < 6; ++k) m[k] = (k < 3 ? half : Rational(0)) - to_rational(tensor[k]);
  const Rational minors =
      m[0] * m[1] - m[3] * m[3] + m[0] * m[2] - m[4] * m[4] + m[1] * m[2] - m[5] * m[5];
  const Rational determinant = m[0] * (m[1] * m[2] - m[5] * m[5]) -
                               m[3] * (m[3] * m[2] - m[5] * m[4]) +
                               m[4] * (m[3] * m[5] - m[1] * m[4]);
  return has_no_negative_root(m[0] + m[1] + m[2], minors, determinant);
}

}  // namespace

TEST_CASE("model body: a box in millimeters") {
  const auto body = body_mass(box(20, 30, 40, 0), 500, Rational(1, 1000));
  REQUIRE(body);
  CHECK(body->mass == 0.012);
  CHECK(std::abs(body->center.x() - 0.02) < 1e-16);
  // m (b^2 + c^2) / 12
  CHECK(std::abs(body->inertia[0] - 0.012 * (0.03 * 0.03 + 0.04 * 0.04) / 12) < 1e-20);
  CHECK(std::abs(body->inertia[2] - 0.012 * (0.02 * 0.02 + 0.03 * 0.03) / 12) < 1e-20);
  CHECK(body->inertia[3] == 0);
}

TEST_CASE("model body: rounded tensors are those of bodies, down to needles and plates") {
  std::mt19937_64 random(49);
  std::uniform_real_distribution<double> exponent(-12, 0), share(-1, 1);
  for (int run = 0; run < 300; ++run) {
    const auto side = [&] { return std::pow(10, exponent(random)); };
    const auto body = body_mass(box(side(), side(), side(), share(random)), 1000, 1);
    REQUIRE(body);
    CHECK(may_be_of_body(body->inertia));
    CHECK(is_tensor_of_body(body->inertia));
  }
  // Rounded to the nearest alone, a plate of these sides fails: a + b = c in doubles, or less.
  CHECK_FALSE(is_tensor_of_body({1, 1, std::nextafter(2.0, 3.0), 0, 0, 0}));
  CHECK(is_tensor_of_body({1, 1, 2, 0, 0, 0}));
  CHECK_FALSE(is_tensor_of_body({1, 1, 1, 1, 0, 0}));
  CHECK_FALSE(is_tensor_of_body({0, 0, 0, 0, 0, 0}));
}

TEST_CASE("model body: nothing beyond the doubles") {
  CHECK_FALSE(body_mass(box(1e-120, 1e-120, 1e-120, 0), 1, 1));
  CHECK_FALSE(body_mass(box(1e120, 1e120, 1e120, 0), 1, 1));
  CHECK_FALSE(body_mass(box(1, 1, 1, 0), 1, scale_by_power_of_two(1, -2000)));
}

TEST_CASE("model body: two bodies as one, by the parallel axis theorem") {
  const MassProperties left = box(1, 1, 1, 0), all = box(2, 1, 1, 0);
  MassProperties right = left;
  right.center.x() += 1;
  const RationalVector3 shift(Rational(1, 2), 0, 0);  // box() begins at half of its first side
  const auto sum = put_together(std::vector{left, right});
  REQUIRE(sum);
  CHECK(sum->volume == all.volume);
  CHECK(sum->center + shift == all.center);
  CHECK(sum->moments == all.moments);
}
