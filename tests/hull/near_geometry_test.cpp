// SPDX-License-Identifier: MIT
// The hull's static filters at the worst inputs that a search finds: never broken, by rationals,
// and not so wide that they would be of no use.
#include "near/near_geometry.hpp"

#include <doctest/doctest.h>

#include "hill_climb.hpp"

using namespace convexact;

namespace {

NearPoint near_point(const std::vector<double>& x, std::size_t p) {
  return {x[3 * p], x[3 * p + 1], x[3 * p + 2]};
}

std::vector<Rational> rationals(const std::vector<double>& x) {
  std::vector<Rational> all;
  for (const double c : x) all.push_back(to_rational(c));
  return all;
}

// det of the rows p, q, r: affine in each coordinate.
Rational determinant(const std::vector<Rational>& p, const std::vector<Rational>& q,
                     const std::vector<Rational>& r) {
  return p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) +
         p[2] * (q[0] * r[1] - q[1] * r[0]);
}
std::vector<Rational> row(const std::vector<Rational>& x, std::size_t p) {
  return {x[3 * p], x[3 * p + 1], x[3 * p + 2]};
}
std::vector<Rational> difference(const std::vector<Rational>& x, std::size_t p) {
  return {x[3 * p] - x[0], x[3 * p + 1] - x[1], x[3 * p + 2] - x[2]};
}
Rational true_height(const std::vector<Rational>& x) {
  return determinant(difference(x, 1), difference(x, 2), difference(x, 3));
}
Rational true_center_side(const std::vector<Rational>& x) {
  return determinant(row(x, 0), row(x, 1), row(x, 2));
}

double ratio_of(const Rational& distance, double bound) {
  return Rational(distance / to_rational(bound)).convert_to<double>();
}

// kNearError is absolute for points of the cube; these have coordinates of nearly that size.
double height_ratio(const std::vector<double>& x) {
  const NearPlane plane = NearPlane::through(near_point(x, 0), near_point(x, 1), near_point(x, 2));
  const Rational computed = to_rational(plane.height(near_point(x, 3)));
  return ratio_of(
      hill_climb::worst_distance(computed, rationals(x), to_rational(kNearError), true_height),
      plane.bound);
}
double center_ratio(const std::vector<double>& x) {
  const NearPoint normal = cross(near_point(x, 0), near_point(x, 1));
  const Rational computed = to_rational(dot(normal, near_point(x, 2)));
  return ratio_of(
      hill_climb::worst_distance(computed, rationals(x), to_rational(kNearError), true_center_side),
      kCenterBound);
}

}  // namespace

TEST_CASE("NearPlane: the bound holds for the worst points found, and is not vacuous") {
  const double ratio = hill_climb::highest(12, 20, 400, 1, height_ratio);
  MESSAGE("height: " << ratio << " of the bound is reached");
  CHECK(ratio <= 1);
  CHECK(ratio > 0.1);
}

// In closed form: a, b, c are one point in doubles, and their true edges are 16u (1, 1, 0) and
// 16u (0, 1, 1), whose product with 2 (1, -1, 1) is 1536 u^2, of 8192 in the bound.
TEST_CASE("NearPlane: the bound pays for points that only differ by their errors") {
  const NearPoint q{-1, 1, -1}, p{1, -1, 1};
  const NearPlane plane = NearPlane::through(q, q, q);
  CHECK(plane.height(p) == 0);
  const Rational e = to_rational(kNearError);
  const Rational truth =
      true_height({-1 - e, 1 - e, -1 - e, -1 + e, 1 + e, -1 - e, -1 - e, 1 + e, -1 + e, 1, -1, 1});
  CHECK(truth >= to_rational(1536 * 0x1p-106));
  CHECK(truth <= to_rational(plane.bound));
  CHECK(16 * truth > to_rational(plane.bound));
}

TEST_CASE("kCenterBound: it holds for the worst points found, and is not vacuous") {
  const double ratio = hill_climb::highest(9, 20, 400, 2, center_ratio);
  MESSAGE("side of the center: " << ratio << " of the bound is reached");
  CHECK(ratio <= 1);
  CHECK(ratio > 0.1);
}
