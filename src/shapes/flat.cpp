// SPDX-License-Identifier: MIT
#include "shapes/flat.hpp"

#include "number/random.hpp"

namespace convexact::shapes {
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
