// SPDX-License-Identifier: MIT
#include <cmath>
#include <optional>
#include <vector>

#include "convexact/measure.hpp"

namespace convexact {
namespace {

// The extreme points as integers: hull.vertices[v] has 3 entries from 3 v on, times 1 / scale.
struct ScaledPoints {
  std::vector<Integer> coordinates;
  Rational scale;
};

// x = m 2^(exponent - 53) with an integer m.
int exponent_of(double x) {
  int exponent = 0;
  std::frexp(x, &exponent);
  return std::max(exponent, -1021);
}

// Doubles times one power of two, where their spread lets that power stay within doubles.
std::optional<ScaledPoints> scale_doubles(const Hull& hull, const PointSet& points) {
  constexpr int kWidestSpread = 900;
  int lowest = 2000, highest = -2000;
  for (const PointId id : hull.vertices) {
    for (const double x : points.doubles()[id.index()]) {
      if (x == 0) continue;
      lowest = std::min(lowest, exponent_of(x));
      highest = std::max(highest, exponent_of(x));
    }
  }
  if (!points.is_binary() || highest - lowest > kWidestSpread) return std::nullopt;
  ScaledPoints scaled{std::vector<Integer>(3 * hull.vertices.size()),
                      scale_by_power_of_two(Rational(1), 53 - lowest)};
  for (std::size_t v = 0; v < hull.vertices.size(); ++v) {
    const Point& p = points.doubles()[hull.vertices[v].index()];
    for (std::size_t k = 0; k < 3; ++k) {
      // In two steps: 2^(53 - lowest) itself may be beyond doubles.
      const double x = std::ldexp(p[static_cast<long>(k)], -lowest);
      mpz_set_d(scaled.coordinates[3 * v + k].backend().data(), std::ldexp(x, 53));
    }
  }
  return scaled;
}

ScaledPoints scale_rationals(const Hull& hull, const PointSet& points) {
  Integer common = 1;
  for (const PointId id : hull.vertices) {
    for (const Rational& x : points[id]) common = lcm(common, denominator(x));
  }
  ScaledPoints scaled{std::vector<Integer>(3 * hull.vertices.size()), Rational(common)};
  for (std::size_t v = 0; v < hull.vertices.size(); ++v) {
    const RationalPoint p = points[hull.vertices[v]];
    for (std::size_t k = 0; k < 3; ++k) {
      scaled.coordinates[3 * v + k] = numerator(p[k]) * (common / denominator(p[k]));
    }
  }
  return scaled;
}

}  // namespace

Rational volume(const Hull& hull, const PointSet& points) {
  auto doubles = scale_doubles(hull, points);
  const ScaledPoints scaled = doubles ? std::move(*doubles) : scale_rationals(hull, points);
  std::vector<std::uint32_t> vertex(points.size());
  for (std::size_t v = 0; v < hull.vertices.size(); ++v) {
    vertex[hull.vertices[v].index()] = static_cast<std::uint32_t>(v);
  }
  const auto coordinate = [&](PointId id, std::size_t k) {
    return scaled.coordinates[3 * vertex[id.index()] + k % 3].backend().data();
  };
  // The sum of det(a, b, c) over a fan of each facet, in place: most of the time went to
  // temporaries.
  Integer six_volumes = 0, minor;
  for (std::size_t f = 0; f < hull.facets.size(); ++f) {
    const auto corners = hull.facets[f];
    for (std::size_t m = 2; m < corners.size(); ++m) {
      const PointId a = corners[0], b = corners[m - 1], c = corners[m];
      for (std::size_t k = 0; k < 3; ++k) {
        mpz_mul(minor.backend().data(), coordinate(b, k + 1), coordinate(c, k + 2));
        mpz_submul(minor.backend().data(), coordinate(b, k + 2), coordinate(c, k + 1));
        mpz_addmul(six_volumes.backend().data(), coordinate(a, k), minor.backend().data());
      }
    }
  }
  return Rational(six_volumes) / (6 * scaled.scale * scaled.scale * scaled.scale);
}

}  // namespace convexact
