// SPDX-License-Identifier: MIT
#include <cmath>
#include <optional>
#include <vector>

#include "convexact/measure.hpp"
#include "number/arithmetic.hpp"

namespace convexact {
namespace {

// The extreme points as integers: hull.vertices[v] has 3 entries from 3 v on, times 1 / scale.
struct IntegerPoints {
  std::vector<Integer> coordinates;
  Rational scale;
};

// Doubles times one power of two, where their spread lets that power stay within doubles.
std::optional<IntegerPoints> scale_doubles(const Hull& hull, const PointSet& points) {
  constexpr int kWidestSpread = 900;
  int lowest = 2000, highest = -2000;
  for (const PointId id : hull.vertices) {
    for (const double x : points.doubles()[id.index()]) {
      if (x == 0) continue;
      lowest = std::min(lowest, unit_exponent(x));
      highest = std::max(highest, unit_exponent(x));
    }
  }
  if (!points.is_binary() || highest - lowest > kWidestSpread) return std::nullopt;
  IntegerPoints scaled{std::vector<Integer>(3 * hull.vertices.size()),
                       scale_by_power_of_two(Rational(1), -lowest)};
  for (std::size_t v = 0; v < hull.vertices.size(); ++v) {
    const Point& p = points.doubles()[hull.vertices[v].index()];
    for (std::size_t k = 0; k < 3; ++k) {
      mpz_set_d(raw(scaled.coordinates[3 * v + k]), std::ldexp(p[static_cast<long>(k)], -lowest));
    }
  }
  return scaled;
}

IntegerPoints scale_rationals(const Hull& hull, const PointSet& points) {
  std::vector<Rational> coordinates;
  for (const PointId id : hull.vertices) {
    const RationalPoint p = points[id];
    coordinates.insert(coordinates.end(), p.begin(), p.end());
  }
  IntegerPoints scaled{std::vector<Integer>(coordinates.size()), 1};
  scaled.scale = clear_denominators(coordinates, scaled.coordinates);
  return scaled;
}

}  // namespace

Rational volume(const Hull& hull, const PointSet& points) {
  auto doubles = scale_doubles(hull, points);
  const IntegerPoints scaled = doubles ? std::move(*doubles) : scale_rationals(hull, points);
  std::vector<std::uint32_t> vertex(points.size());
  for (std::size_t v = 0; v < hull.vertices.size(); ++v) {
    vertex[hull.vertices[v].index()] = static_cast<std::uint32_t>(v);
  }
  const auto coordinate = [&](PointId id, std::size_t k) {
    return raw(scaled.coordinates[3 * vertex[id.index()] + k % 3]);
  };
  // The sum of det(a, b, c) over a fan of each facet, in place: most of the time went to
  // temporaries.
  Integer six_volumes = 0, minor;
  for (std::size_t f = 0; f < hull.facets.size(); ++f) {
    const auto corners = hull.facets[f];
    for (std::size_t m = 2; m < corners.size(); ++m) {
      const PointId a = corners[0], b = corners[m - 1], c = corners[m];
      for (std::size_t k = 0; k < 3; ++k) {
        mpz_mul(raw(minor), coordinate(b, k + 1), coordinate(c, k + 2));
        mpz_submul(raw(minor), coordinate(b, k + 2), coordinate(c, k + 1));
        mpz_addmul(raw(six_volumes), coordinate(a, k), raw(minor));
      }
    }
  }
  return Rational(six_volumes) / (6 * scaled.scale * scaled.scale * scaled.scale);
}

}  // namespace convexact
