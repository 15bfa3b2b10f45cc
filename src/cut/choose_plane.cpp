// SPDX-License-Identifier: MIT
#include "cut/choose_plane.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "hull/near_solid.hpp"

namespace convexact {
namespace {

// Half of 26 directions.
constexpr std::array<std::array<int, 3>, 13> kDirections{{{1, 0, 0},
                                                          {0, 1, 0},
                                                          {0, 0, 1},
                                                          {1, 1, 0},
                                                          {1, -1, 0},
                                                          {1, 0, 1},
                                                          {1, 0, -1},
                                                          {0, 1, 1},
                                                          {0, 1, -1},
                                                          {1, 1, 1},
                                                          {1, 1, -1},
                                                          {1, -1, 1},
                                                          {1, -1, -1}}};

// Points that are extreme in these directions: their hull lies in that of all points.
std::vector<Point> extremes_of(const std::vector<Point>& points) {
  std::vector<std::size_t> found;
  for (const auto& [u, v, w] : kDirections) {
    std::size_t lowest = 0, highest = 0;
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const double x = u * points[k][0] + v * points[k][1] + w * points[k][2];
      if (x < low) std::tie(low, lowest) = std::tuple(x, k);
      if (x > high) std::tie(high, highest) = std::tuple(x, k);
    }
    found.push_back(lowest);
    found.push_back(highest);
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  std::vector<Point> extremes;
  for (const std::size_t k : found) extremes.push_back(points[k]);
  return extremes;
}

// Where a plane with these values at a and b cuts the segment between them.
Point between(const Point& a, double at_a, const Point& b, double at_b) {
  const double share = at_a / (at_a - at_b);
  // Signs are exact where values are not.
  return a + (share >= 0 && share <= 1 ? share : 0.5) * (b - a);
}

// A leaf as points and edges between them.
class LeafPoints {
 public:
  LeafPoints(const Leaf& leaf, const CutPoints& points) : leaf_(leaf), points_(points) {
    const Surface& surface = points.surface();
    ids_ = leaf.points(surface);
    for (const std::uint32_t id : ids_) near_.push_back(points.near(id));
    const auto add = [&](std::uint32_t a, std::uint32_t b) {
      if (a != b) edges_.emplace_back(std::min(a, b), std::max(a, b));
    };
    for (const Piece& piece : leaf.pieces) {
      const auto& corners = piece.corners;
      const auto& [a, b, c] = surface.triangles[piece.triangle];
      if (corners.empty()) {
        add(a.value, b.value);
        add(b.value, c.value);
        add(c.value, a.value);
      }
      for (std::size_t k = 0; k < corners.size(); ++k) {
        add(corners[k].point, corners[(k + 1) % corners.size()].point);
      }
    }
    std::sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
    for (auto& [a, b] : edges_) {
      a = index_of(a);
      b = index_of(b);
    }
    for (const std::uint32_t c : leaf.solid_corners) corners_.push_back(index_of(c));
  }

  // The points on both sides of a plane, without new corners of the region. What lies in the plane
  // goes where an edge leads to.
  using Halves = std::array<std::vector<Point>, 2>;
  Halves halves(const CutPlane& plane) const {
    std::vector<Sign> sides(ids_.size());
    std::vector<unsigned char> goes(ids_.size(), 0);  // 1: below, 2: above
    for (std::size_t k = 0; k < ids_.size(); ++k) {
      sides[k] = points_.side(plane, ids_[k]);
      if (sides[k] != Sign::Zero) goes[k] = sides[k] == Sign::Negative ? 1 : 2;
    }
    Halves halves;
    for (const auto& [a, b] : edges_) {
      if (sides[a] == Sign::Zero) {
        goes[a] |= goes_with(sides[b]);
      } else if (sides[b] == Sign::Zero) {
        goes[b] |= goes_with(sides[a]);
      } else if (sides[a] != sides[b]) {
        const Point y = between(near_[a], plane(near_[a]), near_[b], plane(near_[b]));
        halves[0].push_back(y);
        halves[1].push_back(y);
      }
    }
    for (const std::uint32_t k : corners_) {
      if (sides[k] == Sign::Zero) goes[k] = 3;
    }
    for (std::size_t k = 0; k < ids_.size(); ++k) {
      if (goes[k] & 1) halves[0].push_back(near_[k]);
      if (goes[k] & 2) halves[1].push_back(near_[k]);
    }
    return halves;
  }

