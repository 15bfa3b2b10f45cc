// SPDX-License-Identifier: MIT
// The regular solids, boxes, and solids over a polygon.
#include <cmath>
#include <utility>

#include "convexact/number.hpp"
#include "number/arithmetic.hpp"
#include "number/precision.hpp"
#include "shapes/makers.hpp"

namespace convexact::shapes {
namespace {

constexpr double kGoldenRatio = 0x1.9e3779b97f4a8p+0;  // (1 + sqrt(5)) / 2, nearest double

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
  std::vector<Point> points = cube();
  add_rectangles(points, 1 - h * h, 1 + h);
  return points;
}

}  // namespace

std::vector<Point> tetrahedron() { return {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}; }

std::vector<Point> cube() { return box({1, 1, 1}); }

std::vector<Point> octahedron() {
  return {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
}

std::vector<Point> dodecahedron() {
  // With 25 bits, h^2 has 50 and 1 - h^2 is exact.
  const double h = std::ldexp(std::floor(std::ldexp(kGoldenRatio - 1, 25)), -25);
  return pyritohedron(h);
}

std::vector<Point> rounded_dodecahedron() {
  std::vector<Point> points = cube();
  add_rectangles(points, kGoldenRatio - 1, kGoldenRatio);
  return points;
}

std::vector<Point> icosahedron() {
  std::vector<Point> points;
  add_rectangles(points, 1, kGoldenRatio);
  return points;
}

namespace {

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
  require_parameter(width > 0 && width < half.minCoeff(),
                    "a chamfer is wider than 0, narrower than the box");
  std::vector<Point> points;
  for (const Point& sign : cube()) {
    for (int axis = 0; axis < 3; ++axis) {
      Point p = half;
      for (int k = 0; k < 3; ++k) p[k] = sign[k] * (k == axis ? half[k] : half[k] - width);
      points.push_back(p);
    }
  }
  return points;
}

std::vector<Point> rounded_box(const Point& half, double radius, std::uint32_t segments) {
  require_parameter(segments >= 1, "a rounded box has at least one segment");
  require_parameter(radius > 0 && half.minCoeff() > 0, "a rounded box has positive sizes");
  const std::vector<Point> directions = octant_of_sphere(segments);
  std::vector<Point> points;
  for (const Point& sign : cube()) {
    for (const Point& d : directions) {
      // Mirrored exactly; where a component of d is 0 the points of an edge share a coordinate.
      const Point p = half + radius * d;
      points.push_back(sign.cwiseProduct(p));
    }
  }
  return points;
}

std::vector<Point> cut_cube(std::uint32_t corners, double depth) {
  require_parameter(corners <= 8, "a cube has 8 corners");
  require_parameter(depth > 0 && depth <= 0.5, "a cut is at most half an edge deep");
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
  require_parameter(n >= 2, "a grid has at least 2 points a side");
  std::vector<Point> points;
  for (std::uint32_t z = 0; z < n; ++z) {
    for (std::uint32_t y = 0; y < n; ++y) {
      for (std::uint32_t x = 0; x < n; ++x) points.emplace_back(x, y, z);
    }
  }
  return points;
}

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
  // (Not mpfr_mul_ui: its word may have 32 bits.)
  mpfr_mul_z(angle.data(), angle.data(), raw(Integer(a)), MPFR_RNDN);
  mpfr_div_z(angle.data(), angle.data(), raw(Integer(b)), MPFR_RNDN);
  mpfr_sin_cos(sine.data(), cosine.data(), angle.data(), MPFR_RNDN);
  return {mpfr_get_d(cosine.data(), MPFR_RNDN), mpfr_get_d(sine.data(), MPFR_RNDN)};
}

}  // namespace

CirclePoint on_circle(std::uint64_t k, std::uint64_t n) {
  // The angle is pi a / b throughout; each line halves the range of the angle that is left.
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
  require_parameter(k >= 3, "a polygon has at least 3 corners");
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
  require_parameter(rings >= 2, "a cylinder has at least 2 rings");
  const std::vector<CirclePoint> corners = polygon(k);
  std::vector<Point> points;
  for (std::uint32_t j = 0; j < rings; ++j) {
    // Rounding may move a ring, but its points stay straight above those of the lowest ring.
    add_ring(points, corners, 1, static_cast<double>(j) / (rings - 1) - 0.5);
  }
  return points;
}

std::vector<Point> cone(std::uint32_t k, std::uint32_t rings) {
  require_parameter(rings >= 1 && rings <= 50, "a cone has 1 to 50 rings");
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
