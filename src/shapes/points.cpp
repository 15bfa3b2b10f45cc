// SPDX-License-Identifier: MIT
// Points: random ones in and on simple solids, ones in exactly special positions, and stiff ones.
#include <cmath>
#include <string>

#include "convexact/number.hpp"
#include "number/arithmetic.hpp"
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

std::vector<Point> draw_points(std::uint32_t n, std::uint64_t seed, Point (*draw)(Random&)) {
  Random random(seed);
  std::vector<Point> points;
  for (std::uint32_t i = 0; i < n; ++i) points.push_back(draw(random));
  return points;
}

Point times_power_of_two(const Point& p, int exponent) {
  return {std::ldexp(p[0], exponent), std::ldexp(p[1], exponent), std::ldexp(p[2], exponent)};
}

double squared_norm(const Point& p) { return p[0] * p[0] + p[1] * p[1] + p[2] * p[2]; }

Point draw_in_ball(Random& random) {
  Point p = draw_in_box(random);
  while (squared_norm(p) > 1) p = draw_in_box(random);
  return p;
}

}  // namespace

std::vector<Point> in_box(std::uint32_t n, std::uint64_t seed) {
  return draw_points(n, seed, draw_in_box);
}

std::vector<Point> in_ball(std::uint32_t n, std::uint64_t seed) {
  return draw_points(n, seed, draw_in_ball);
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
  require_parameter(range <= std::uint64_t(1) << 52, "a lattice reaches at most 2^52");
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

namespace {

// The whole square root of n >= 0, or -1 if n is no square. Exact, as n < 2^52.
int whole_root(int n) {
  const int root = static_cast<int>(std::lround(std::sqrt(static_cast<double>(n))));
  return root * root == n ? root : -1;
}

}  // namespace

std::vector<Point> cospherical(std::uint32_t n, std::uint32_t squared_radius, std::uint64_t seed) {
  require_parameter(squared_radius <= 1000000, "a squared radius is at most 10^6");
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
  require_parameter(n >= 4 && n <= 100000, "the moment curve takes 4 to 10^5 points");
  const std::uint32_t middle = n / 2;
  std::vector<Point> points;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double t = static_cast<double>(i) - middle;  // |t|^3 < 2^53, so every power is exact
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

std::vector<Point> needle(std::uint32_t n, double aspect, std::uint64_t seed) {
  std::vector<Point> points = slab(n, aspect, seed);
  for (Point& p : points) p[1] /= aspect;
  return points;
}

std::vector<Point> slab(std::uint32_t n, double aspect, std::uint64_t seed) {
  require_parameter(aspect >= 1 && std::isfinite(aspect), "an aspect ratio is at least 1");
  std::vector<Point> points = in_ball(n, seed);
  for (Point& p : points) p[2] /= aspect;
  return points;
}

std::vector<Point> offset_ball(std::uint32_t n, double distance, std::uint64_t seed) {
  std::vector<Point> points = in_ball(n, seed);
  for (Point& p : points) p += Point::Constant(distance);
  return points;
}

std::vector<Point> scaled_ball(std::uint32_t n, int exponent, std::uint64_t seed) {
  std::vector<Point> points = in_ball(n, seed);
  for (Point& p : points) p = times_power_of_two(p, exponent);
  return points;
}

std::vector<Point> subnormal(std::uint32_t n, std::uint64_t range, std::uint64_t seed) {
  require_parameter(range < std::uint64_t(1) << 52, "subnormal numbers have at most 52 bits");
  std::vector<Point> points = lattice(n, range, seed);
  for (Point& p : points) p = times_power_of_two(p, -1074);
  return points;
}

std::vector<Point> huge(std::uint32_t n, std::uint64_t seed) {
  std::vector<Point> points = in_box(n, seed);
  for (Point& p : points) p *= 1e300;
  return points;
}

std::vector<Point> wide_exponents(std::uint32_t n, std::uint32_t exponent, std::uint64_t seed) {
  require_parameter(exponent <= 1000, "an exponent is at most 1000");
  Random random(seed);
  std::vector<Point> points = in_box(n, random());
  for (Point& p : points) {
    for (int k = 0; k < 3; ++k) {
      const auto draw = uniform_below(random, 2 * std::uint64_t(exponent) + 1);
      p[k] = std::ldexp(p[k], static_cast<int>(draw) - static_cast<int>(exponent));
    }
  }
  return points;
}

std::vector<Point> nearly_flat(std::uint32_t n, std::uint64_t seed, std::uint64_t ulps) {
  require_parameter(ulps >= 1 && ulps < std::uint64_t(1) << 52,
                    "points lie 1 to 2^52 - 1 ulps above the plane");
  std::vector<Point> points = in_box(n, seed);
  const double above = 1 + std::ldexp(static_cast<double>(ulps), -52);
  for (std::size_t i = 0; i < points.size(); ++i) points[i][2] = i % 2 == 0 ? 1 : above;
  return points;
}

std::vector<Point> nearly_coplanar(std::uint32_t n, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point> points;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double x = uniform_unit(random), y = uniform_unit(random);
    points.emplace_back(x, y, (x + y) / 3);
  }
  points.emplace_back(1, 0, -1);
  return points;
}

std::vector<Point> tilted_lid(std::uint32_t n, double tilt, std::uint64_t seed) {
  require_parameter(tilt > 0 && tilt <= 1, "a tilt is above 0 and at most 1");
  std::vector<Point> points = in_box(n, seed);
  for (Point& p : points) p[2] = 1 + tilt * (1 - (p[0] * p[0] + p[1] * p[1]) / 2);
  const std::vector<Point> corners = box({1, 1, 1});
  points.insert(points.end(), corners.begin(), corners.end());
  return points;
}

std::vector<Point> nearly_cospherical(std::uint32_t n, std::uint32_t squared_radius,
                                      std::uint32_t ulps, std::uint64_t seed) {
  require_parameter(ulps <= 1u << 20, "at most 2^20 ulps");
  Random random(seed);
  std::vector<Point> points = cospherical(n, squared_radius, random());
  for (Point& p : points) {
    for (int k = 0; k < 3; ++k) {
      const auto draw = static_cast<double>(uniform_below(random, 2 * std::uint64_t(ulps) + 1));
      if (p[k] == 0) continue;
      p[k] += (draw - ulps) * std::ldexp(1.0, exponent_of(p[k]) - 53);
    }
  }
  return points;
}

std::vector<Point> mixed_scales(std::uint32_t n, std::uint32_t exponent, std::uint64_t seed) {
  require_parameter(exponent <= 500, "an exponent is at most 500");
  Random random(seed);
  std::vector<Point> points;
  for (int ball = 0; ball < 3; ++ball) {
    for (Point p : in_ball(n, random())) {
      p[0] += 4;
      points.push_back(times_power_of_two(p, -ball * static_cast<int>(exponent)));
    }
  }
  return points;
}

}  // namespace convexact::shapes
