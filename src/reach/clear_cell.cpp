// SPDX-License-Identifier: MIT
#include "reach/clear_cell.hpp"

#include <algorithm>

namespace convexact {
namespace {

// With more planes, asking all of them for each triangle costs more than smaller cells.
constexpr std::size_t kMostPlanes = 64;
// Triangles may lie in the walls of a cell, and reach in so far: a wall may be in a face.
constexpr double kInset = 2 * kReachError;

// From y to the middle of the part, by a quarter of the cell's half width.
Point inner_point(const NearPart& part, const CellPlace& place, const Point& y) {
  const Point to_middle = part.middle() - y;
  const double far = to_middle.lpNorm<Eigen::Infinity>(), step = place.half / 4;
  return far <= step ? part.middle() : Point(y + to_middle * (step / far));
}

// Whether each triangle that may meet what the part has in the cell is beyond one of its planes.
// The planes of a NearSolid hold a little more than its vertices, so c need not be in their box.
bool has_no_triangle(const ReachCells& cells, const NearPart& part, const MetCell& met,
                     const Point& c) {
  NearBox box = part.box();
  box.include(c);
  box.low.array() -= kReachError;
  box.high.array() += kReachError;
  const Point wide = Point::Constant(met.place.half - kInset);
  box.low = box.low.cwiseMax(met.place.center - wide);
  box.high = box.high.cwiseMin(met.place.center + wide);
  const auto is_beyond = [&](const std::array<Point, 3>& triangle) {
    return std::any_of(met.planes.begin(), met.planes.end(), [&](std::uint32_t k) {
      return std::all_of(triangle.begin(), triangle.end(),
                         [&](const Point& v) { return part.beyond(k, v) > 2 * kReachError; });
    });
  };
  // The nearest one is the likeliest to run through.
  const std::array<Point, 3> nearest = cells.triangles().corners(cells.triangle(met.place.cell));
  NearBox around;
  for (const Point& v : nearest) around.include(v);
  if (box.meets(around) && !is_beyond(nearest)) return false;
  return cells.triangles().all_meeting(box, is_beyond);
}

}  // namespace

// With s = depth / r, r being how far all planes are from the middle m, each point x moves to
// x + s (m - x), and each plane by about `depth`. Labels of cells are about a distance that is
// smaller than T by kReachSlack, more than any point moves. What is so thin that s would be large
// stays as it is.
std::optional<NearPart> inner_part(const ReachCells& cells, const NearPart& part) {
  constexpr double kDepth = 4 * kReachError;
  if (part.planes() == 0) return {};
  const Point middle = part.middle();
  double inside = 1, far = 0;
  for (std::uint32_t k = 0; k < part.planes(); ++k) {
    inside = std::min(inside, -part.beyond(k, middle));
  }
  for (const Point& v : part.vertices()) far = std::max(far, (v - middle).norm());
  if (!(inside > 2 * kDepth + kReachError)) return {};
  const double share = kDepth / (inside - kReachError);
  if (share * far > cells.limit_down() * (kReachSlack / 2)) return {};
  return part.towards(middle, share);
}

// What the planes of the part, its box with a point c and a cell that is smaller by kInset have in
// common is convex, so if no triangle meets it, the surface winds about all of it as about c. The
// rest is near it: if c is at least h / 8 from the walls of the cell of half width h, a point x
// there moves into the smaller cell with x + s (c - x), s = 8 kInset / h, by less than 2^5 kInset.
bool is_clear_inside(const ReachCells& cells, const NearPart& part, const MetCell& met,
                     const Point& y) {
  if (!cells.has_inside() || part.planes() == 0 || met.planes.size() > kMostPlanes) return false;
  const CellPlace& place = met.place;
  if (place.half < cells.limit_up()) return false;  // labels say so as quickly
  const Point c = inner_point(part, place, y);
  return (c - place.center).lpNorm<Eigen::Infinity>() <= place.half * 0.875 &&
         32 * kInset <= cells.limit_down() * (kReachSlack / 2) && part.holds(met.planes, c) &&
         has_no_triangle(cells, part, met, c) && !cells.is_outside(c);
}

}  // namespace convexact
