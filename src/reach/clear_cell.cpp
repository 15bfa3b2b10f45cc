// SPDX-License-Identifier: MIT
#include "reach/clear_cell.hpp"

#include <algorithm>
#include <vector>

#include "number/arithmetic.hpp"

namespace convexact {
namespace {

// With more planes, asking all of them for each triangle costs more than smaller cells.
constexpr std::size_t kMostPlanes = 64;

// From y to the middle of the part, by a quarter of the cell's half width.
Point inner_point(const NearPart& part, const CellPlace& place, const Point& y) {
  const Point to_middle = part.middle() - y;
  const double far = to_middle.lpNorm<Eigen::Infinity>(), step = place.half / 4;
  return far <= step ? part.middle() : Point(y + to_middle * (step / far));
}

// Whether a triangle touches a cell at a wall at most, from outside. Walls may lie in faces, so
// where doubles leave it open the numbers are exact.
bool is_behind_wall(const ReachCells& cells, const CellPlace& place, std::uint32_t triangle) {
  const std::array<Point, 3> near = cells.triangles().corners(triangle);
  for (int axis = 0; axis < 3; ++axis) {
    for (const int side : {-1, 1}) {
      const auto may_be_behind = [&](const Point& v) {
        return side * (v[axis] - place.center[axis]) > place.half - kReachError;
      };
      if (!std::all_of(near.begin(), near.end(), may_be_behind)) continue;
      const Rational wall =
          cells.frame().point(place.center)[axis] + side * cells.frame().length(place.half);
      const auto& corners = cells.surface().triangles[triangle];
      if (std::all_of(corners.begin(), corners.end(), [&](PointId p) {
            const Rational x = cells.surface().points[p][axis];
            return side < 0 ? x <= wall : x >= wall;
          })) {
        return true;
      }
    }
  }
  return false;
}

// Whether a triangle may meet what the part has in the cell. It is cut at one plane of the part
// after another, and at the walls, each 2 kReachError farther out. A new corner is rounded by less
// than 2^-49, so after kMostCuts of them by less than kReachError / 2, and values are certain up to
// kReachError: no point of the triangle that is in the part is ever cut off.
bool may_run_through(const NearPart& part, const MetCell& met,
                     const std::array<Point, 3>& triangle) {
  constexpr int kMostCuts = 24;
  std::vector<Point> left(triangle.begin(), triangle.end()), kept;
  int cuts = 0;
  // Whether something is left on the inner side.
  const auto cut = [&](const auto& beyond) {
    kept.clear();
    for (std::size_t i = 0; i < left.size(); ++i) {
      const Point &a = left[i], &b = left[(i + 1) % left.size()];
      const double at_a = beyond(a) - 2 * kReachError, at_b = beyond(b) - 2 * kReachError;
      if (at_a <= 0) kept.push_back(a);
      if ((at_a <= 0) == (at_b <= 0)) continue;
      kept.push_back(a + at_a / (at_a - at_b) * (b - a));
      ++cuts;
    }
    left.swap(kept);
    return !left.empty();
  };
  for (const std::uint32_t k : met.planes) {
    if (!cut([&](const Point& y) { return part.beyond(k, y); })) return false;
    if (cuts > kMostCuts) return true;
  }
  for (int wall = 0; wall < 6 && cuts <= kMostCuts; ++wall) {
    const int axis = wall / 2, side = wall % 2 == 0 ? -1 : 1;
    const auto beyond = [&](const Point& y) {
      return side * (y[axis] - met.place.center[axis]) - met.place.half;
    };
    if (!cut(beyond)) return false;
  }
  return true;
}

// Whether each triangle that may meet what the part has in the cell is beyond one of its planes, or
// behind a wall, or passes both by. The planes of a NearSolid hold a little more than its vertices,
// so c need not be in their box.
bool has_no_triangle(const ReachCells& cells, const NearPart& part, const MetCell& met,
                     const Point& c) {
  NearBox box = part.box();
  box.include(c);
  box.low.array() -= kReachError;
  box.high.array() += kReachError;
  const Point wide = Point::Constant(met.place.half + kReachError);
  box.low = box.low.cwiseMax(met.place.center - wide);
  box.high = box.high.cwiseMin(met.place.center + wide);
  const auto is_beside = [&](std::uint32_t t, const std::array<Point, 3>& triangle) {
    return std::any_of(met.planes.begin(), met.planes.end(),
                       [&](std::uint32_t k) {
                         return std::all_of(triangle.begin(), triangle.end(), [&](const Point& v) {
                           return part.beyond(k, v) > 2 * kReachError;
                         });
                       }) ||
           is_behind_wall(cells, met.place, t) || !may_run_through(part, met, triangle);
  };
  // The nearest one is the likeliest to run through.
  const std::uint32_t nearest = cells.triangle(met.place.cell);
  const std::array<Point, 3> corners = cells.triangles().corners(nearest);
  NearBox around;
  for (const Point& v : corners) around.include(v);
  if (box.meets(around) && !is_beside(nearest, corners)) return false;
  return cells.triangles().all_meeting(box, is_beside);
}

}  // namespace

// With s = depth / r, r being how far all planes are from the middle m, each point x moves to
// x + s (m - x), and each plane by about `depth`; s is rounded up to a power of two. Labels of
// cells are about a distance that is smaller than T by kReachSlack, more than any point moves. What
// is so thin that s would be large stays as it is.
std::optional<InnerPart> inner_part(const ReachCells& cells, const NearPart& part) {
  constexpr double kDepth = 4 * kReachError;
  if (part.planes() == 0) return {};
  const Point middle = part.middle();
  double inside = 1, far = 0;
  for (std::uint32_t k = 0; k < part.planes(); ++k) {
    inside = std::min(inside, -part.beyond(k, middle));
  }
  for (const Point& v : part.vertices()) far = std::max(far, (v - middle).norm());
  if (!(inside > 2 * kDepth + kReachError)) return {};
  const double share = std::exp2(std::ceil(std::log2(kDepth / (inside - kReachError))));
  // At T = 0 volumes decide about what is cut off.
  const double most = cells.limit_down() * (cells.is_at_zero() ? 1 : kInnerSlack / 2);
  if (share * far > most) return {};
  return InnerPart{part.towards(middle, share), middle, share};
}

// What the planes of the part, its box with a point c and the cell have in common is convex, so if
// no triangle meets its interior, the surface winds about all of that as about c.
std::optional<ClearPoint> clear_point(const ReachCells& cells, const NearPart& part,
                                      const MetCell& met, const Point& y) {
  if (!cells.has_inside() || part.planes() == 0 || met.planes.size() > kMostPlanes) return {};
  const CellPlace& place = met.place;
  if (place.half < cells.limit_up()) return {};  // labels say so as quickly
  const Point c = inner_point(part, place, y);
  if ((c - place.center).lpNorm<Eigen::Infinity>() > place.half * 0.875) return {};
  if (!part.holds(met.planes, c) || !has_no_triangle(cells, part, met, c)) return {};
  return ClearPoint{c, cells.is_outside(c)};
}

}  // namespace convexact