  // New corners of the region, where the plane cuts its sides inside of the solid.
  std::vector<Point> new_corners(const CutPlane& plane, const Winding* winding) const {
    std::vector<Point> list;
    if (winding == nullptr) return list;
    Point middle = Point::Zero();
    const std::vector<std::uint32_t> all = leaf_.region.corners();
    for (const std::uint32_t c : all) middle += points_.near(c) / static_cast<double>(all.size());
    for (const Region::Face& face : leaf_.region.faces()) {
      for (std::size_t k = 0; k < face.corners.size(); ++k) {
        const std::uint32_t a = face.corners[k], b = face.corners[(k + 1) % face.corners.size()];
        const double at_a = plane(points_.near(a)), at_b = plane(points_.near(b));
        if (!(a < b) || !(at_a * at_b < 0)) continue;
        const Point y = between(points_.near(a), at_a, points_.near(b), at_b);
        const Point inward = middle - y;
        if (inward.isZero(0)) continue;
        const RationalVector3 direction(to_rational(inward[0]), to_rational(inward[1]),
                                        to_rational(inward[2]));
        if (winding->towards(points_.frame().point(y), direction) != 0) list.push_back(y);
      }
    }
    return list;
  }

  double volume() const { return near_solid(near_).volume; }

 private:
  static unsigned char goes_with(Sign side) {
    return side == Sign::Negative ? 1 : side == Sign::Positive ? 2 : 0;
  }
  std::uint32_t index_of(std::uint32_t id) const {
    return static_cast<std::uint32_t>(std::lower_bound(ids_.begin(), ids_.end(), id) -
                                      ids_.begin());
  }

  const Leaf& leaf_;
  const CutPoints& points_;
  std::vector<std::uint32_t> ids_;
  std::vector<Point> near_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges_;
  std::vector<std::uint32_t> corners_;
};

bool may_hold(const NearSolid& solid, const Point& far) {
  constexpr double kNear = 0x1p-40;
  if (solid.planes.empty()) return false;
  return std::all_of(solid.planes.begin(), solid.planes.end(), [&](const NearSolid::Plane& plane) {
    return plane.normal.dot(far) + plane.offset <= kNear;
  });
}

double box_size(const std::vector<Point>& points) {
  Point low = points.front(), high = low;
  for (const Point& y : points) {
    low = low.cwiseMin(y);
    high = high.cwiseMax(y);
  }
  return (high - low).norm();
}

}  // namespace

std::optional<std::size_t> choose_plane(const Leaf& leaf, const Point& far,
                                        std::span<const CutPlane> planes, const CutPoints& points,
                                        const Winding* winding, const Watch& watch) {
  const LeafPoints own(leaf, points);
  struct Trial {
    std::size_t plane;
    double least;
  };
  std::vector<Trial> trials;
  for (std::size_t k = 0; k < planes.size(); ++k) {
    watch.ask();
    Trial trial{k, 0};
    const LeafPoints::Halves halves = own.halves(planes[k]);
    if (halves[0].empty() || halves[1].empty()) continue;
    for (const auto& half : halves) trial.least += near_solid(extremes_of(half)).volume;
    trials.push_back(trial);
  }
  std::stable_sort(trials.begin(), trials.end(),
                   [](const Trial& a, const Trial& b) { return a.least < b.least; });
  // Volumes are compared in units of which a billion make the leaf's: those that are equal but for
  // rounding are equal.
  const double whole = own.volume(), unit = whole * 0x1p-30;
  using Score = std::tuple<int, double, double, std::size_t>;
  std::optional<Score> best;
  for (const Trial& trial : trials) {
    watch.ask();
    if (best && std::get<0>(*best) == 0 && trial.least > (std::get<1>(*best) + 1) * unit) break;
    const std::vector<Point> more = own.new_corners(planes[trial.plane], winding);
    int held = 0;
    double volume = 0, size = 0;
    for (auto& half : own.halves(planes[trial.plane])) {
      half.insert(half.end(), more.begin(), more.end());
      const NearSolid solid = near_solid(half);
      held += may_hold(solid, far) ? 1 : 0;
      volume += solid.volume;
      size += box_size(half);
    }
    // What is flat has no volume: then smaller is better.
    const Score score{held, whole > 0 ? std::round(volume / unit) : 0, whole > 0 ? 0 : size,
                      trial.plane};
    if (!best || score < *best) best = score;
  }
  if (!best) return {};
  return std::get<3>(*best);
}

}  // namespace convexact
