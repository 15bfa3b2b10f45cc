// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "convexact/error.hpp"
#include "convexact/number.hpp"
#include "number/arithmetic.hpp"
#include "number/text.hpp"
#include "pages/picture.hpp"

namespace convexact {

Point drawn_at(const RationalPoint& vertex) {
  constexpr double kLargest = std::numeric_limits<double>::max();
  Point corner;
  for (int k = 0; k < 3; ++k) {
    corner[k] = std::clamp(to_double(vertex[k], Rounding::Nearest), -kLargest, kLargest);
  }
  return corner;
}

namespace {

std::vector<Point> drawn_corners(const Polytope& solid) {
  std::vector<Point> corners;
  for (const RationalPoint& vertex : solid.vertices) corners.push_back(drawn_at(vertex));
  return corners;
}

// The numbers that people read: n.x + d <= 0 with |n| = 1; and the exact ones, unless these are the
// same.
std::string plane_text(const Halfspace& plane) {
  const IntegerVector3& n = plane.normal();
  std::string exact = fmt::format("({}, {}, {}, {})", to_string(n[0]), to_string(n[1]),
                                  to_string(n[2]), to_string(plane.offset()));
  if (n.squaredNorm() == 1) return exact;
  const long scale = -static_cast<long>(bit_length(n));
  const auto near = [&](const Integer& x) {
    return to_double(scale_by_power_of_two(Rational(x), scale), Rounding::Nearest);
  };
  const Point normal(near(n[0]), near(n[1]), near(n[2]));
  const Point unit = normal / normal.norm();
  return fmt::format("({:.6g}, {:.6g}, {:.6g}, {:.6g}), exactly {}", unit[0], unit[1], unit[2],
                     near(plane.offset()) / normal.norm(), exact);
}

}  // namespace

void PictureLayer::add(std::span<const Point> more,
                       const std::vector<std::vector<std::uint32_t>>& faces) {
  const auto first = static_cast<std::uint32_t>(points.size());
  points.insert(points.end(), more.begin(), more.end());
  for (std::vector<std::uint32_t> face : faces) {
    for (std::uint32_t& corner : face) corner += first;
    polygons.push_back(std::move(face));
  }
}

void PictureLayer::add(const Polytope& solid) { add(drawn_corners(solid), solid.facets); }

void PictureLayer::add_to_pick(const Polytope& solid, std::string solid_name) {
  add_to_pick(drawn_corners(solid), solid.facets, solid.planes, std::move(solid_name));
}

void PictureLayer::add_to_pick(std::span<const Point> corners,
                               const std::vector<std::vector<std::uint32_t>>& facets,
                               std::span<const Halfspace> planes, std::string solid_name) {
  CONVEXACT_ASSERT(facets.size() == planes.size());
  add(corners, facets);
  PictureSolid& solid = solids.emplace_back();
  solid.name = std::move(solid_name);
  for (const Halfspace& plane : planes) solid.planes.push_back(plane_text(plane));
}

void PictureLayer::add_ball(const Point& center, double radius) {
  constexpr std::uint32_t kRings = 12, kSides = 24;
  const double pi = std::acos(-1.0);
  std::vector<Point> places;
  std::vector<std::vector<std::uint32_t>> quads;
  for (std::uint32_t i = 0; i <= kRings; ++i) {
    const double polar = pi * i / kRings;
    for (std::uint32_t j = 0; j < kSides; ++j) {
      const double turn = 2 * pi * j / kSides;
      places.push_back(center + radius * Point(std::sin(polar) * std::cos(turn),
                                               std::sin(polar) * std::sin(turn), std::cos(polar)));
      if (i == kRings) continue;
      const std::uint32_t next = (j + 1) % kSides, row = i * kSides;
      quads.push_back({row + j, row + kSides + j, row + kSides + next, row + next});
    }
  }
  add(places, quads);
}

void PictureLayer::add_facet(const Polytope& solid, std::size_t facet) {
  std::vector<Point> corners;
  std::vector<std::uint32_t> polygon;
  for (const std::uint32_t corner : solid.facets[facet]) {
    polygon.push_back(static_cast<std::uint32_t>(corners.size()));
    corners.push_back(drawn_at(solid.vertices[corner]));
  }
  add(corners, {polygon});
}

}  // namespace convexact
