// SPDX-License-Identifier: MIT
// perturb.hpp - makes points harder: one ulp off, stretched, sheared, far away.
#pragma once
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "convexact/geometry.hpp"
#include "number/random.hpp"

namespace perturb {

using convexact::Point;
using convexact::Random;
using Points = std::vector<Point>;

/// Each coordinate moved to its lower or upper neighbor, or not at all, with equal chances.
/// @param after_zero  The number taken as the neighbor of 0: 2^-53, as for numbers of size 1, or
///                    the true one, 2^-1074.
inline Points nudged(Points points, std::uint64_t seed, double after_zero = 0x1p-53) {
  Random random(seed);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (Point& p : points) {
    for (int k = 0; k < 3; ++k) {
      const auto draw = convexact::uniform_below(random, 3);
      if (draw == 2) continue;
      const double towards = draw == 0 ? -kInfinity : kInfinity;
      p[k] = p[k] == 0 ? std::copysign(after_zero, towards) : std::nextafter(p[k], towards);
    }
  }
  return points;
}

/// Axis k times 2^exponents[k]: exact while nothing leaves the range of normal doubles.
inline Points stretched(Points points, const std::array<int, 3>& exponents) {
  for (Point& p : points) {
    for (int k = 0; k < 3; ++k) p[k] = std::ldexp(p[k], exponents[k]);
  }
  return points;
}

/// (x, y, z) to x (1, 1, 1) + y (1, -1, 0) + z (1, 1, -2), rounded: axes become skew.
inline Points turned(Points points) {
  for (Point& p : points) p = Point(p[0] + p[1] + p[2], p[0] - p[1] + p[2], p[0] - 2 * p[2]);
  return points;
}

/// Sums with more than 53 bits are rounded.
inline Points shifted(Points points, const Point& by) {
  for (Point& p : points) p += by;
  return points;
}

/// Each point with its image under x -> -x.
inline Points with_opposites(Points points) {
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i) points.push_back(-points[i]);
  return points;
}

/// `count` more points, each rounded from a random point of the plane of three of them: beyond,
/// in or behind that plane by about one ulp.
inline Points with_points_near_planes(Points points, std::size_t count, std::uint64_t seed) {
  Random random(seed);
  const std::size_t n = points.size();
  const auto draw = [&]() -> Point { return points[convexact::uniform_below(random, n)]; };
  for (std::size_t i = 0; i < count; ++i) {
    const Point a = draw(), b = draw(), c = draw();
    const double s = convexact::uniform_unit(random), t = convexact::uniform_unit(random);
    points.push_back(a + s * (b - a) + (1 - s) * t * (c - a));
  }
  return points;
}

/// `count` more points, each equal to one that is there, and all in random order.
inline Points with_repeats(Points points, std::size_t count, std::uint64_t seed) {
  Random random(seed);
  for (std::size_t i = 0; i < count; ++i) {
    const Point again = points[convexact::uniform_below(random, points.size())];
    points.push_back(again);
  }
  convexact::shuffle(std::span<Point>(points), random);
  return points;
}

}  // namespace perturb
