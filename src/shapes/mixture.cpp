// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <limits>

#include "number/random.hpp"
#include "shapes/makers.hpp"

namespace convexact::shapes {
namespace {

using Points = std::vector<Point>;

std::uint32_t between(Random& random, std::uint32_t low, std::uint32_t high) {
  return low + static_cast<std::uint32_t>(uniform_below(random, high - low + 1));
}

// An exponent of two: mostly 0, otherwise from ever larger ranges, so that all scales meet.
int exponent(Random& random) {
  constexpr std::array<std::uint32_t, 8> kLargest{0, 0, 0, 3, 30, 60, 200, 450};
  const auto largest = kLargest[uniform_below(random, kLargest.size())];
  return static_cast<int>(between(random, 0, 2 * largest)) - static_cast<int>(largest);
}

Points some_shape(Random& random) {
  const std::uint32_t n = between(random, 4, 16), k = between(random, 3, 12);
  switch (uniform_below(random, 16)) {
    case 0:
      return in_box(n, random());
    case 1:
      return in_ball(n, random());
    case 2:
      return on_sphere(n, random());
    case 3:
      return lattice(n, between(random, 1, 4), random());
    case 4:
      return prism(k);
    case 5:
      return antiprism(k);
    case 6:
      return pyramid(k);
    case 7:
      return bipyramid(k);
    case 8:
      return cylinder(k, 2);
    case 9:
      return chamfered_box({1, 1, 1}, std::ldexp(1.0, -static_cast<int>(between(random, 1, 50))));
    case 10:
      return rounded_box({1, 2, 1}, 0.25, between(random, 1, 2));
    case 11:
      return cut_cube(between(random, 0, 8), 0.25);
    case 12:
      return tilted_lid(n, std::ldexp(1.0, -static_cast<int>(between(random, 0, 52))), random());
    case 13:
      return nearly_cospherical(n, 41, between(random, 0, 2), random());
    case 14:
      return grid(3);
    default:
      return centrally_symmetric(n, random());
  }
}

void turn(Points& points) {
  for (Point& p : points) p = Point(p[0] + p[1] + p[2], p[0] - p[1] + p[2], p[0] - 2 * p[2]);
}

void stretch(Points& points, Random& random) {
  const bool alike = uniform_below(random, 2) == 0;
  std::array<int, 3> exponents{};
  for (int& e : exponents) e = exponent(random);
  if (alike) exponents = {exponents[0], exponents[0], exponents[0]};
  for (Point& p : points) {
    for (std::size_t k = 0; k < 3; ++k) p[k] = std::ldexp(p[k], exponents[k]);
  }
}

void move(Points& points, Random& random) {
  Point by;
  for (int k = 0; k < 3; ++k) by[k] = std::ldexp(2 * uniform_unit(random) - 1, exponent(random));
  for (Point& p : points) p += by;
}

// Each point once more, some coordinates one ulp off.
void add_twins(Points& points, Random& random) {
  constexpr double kFarthest = std::numeric_limits<double>::infinity();
  const std::size_t count = points.size();
  for (std::size_t i = 0; i < count; ++i) {
    Point twin = points[i];
    for (int k = 0; k < 3; ++k) {
      const auto draw = uniform_below(random, 3);
      if (draw < 2) twin[k] = std::nextafter(twin[k], draw == 0 ? -kFarthest : kFarthest);
    }
    points.push_back(twin);
  }
}

}  // namespace

Points mixture(std::uint32_t parts, std::uint64_t seed) {
  require_parameter(parts >= 1 && parts <= 64, "a mixture has 1 to 64 parts");
  Random random(seed);
  Points all;
  for (std::uint32_t part = 0; part < parts; ++part) {
    Points points = some_shape(random);
    if (uniform_below(random, 3) == 0) turn(points);
    if (uniform_below(random, 2) == 0) stretch(points, random);
    if (uniform_below(random, 3) == 0) turn(points);
    if (uniform_below(random, 2) == 0) move(points, random);
    if (uniform_below(random, 4) == 0) add_twins(points, random);
    all.insert(all.end(), points.begin(), points.end());
  }
  return all;
}

}  // namespace convexact::shapes
