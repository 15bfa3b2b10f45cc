// SPDX-License-Identifier: MIT
#include <cmath>
#include <utility>

#include "convexact/error.hpp"
#include "convexact/number.hpp"
#include "number/precision.hpp"
#include "shapes/makers.hpp"

namespace convexact::shapes {
namespace {

// Cosine and sine of pi a / b for 0 <= a / b <= 1/4.
CirclePoint in_first_octant(std::uint64_t a, std::uint64_t b) {
  if (4 * a == b) {
    // Both are the square root of 1/2; MPFR's two results could differ in the last bit.
    BigFloat half(kMeasureBits);
    mpfr_set_d(half.data(), 0.5, MPFR_RNDN);
    mpfr_sqrt(half.data(), half.data(), MPFR_RNDN);
    const double root = mpfr_get_d(half.data(), MPFR_RNDN);
    return {root, root};
  }
  BigFloat angle(kMeasureBits), sine(kMeasureBits), cosine(kMeasureBits);
  mpfr_const_pi(angle.data(), MPFR_RNDN);
  mpfr_mul_ui(angle.data(), angle.data(), a, MPFR_RNDN);
  mpfr_div_ui(angle.data(), angle.data(), b, MPFR_RNDN);
  mpfr_sin_cos(sine.data(), cosine.data(), angle.data(), MPFR_RNDN);
  return {mpfr_get_d(cosine.data(), MPFR_RNDN), mpfr_get_d(sine.data(), MPFR_RNDN)};
}

}  // namespace

CirclePoint on_circle(std::uint64_t k, std::uint64_t n) {
  // The angle is pi a / b throughout; each line folds it into half of what was left.
  std::uint64_t a = 2 * (k % n), b = n;
  const bool below = a > b;  // sine < 0
  if (below) a = 2 * b - a;
  const bool left = 2 * a > b;  // cosine < 0
  if (left) a = b - a;
  const bool steep = 4 * a > b;  // sine > cosine: take the complement pi (b - 2a) / (2b)
  CirclePoint p = steep ? in_first_octant(b - 2 * a, 2 * b) : in_first_octant(a, b);
  if (steep) std::swap(p.cosine, p.sine);
  if (left) p.cosine = -p.cosine;
  if (below) p.sine = -p.sine;
  return p;
}

namespace {

std::vector<CirclePoint> polygon(std::uint32_t k) {
  if (k < 3) throw Error(ErrorCode::InvalidArgument, "a polygon has at least 3 corners");
  std::vector<CirclePoint> corners;
  for (std::uint32_t i = 0; i < k; ++i) corners.push_back(on_circle(i, k));
  return corners;
}

void add_ring(std::vector<Point>& points, const std::vector<CirclePoint>& corners, double scale,
              double z) {
  for (const CirclePoint& p : corners) points.emplace_back(scale * p.cosine, scale * p.sine, z);
}

}  // namespace

std::vector<Point> prism(std::uint32_t k) { return cylinder(k, 2); }

std::vector<Point> antiprism(std::uint32_t k) {
  const std::vector<CirclePoint> both = polygon(2 * k);
  std::vector<Point> points;
  for (std::size_t i = 0; i < both.size(); ++i) {
    points.emplace_back(both[i].cosine, both[i].sine, i % 2 == 0 ? -0.5 : 0.5);
  }
  return points;
}

std::vector<Point> pyramid(std::uint32_t k) { return cone(k, 1); }

std::vector<Point> bipyramid(std::uint32_t k) {
  std::vector<Point> points = pyramid(k);
  points.emplace_back(0, 0, -1);
  return points;
}

std::vector<Point> cylinder(std::uint32_t k, std::uint32_t rings) {
  if (rings < 2) throw Error(ErrorCode::InvalidArgument, "a cylinder has at least 2 rings");
  const std::vector<CirclePoint> corners = polygon(k);
  std::vector<Point> points;
  for (std::uint32_t j = 0; j < rings; ++j) {
    // Rounding may move a ring, but its points stay straight above those of the lowest ring.
    add_ring(points, corners, 1, static_cast<double>(j) / (rings - 1) - 0.5);
  }
  return points;
}

std::vector<Point> cone(std::uint32_t k, std::uint32_t rings) {
  if (rings < 1 || rings > 50) {
    throw Error(ErrorCode::InvalidArgument, "a cone has 1 to 50 rings");
  }
  const std::vector<CirclePoint> corners = polygon(k);
  std::vector<Point> points;
  for (std::uint32_t j = 0; j < rings; ++j) {
    const double scale = std::ldexp(1.0, -static_cast<int>(j));
    add_ring(points, corners, scale, 1 - scale);  // exact: 1 - 2^-j has j bits
  }
  points.emplace_back(0, 0, 1);
  return points;
}

}  // namespace convexact::shapes
