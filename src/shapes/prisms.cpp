// SPDX-License-Identifier: MIT
#include "shapes/prisms.hpp"

#include <cmath>

#include "convexact/error.hpp"
#include "shapes/circle.hpp"

namespace convexact::shapes {
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
