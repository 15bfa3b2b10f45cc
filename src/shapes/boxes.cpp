// SPDX-License-Identifier: MIT
#include "convexact/error.hpp"
#include "shapes/makers.hpp"

namespace convexact::shapes {
namespace {

// The eight triples of signs.
std::vector<Point> octants() { return box({1, 1, 1}); }

void require(bool condition, const char* message) {
  if (!condition) throw Error(ErrorCode::InvalidArgument, message);
}

// The unit vectors of one octant: `segments` steps from the equator to the pole (0, 0, 1), which
// comes once, and as many along each circle of latitude.
std::vector<Point> octant_of_sphere(std::uint32_t segments) {
  const std::uint64_t turn = 4 * std::uint64_t(segments);
  std::vector<Point> directions;
  for (std::uint32_t i = 0; i < segments; ++i) {
    const CirclePoint latitude = on_circle(i, turn);
    for (std::uint32_t j = 0; j <= segments; ++j) {
      const CirclePoint longitude = on_circle(j, turn);
      directions.emplace_back(latitude.cosine * longitude.cosine, latitude.cosine * longitude.sine,
                              latitude.sine);
    }
  }
  directions.emplace_back(0, 0, 1);
  return directions;
}

}  // namespace

std::vector<Point> box(const Point& half) {
  std::vector<Point> points;
  for (const double z : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      for (const double x : {-1.0, 1.0}) {
        points.emplace_back(x * half[0], y * half[1], z * half[2]);
      }
    }
  }
  return points;
}

std::vector<Point> chamfered_box(const Point& half, double width) {
  require(width > 0 && width < half.minCoeff(), "a chamfer is wider than 0, narrower than the box");
  std::vector<Point> points;
  for (const Point& sign : octants()) {
    for (int axis = 0; axis < 3; ++axis) {
      Point p = half;
      for (int k = 0; k < 3; ++k) p[k] = sign[k] * (k == axis ? half[k] : half[k] - width);
      points.push_back(p);
    }
  }
  return points;
}

std::vector<Point> rounded_box(const Point& half, double radius, std::uint32_t segments) {
  require(segments >= 1, "a rounded box has at least one segment");
  require(radius > 0 && half.minCoeff() > 0, "a rounded box has positive sizes");
  const std::vector<Point> directions = octant_of_sphere(segments);
  std::vector<Point> points;
  for (const Point& sign : octants()) {
    for (const Point& d : directions) {
      // Mirrored exactly; where a component of d is 0 the points of an edge share a coordinate.
      const Point p = half + radius * d;
      points.push_back(sign.cwiseProduct(p));
    }
  }
  return points;
}

std::vector<Point> cut_cube(std::uint32_t corners, double depth) {
  require(corners <= 8, "a cube has 8 corners");
  require(depth > 0 && depth <= 0.5, "a cut is at most half an edge deep");
  std::vector<Point> points;
  for (std::uint32_t corner = 0; corner < 8; ++corner) {
    const Point p(corner & 1u, corner >> 1 & 1u, corner >> 2 & 1u);
    if (corner >= corners) {
      points.push_back(p);
      continue;
    }
    for (int axis = 0; axis < 3; ++axis) {
      Point cut = p;
      cut[axis] = p[axis] == 0 ? depth : 1 - depth;
      points.push_back(cut);
    }
  }
  return points;
}

std::vector<Point> grid(std::uint32_t n) {
  require(n >= 2, "a grid has at least 2 points a side");
  std::vector<Point> points;
  for (std::uint32_t z = 0; z < n; ++z) {
    for (std::uint32_t y = 0; y < n; ++y) {
      for (std::uint32_t x = 0; x < n; ++x) points.emplace_back(x, y, z);
    }
  }
  return points;
}

}  // namespace convexact::shapes
