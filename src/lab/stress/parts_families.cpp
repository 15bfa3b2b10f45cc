// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include "lab/stress/parts_stress.hpp"

namespace convexact {
namespace {

using Corners = std::array<Point, 8>;  // of a box: x fastest, low first

Corners box(const Point& low, const Point& high) {
  Corners corners;
  for (unsigned k = 0; k < 8; ++k) {
    for (unsigned axis = 0; axis < 3; ++axis) {
      corners[k][axis] = (k >> axis & 1) != 0 ? high[axis] : low[axis];
    }
  }
  return corners;
}

// Turned about the axis of z.
Corners turned(Corners corners, double angle) {
  for (Point& p : corners) {
    p = Point(p[0] * std::cos(angle) - p[1] * std::sin(angle),
              p[0] * std::sin(angle) + p[1] * std::cos(angle), p[2]);
  }
  return corners;
}

class Solids {
 public:
  // @param is_inverted  Its faces look inward: a cavity.
  void add(const Corners& corners, bool is_inverted = false) {
    static constexpr std::uint32_t kFaces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                                   {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    const auto first = static_cast<std::uint32_t>(points_.size());
    points_.insert(points_.end(), corners.begin(), corners.end());
    for (const auto& face : kFaces) {
      std::vector<std::uint32_t> polygon;
      for (const std::uint32_t c : face) polygon.push_back(first + c);
      if (is_inverted) std::reverse(polygon.begin(), polygon.end());
      polygons_.push_back(std::move(polygon));
    }
  }
  Mesh mesh() const {
    Mesh mesh;
    mesh.points = PointSet(points_);
    mesh.polygons = polygons_;
    return mesh;
  }

 private:
  std::vector<Point> points_;
  std::vector<std::vector<std::uint32_t>> polygons_;
};

// An open box of five walls, which overlap along the edges, scaled and moved.
Mesh bin(double wall, double scale = 1, double offset = 0) {
  Solids solids;
  const double far = 2 - wall;
  const std::pair<Point, Point> walls[] = {{{0, 0, 0}, {2, 2, wall}},
                                           {{0, 0, 0}, {wall, 2, 2}},
                                           {{far, 0, 0}, {2, 2, 2}},
                                           {{0, 0, 0}, {2, wall, 2}},
                                           {{0, far, 0}, {2, 2, 2}}};
  for (const auto& [low, high] : walls) {
    Corners corners = box(low, high);
    for (Point& p : corners) p = p * scale + Point::Constant(offset);
    solids.add(corners);
  }
  return solids.mesh();
}

Mesh needles(double width) {
  Solids solids;
  for (int k = 0; k < 3; ++k) {
    solids.add(turned(box({-1, 0, 0}, {1, width, width}), 0.7 * k));
    solids.add(turned(box({-1, -1, -1}, {1, 1, width - 1}), 0.3 * k));
  }
  return solids.mesh();
}

// Two hollow boxes that cross, the second one moved by that much.
Mesh crossing_shells(double shift) {
  Solids solids;
  for (const double by : {0.0, shift}) {
    solids.add(box(Point(by, by, 0), Point(4 + by, 4 + by, 4)));
    solids.add(box(Point(1 + by, 1 + by, 1), Point(3 + by, 3 + by, 3)), true);
  }
  return solids.mesh();
}

// A box with a hole right through it. The loop of its upper and of its lower side goes to the hole
// and back, along a slit of the given width; 0: along one edge, twice.
Mesh keyhole(double slit) {
  std::vector<Point> points;
  for (const double z : {0.0, 1.0}) {
    const Point corners[] = {{0, 0, z}, {4, 0, z}, {4, 4, z}, {0, 4, z},
                             {1, 1, z}, {3, 1, z}, {3, 3, z}, {1, 3, z}};
    points.insert(points.end(), std::begin(corners), std::end(corners));
    if (slit > 0) {
      points.emplace_back(slit, 0, z);
      points.emplace_back(1 + slit, 1, z);
    }
  }
  Mesh mesh;
  mesh.points = PointSet(points);
  const auto upper = static_cast<std::uint32_t>(points.size() / 2);
  // Seen from above: around the outside, to the hole, around that the other way, and back.
  const std::vector<std::uint32_t> loop =
      slit > 0 ? std::vector<std::uint32_t>{8, 1, 2, 3, 0, 4, 7, 6, 5, 9}
               : std::vector<std::uint32_t>{0, 1, 2, 3, 0, 4, 7, 6, 5, 4};
  std::vector<std::uint32_t> top;
  for (const std::uint32_t c : loop) top.push_back(upper + c);
  mesh.polygons = {top, {loop.rbegin(), loop.rend()}};
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const std::uint32_t a = loop[k], b = loop[(k + 1) % loop.size()];
    const bool is_slit = slit == 0 && std::min(a, b) < 4 && std::max(a, b) >= 4;
    if (!is_slit) mesh.polygons.push_back({a, b, upper + b, upper + a});
  }
  return mesh;
}

// Boxes in one another: the surface winds twice about the inner one.
Mesh nested(double inner) {
  Solids solids;
  solids.add(box({0, 0, 0}, {4, 4, 1}));
  solids.add(box({0, 0, 0}, {1, 4, 4}));
  solids.add(box({0.25, 1, 0.25}, {0.25 + inner, 1 + inner, 0.25 + inner}));
  return solids.mesh();
}

}  // namespace

std::span<const PartsFamily> parts_families() {
  static const std::vector<PartsFamily> families = {
      {"walls",
       "an open bin, by the thickness of its walls",
       "thickness",
       {0.1, 1e-3, 1e-6, 1e-9, 1e-12},
       [](double wall) { return bin(wall); }},
      {"needles",
       "needles and slabs that are turned, by their width",
       "width",
       {1e-1, 1e-3, 1e-6, 1e-9, 1e-12},
       needles},
      {"far",
       "a bin far away from the origin, by its place",
       "offset",
       {0, 1e3, 1e6, 1e9, 1e12, 1e13, 1e15},
       [](double offset) { return bin(0.125, 1, offset); }},
      {"scales",
       "a bin, huge or tiny, by powers of two",
       "exponent",
       {-1000, -300, 0, 300, 1000},
       [](double exponent) { return bin(0.125, std::ldexp(1.0, static_cast<int>(exponent))); }},
      {"crossing",
       "hollow boxes that cross, by how far they are apart",
       "shift",
       {0, 1e-9, 0.5, 1.5, 3, 4},
       crossing_shells},
      {"keyholes",
       "a box with a hole, its sides loops through a slit, by the slit's width",
       "slit",
       {0, 1e-12, 1e-6, 1e-3, 0.5},
       keyhole},
      {"nested",
       "two slabs and a box in their corner, partly inside, by its size",
       "size",
       {1e-9, 0.5, 0.75, 1, 2},
       nested}};
  return families;
}

}  // namespace convexact
