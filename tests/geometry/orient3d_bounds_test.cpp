// SPDX-License-Identifier: MIT
// The error bounds of orient3d's stages at the worst inputs that a search finds: never broken, by
// rationals, and not so wide that they would be of no use.
#include "orient3d_bounds.hpp"

#include <doctest/doctest.h>

#include <array>

#include "exact_determinant.hpp"
#include "hill_climb.hpp"

using namespace convexact;

namespace {

Point point(const std::vector<double>& x, std::size_t p) {
  return {x[3 * p], x[3 * p + 1], x[3 * p + 2]};
}

// det[a-d; b-d; c-d], of the true differences or of those that doubles make of them.
Rational true_determinant(const std::vector<double>& x) {
  std::vector<std::vector<Rational>> rows;
  for (std::size_t p = 0; p < 3; ++p) {
    rows.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      rows.back().push_back(to_rational(x[3 * p + k]) - to_rational(x[9 + k]));
    }
  }
  return exact_determinant(rows);
}
Rational determinant_of_rounded(const std::vector<double>& x) {
  std::vector<std::vector<Rational>> rows;
  for (std::size_t p = 0; p < 3; ++p) {
    rows.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) rows.back().push_back(to_rational(x[3 * p + k] - x[9 + k]));
  }
  return exact_determinant(rows);
}

double ratio_of(const Rational& value, const Rational& truth, double bound) {
  if (bound == 0) return value == truth ? 0 : 2;
  return Rational(abs(Rational(value - truth)) / to_rational(bound)).convert_to<double>();
}

// Each stage's error over its bound.
std::array<double, 3> ratios(const std::vector<double>& x) {
  const auto s = orient3d_bounds(point(x, 0), point(x, 1), point(x, 2), point(x, 3));
  const Rational truth = true_determinant(x);
  return {ratio_of(to_rational(s.value_a), truth, s.bound_a),
          ratio_of(determinant_of_rounded(x), truth, s.bound_b),
          ratio_of(to_rational(s.value_c), truth, s.bound_c)};
}

void check_stage(const char* name, std::size_t stage, double least) {
  const double ratio = hill_climb::highest(
      12, 20, 600, stage + 1, [&](const std::vector<double>& x) { return ratios(x)[stage]; });
  MESSAGE(std::string(name) << ": " << ratio << " of the bound is reached");
  CHECK(ratio <= 1);
  CHECK(ratio > least);
}

}  // namespace

TEST_CASE("orient3d: the bounds hold for the worst points found, and are not vacuous") {
  check_stage("stage A", 0, 0.1);
  check_stage("stage B", 1, 0.1);
  check_stage("stage C", 2, 0.01);
}

TEST_CASE("orient3d: the bounds hold for points an ulp apart around a plane") {
  Random random(1);
  for (int t = 0; t < 2000; ++t) {
    std::vector<double> x = hill_climb::start(9, random);
    const double s = uniform_unit(random), r = uniform_unit(random);
    for (std::size_t k = 0; k < 3; ++k) {
      const double in_plane = x[k] + s * (x[3 + k] - x[k]) + r * (x[6 + k] - x[k]);
      x.push_back(in_plane + static_cast<double>(uniform_below(random, 5)) * 0x1p-53 - 0x1p-52);
    }
    for (const double ratio : ratios(x)) CHECK(ratio <= 1);
  }
}

// Everything is homogeneous of degree three, and a power of two rounds nothing: so what holds for
// the points above holds at every scale.
TEST_CASE("orient3d: values and bounds grow with the cube of a power of two") {
  Random random(5);
  for (int t = 0; t < 100; ++t) {
    std::vector<double> x = hill_climb::start(12, random);
    const auto s = orient3d_bounds(point(x, 0), point(x, 1), point(x, 2), point(x, 3));
    for (double& c : x) c *= 0x1p30;
    const auto b = orient3d_bounds(point(x, 0), point(x, 1), point(x, 2), point(x, 3));
    CHECK(b.value_a == s.value_a * 0x1p90);
    CHECK(b.bound_a == s.bound_a * 0x1p90);
    CHECK(b.bound_b == s.bound_b * 0x1p90);
    CHECK(b.value_c == s.value_c * 0x1p90);
    CHECK(b.bound_c == s.bound_c * 0x1p90);
  }
}
