// SPDX-License-Identifier: MIT
// motion.hpp - small points, and changes of them that keep the enclosed solid.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <vector>

#include "convexact/hull.hpp"
#include "number/random.hpp"

namespace motion {

using namespace convexact;

using Points = std::vector<Point>;
using Coordinates = std::vector<std::array<std::int8_t, 3>>;

// Few values, so that coplanar points, repeats and ties are common.
inline Points small_points(const Coordinates& raw) {
  Points points;
  for (const auto& p : raw) points.emplace_back(p[0] % 4, p[1] % 4, p[2] % 4);
  return points;
}

// x -> 2^exponent (s_k x_{axis k} + by_k), exactly for small integers.
struct Motion {
  std::array<int, 3> axis{0, 1, 2}, sign{1, 1, 1};
  Point by = Point::Zero();
  int exponent = 0;

  static Motion translation_and_scale(const std::array<std::int32_t, 3>& by, std::int8_t e) {
    return {{0, 1, 2}, {1, 1, 1}, Point(by[0], by[1], by[2]), 2 * e};
  }
  // One of the 48 symmetries of the axes.
  static Motion symmetry(unsigned m) {
    Motion motion;
    for (unsigned k = 0; k < m / 8 % 6; ++k) {
      std::next_permutation(motion.axis.begin(), motion.axis.end());
    }
    for (unsigned k = 0; k < 3; ++k) motion.sign[k] = m >> k & 1 ? -1 : 1;
    return motion;
  }
  Point operator()(const Point& p) const {
    Point q;
    for (int k = 0; k < 3; ++k) q[k] = std::ldexp(sign[k] * p[axis[k]] + by[k], exponent);
    return q;
  }
  Points operator()(const Points& points) const {
    Points moved;
    for (const Point& p : points) moved.push_back((*this)(p));
    return moved;
  }
  Halfspace operator()(const Halfspace& h) const {
    RationalVector3 normal;
    for (int k = 0; k < 3; ++k) normal[k] = Rational(h.normal()[axis[k]] * sign[k]);
    const Rational offset = Rational(h.offset()) - normal.dot(to_rational(by));
    return {normal, scale_by_power_of_two(offset, exponent)};
  }
};

// The same points in another order, some again, and some means of two, which are inside or on the
// boundary.
inline Points with_irrelevant(Points points, std::uint64_t seed) {
  Random random(seed);
  const std::size_t n = points.size();
  for (std::size_t k = 0; n > 0 && k < 5; ++k) {
    const Point p = points[uniform_below(random, n)], q = points[uniform_below(random, n)];
    points.push_back(k < 2 ? p : Point((p + q) / 2));
  }
  shuffle(std::span(points), random);
  return points;
}

inline std::optional<Hull> hull_of(const Points& points, std::uint64_t seed = 1) {
  HullOutcome outcome = convex_hull(PointSet(points), {.seed = seed});
  if (!std::holds_alternative<Hull>(outcome)) return {};
  return std::get<Hull>(std::move(outcome));
}

inline std::set<Halfspace> planes_of(const Points& points, std::uint64_t seed = 1) {
  const auto hull = hull_of(points, seed);
  if (!hull) return {};
  const std::vector<Halfspace> planes = facet_halfspaces(*hull, PointSet(points));
  return {planes.begin(), planes.end()};
}

}  // namespace motion
