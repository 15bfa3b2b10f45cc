// SPDX-License-Identifier: MIT
#include "shapes/integer.hpp"

#include <cmath>
#include <string>

#include "convexact/error.hpp"
#include "number/random.hpp"

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

}  // namespace convexact::shapes
