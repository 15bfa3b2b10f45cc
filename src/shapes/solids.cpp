// SPDX-License-Identifier: MIT
#include <cmath>

#include "shapes/makers.hpp"

namespace convexact::shapes {
namespace {

constexpr double kGoldenRatio = 0x1.9e3779b97f4a8p+0;  // (1 + sqrt(5)) / 2, nearest double

std::vector<Point> cube_corners() {
  std::vector<Point> points;
  for (const double z : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      for (const double x : {-1.0, 1.0}) points.emplace_back(x, y, z);
    }
  }
  return points;
}

// The points (0, +-y, +-z) and their cyclic shifts.
void add_rectangles(std::vector<Point>& points, double y, double z) {
  for (const double v : {-y, y}) {
    for (const double w : {-z, z}) {
      points.emplace_back(0, v, w);
      points.emplace_back(w, 0, v);
      points.emplace_back(v, w, 0);
    }
  }
}

// The cube and a roof of height h on each side. The pentagon (1, +-1, 1), (0, +-(1 - h^2), 1 + h),
// (1 + h, 0, 1 - h^2) is plane for every 0 < h < 1: it lies on h x + z = 1 + h, and the others are
// its mirror images and shifts. h = 1/golden makes it regular.
std::vector<Point> pyritohedron(double h) {
  std::vector<Point> points = cube_corners();
  add_rectangles(points, 1 - h * h, 1 + h);
  return points;
}

}  // namespace

std::vector<Point> tetrahedron() { return {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}; }

std::vector<Point> cube() { return cube_corners(); }

std::vector<Point> octahedron() {
  return {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
}

std::vector<Point> dodecahedron() {
  // With 25 bits, h^2 has 50 and 1 - h^2 is exact.
  const double h = std::ldexp(std::floor(std::ldexp(kGoldenRatio - 1, 25)), -25);
  return pyritohedron(h);
}

std::vector<Point> rounded_dodecahedron() {
  std::vector<Point> points = cube_corners();
  add_rectangles(points, kGoldenRatio - 1, kGoldenRatio);
  return points;
}

std::vector<Point> icosahedron() {
  std::vector<Point> points;
  add_rectangles(points, 1, kGoldenRatio);
  return points;
}

}  // namespace convexact::shapes
