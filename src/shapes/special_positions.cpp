// SPDX-License-Identifier: MIT
// Points in exactly special positions: on a sphere, on the moment curve, on a plane, on a line.
#include <cmath>
#include <string>

#include "convexact/error.hpp"
#include "number/random.hpp"
#include "shapes/makers.hpp"

namespace convexact::shapes {
namespace {

// The whole square root of n >= 0, or -1 if n is no square. Exact, as n < 2^52.
int whole_root(int n) {
  const int root = static_cast<int>(std::lround(std::sqrt(static_cast<double>(n))));
  return root * root == n ? root : -1;
}

}  // namespace

std::vector<Point> cospherical(std::uint32_t n, std::uint32_t squared_radius, std::uint64_t seed) {
  if (squared_radius > 1000000) {
    throw Error(ErrorCode::InvalidArgument, "a squared radius is at most 10^6");
  }
  const int square = static_cast<int>(squared_radius);
  std::vector<Point> points;
  for (int x = -1000; x <= 1000; ++x) {
    for (int y = -1000; y <= 1000; ++y) {
      const int rest = square - x * x - y * y;
      const int z = rest < 0 ? -1 : whole_root(rest);
      if (z >= 0) points.emplace_back(x, y, z);
      if (z > 0) points.emplace_back(x, y, -z);
    }
  }
  if (points.size() < 4) {
    throw Error(ErrorCode::InvalidArgument, "there are no four integer points of squared radius " +
                                                std::to_string(squared_radius));
  }
  Random random(seed);
  shuffle(std::span(points), random);
  if (points.size() > n) points.resize(n);
  return points;
}

std::vector<Point> moment_curve(std::uint32_t n) {
  if (n < 4 || n > 100000) {
    throw Error(ErrorCode::InvalidArgument, "the moment curve takes 4 to 10^5 points");
  }
  std::vector<Point> points;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double t = static_cast<double>(i) - n / 2;  // |t|^3 < 2^53, so every power is exact
    points.emplace_back(t, t * t, t * t * t);
  }
  return points;
}

namespace {

// Short dyadic numbers, so that every point below is exact.
const Point kBase(0.375, -0.625, 0.875), kFirst(0.125, -0.1875, 0.3125),
    kSecond(-0.4375, 0.0625, 0.25);

double draw_step(Random& random) { return static_cast<double>(uniform_below(random, 2001)) - 1000; }

}  // namespace

std::vector<Point> all_equal(std::uint32_t n) { return std::vector<Point>(n, kBase); }

std::vector<Point> collinear(std::uint32_t n, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point> points;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double step = i < 2 ? i : draw_step(random);
    points.emplace_back(kBase + step * kFirst);
  }
  return points;
}

std::vector<Point> coplanar(std::uint32_t n, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point> points;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double first = i < 3 ? i == 1 : draw_step(random);
    const double second = i < 3 ? i == 2 : draw_step(random);
    points.emplace_back(kBase + first * kFirst + second * kSecond);
  }
  return points;
}

}  // namespace convexact::shapes
