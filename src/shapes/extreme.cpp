// SPDX-License-Identifier: MIT
#include <cmath>

#include "convexact/error.hpp"
#include "number/arithmetic.hpp"
#include "number/random.hpp"
#include "shapes/makers.hpp"

namespace convexact::shapes {
namespace {

void require_aspect(double aspect) {
  if (!(aspect >= 1 && std::isfinite(aspect))) {
    throw Error(ErrorCode::InvalidArgument, "an aspect ratio is at least 1");
  }
}

}  // namespace

std::vector<Point> needle(std::uint32_t n, double aspect, std::uint64_t seed) {
  require_aspect(aspect);
  std::vector<Point> points = in_ball(n, seed);
  for (Point& p : points) p = Point(p[0], p[1] / aspect, p[2] / aspect);
  return points;
}

std::vector<Point> slab(std::uint32_t n, double aspect, std::uint64_t seed) {
  require_aspect(aspect);
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
  for (Point& p : points) {
    for (int k = 0; k < 3; ++k) p[k] = std::ldexp(p[k], exponent);
  }
  return points;
}

std::vector<Point> subnormal(std::uint32_t n, std::uint64_t range, std::uint64_t seed) {
  if (range >= std::uint64_t(1) << 52) {
    throw Error(ErrorCode::InvalidArgument, "subnormal numbers have at most 52 bits");
  }
  std::vector<Point> points = lattice(n, range, seed);
  for (Point& p : points) {
    for (int k = 0; k < 3; ++k) p[k] = std::ldexp(p[k], -1074);
  }
  return points;
}

std::vector<Point> huge(std::uint32_t n, std::uint64_t seed) {
  std::vector<Point> points = in_box(n, seed);
  for (Point& p : points) p *= 1e300;
  return points;
}

std::vector<Point> wide_exponents(std::uint32_t n, std::uint32_t exponent, std::uint64_t seed) {
  if (exponent > 1000) throw Error(ErrorCode::InvalidArgument, "an exponent is at most 1000");
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
  if (ulps < 1 || ulps >= std::uint64_t(1) << 52) {
    throw Error(ErrorCode::InvalidArgument, "points lie 1 to 2^52 - 1 ulps above the plane");
  }
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
  if (!(tilt > 0 && tilt <= 1)) {
    throw Error(ErrorCode::InvalidArgument, "a tilt is above 0 and at most 1");
  }
  std::vector<Point> points = in_box(n, seed);
  for (Point& p : points) p[2] = 1 + tilt * (1 - (p[0] * p[0] + p[1] * p[1]) / 2);
  const std::vector<Point> corners = box({1, 1, 1});
  points.insert(points.end(), corners.begin(), corners.end());
  return points;
}

std::vector<Point> nearly_cospherical(std::uint32_t n, std::uint32_t squared_radius,
                                      std::uint32_t ulps, std::uint64_t seed) {
  if (ulps > (1u << 20)) throw Error(ErrorCode::InvalidArgument, "at most 2^20 ulps");
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
  if (exponent > 500) throw Error(ErrorCode::InvalidArgument, "an exponent is at most 500");
  Random random(seed);
  std::vector<Point> points;
  for (int ball = 0; ball < 3; ++ball) {
    for (Point p : in_ball(n, random())) {
      p[0] += 4;
      for (int k = 0; k < 3; ++k) p[k] = std::ldexp(p[k], -ball * static_cast<int>(exponent));
      points.push_back(p);
    }
  }
  return points;
}

}  // namespace convexact::shapes
