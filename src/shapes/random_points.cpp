// SPDX-License-Identifier: MIT
#include <cmath>

#include "convexact/error.hpp"
#include "convexact/number.hpp"
#include "number/random.hpp"
#include "shapes/makers.hpp"

namespace convexact::shapes {
namespace {

// Coordinates are drawn one by one: the order of evaluation of arguments is not fixed.
Point draw_in_box(Random& random) {
  Point p;
  for (int k = 0; k < 3; ++k) p[k] = 2 * uniform_unit(random) - 1;
  return p;
}

double squared_norm(const Point& p) { return p[0] * p[0] + p[1] * p[1] + p[2] * p[2]; }

Point draw_in_ball(Random& random) {
  Point p = draw_in_box(random);
  while (squared_norm(p) > 1) p = draw_in_box(random);
  return p;
}

}  // namespace

std::vector<Point> in_box(std::uint32_t n, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point> points;
  for (std::uint32_t i = 0; i < n; ++i) points.push_back(draw_in_box(random));
  return points;
}

std::vector<Point> in_ball(std::uint32_t n, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point> points;
  for (std::uint32_t i = 0; i < n; ++i) points.push_back(draw_in_ball(random));
  return points;
}

std::vector<Point> on_sphere(std::uint32_t n, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point> points;
  while (points.size() < n) {
    const Point p = draw_in_ball(random);
    const double norm = std::sqrt(squared_norm(p));
    if (norm > 0.125) points.push_back(p / norm);  // the shorter ones have lost bits
  }
  return points;
}

std::vector<Point> repeated_sphere(std::uint32_t n, std::uint32_t copies, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point> points;
  for (const Point& p : on_sphere(n, random())) points.insert(points.end(), copies, p);
  shuffle(std::span(points), random);
  return points;
}

std::vector<Point> lattice(std::uint32_t n, std::uint64_t range, std::uint64_t seed) {
  if (range > std::uint64_t(1) << 52) {
    throw Error(ErrorCode::InvalidArgument, "a lattice reaches at most 2^52");
  }
  Random random(seed);
  std::vector<Point> points(n);
  for (Point& p : points) {
    for (int k = 0; k < 3; ++k) {
      p[k] = static_cast<double>(uniform_below(random, 2 * range + 1)) - static_cast<double>(range);
    }
  }
  return points;
}

std::vector<Point> fibonacci_sphere(std::uint32_t n) {
  // Point i: z = 1 - (2i + 1)/n, longitude 2 pi i / golden. At 96 bits the angle is good to 2^-60.
  BigFloat golden_angle(96), angle(96), sine(64), cosine(64);
  mpfr_sqrt_ui(golden_angle.data(), 5, MPFR_RNDN);
  mpfr_sub_ui(golden_angle.data(), golden_angle.data(), 1, MPFR_RNDN);
  mpfr_const_pi(angle.data(), MPFR_RNDN);
  mpfr_mul(golden_angle.data(), golden_angle.data(), angle.data(), MPFR_RNDN);  // 2 pi / golden
  std::vector<Point> points;
  for (std::uint32_t i = 0; i < n; ++i) {
    mpfr_mul_ui(angle.data(), golden_angle.data(), i, MPFR_RNDN);
    mpfr_sin_cos(sine.data(), cosine.data(), angle.data(), MPFR_RNDN);
    const double z = 1 - (2.0 * i + 1) / n;
    const double radius = std::sqrt((1 - z) * (1 + z));
    points.emplace_back(radius * mpfr_get_d(cosine.data(), MPFR_RNDN),
                        radius * mpfr_get_d(sine.data(), MPFR_RNDN), z);
  }
  return points;
}

std::vector<Point> centrally_symmetric(std::uint32_t n, std::uint64_t seed) {
  std::vector<Point> points = in_box(n, seed);
  for (std::uint32_t i = 0; i < n; ++i) points.push_back(-points[i]);
  return points;
}

std::vector<Point> cube_symmetric(std::uint32_t n, std::uint64_t range, std::uint64_t seed) {
  std::vector<Point> points;
  for (const Point& p : lattice(n, range, seed)) {
    for (int shift = 0; shift < 3; ++shift) {
      const double x = p[shift], y = p[(shift + 1) % 3], z = p[(shift + 2) % 3];
      for (const Point& image : {Point(x, y, z), Point(y, x, z)}) {
        for (const Point& corner : box(image)) points.push_back(corner);
      }
    }
  }
  return points;
}

}  // namespace convexact::shapes
