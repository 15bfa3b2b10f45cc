// SPDX-License-Identifier: MIT
#include "overlay/union_distance_near.hpp"

#include <algorithm>
#include <cmath>

#include "number/arithmetic.hpp"

namespace convexact {

// ---- Hulls of a few points

namespace {

// The vertices, less y, whose combination with positive factors is the nearest point so far.
struct NearSimplex {
  std::array<Point, 4> w;
  int size = 0;
  Point nearest = Point::Zero();
  double squared = std::numeric_limits<double>::infinity();

  void offer(const NearSimplex& other) {
    if (other.squared < squared) *this = other;
  }
};

NearSimplex nearest_at(const Point& a) { return {{a}, 1, a, a.squaredNorm()}; }

NearSimplex nearest_on_segment(const Point& a, const Point& b) {
  const Point along = b - a;
  const double t = -a.dot(along), length = along.squaredNorm();
  if (!(t > 0)) return nearest_at(a);
  if (t >= length) return nearest_at(b);
  const double factor = t / length;
  const Point q = (1 - factor) * a + factor * b;
  return {{a, b}, 2, q, q.squaredNorm()};
}

// Sides first, because they are right whatever the shape is; the inside by the ratios of areas
// only if all of them are positive. [Ericson2005, sec. 5.1.5]
NearSimplex nearest_on_triangle(const Point& a, const Point& b, const Point& c) {
  NearSimplex best = nearest_on_segment(a, b);
  best.offer(nearest_on_segment(b, c));
  best.offer(nearest_on_segment(a, c));
  const Point ab = b - a, ac = c - a;
  const double d1 = -ab.dot(a), d2 = -ac.dot(a), d3 = -ab.dot(b), d4 = -ac.dot(b);
  const double d5 = -ab.dot(c), d6 = -ac.dot(c);
  const double u = d3 * d6 - d5 * d4, v = d5 * d2 - d1 * d6, w = d1 * d4 - d3 * d2;
  const double sum = u + v + w;
  if (u > 0 && v > 0 && w > 0 && std::isnormal(sum)) {
    const Point q = (u / sum) * a + (v / sum) * b + (w / sum) * c;
    best.offer({{a, b, c}, 3, q, q.squaredNorm()});
  }
  return best;
}

NearSimplex nearest_in_tetrahedron(const std::array<Point, 4>& w) {
  // Volumes of the tetrahedra of the origin and a face, in the direction of the whole.
  std::array<double, 4> part{w[1].dot(w[2].cross(w[3])), -w[0].dot(w[2].cross(w[3])),
                             w[0].dot(w[1].cross(w[3])), -w[0].dot(w[1].cross(w[2]))};
  const double sum = part[0] + part[1] + part[2] + part[3];
  NearSimplex best;
  bool is_inside = std::isnormal(sum);
  for (int k = 0; k < 4; ++k) {
    if (is_inside && part[k] / sum > 0) continue;
    is_inside = false;
  }
  if (is_inside) {
    Point q = Point::Zero();
    for (int k = 0; k < 4; ++k) q += (part[k] / sum) * w[k];
    best.offer({w, 4, q, q.squaredNorm()});
  }
  best.offer(nearest_on_triangle(w[0], w[1], w[2]));
  best.offer(nearest_on_triangle(w[0], w[1], w[3]));
  best.offer(nearest_on_triangle(w[0], w[2], w[3]));
  best.offer(nearest_on_triangle(w[1], w[2], w[3]));
  return best;
}

NearSimplex nearest_in(const NearSimplex& simplex, const Point& added) {
  const std::array<Point, 4>& w = simplex.w;
  if (simplex.size == 1) return nearest_on_segment(w[0], added);
  if (simplex.size == 2) return nearest_on_triangle(w[0], w[1], added);
  return nearest_in_tetrahedron({w[0], w[1], w[2], added});
}

// Below it squares may underflow, or are a rounding error.
constexpr double kLeastSquare = 0x1p-200;

// Takes the point of a range where q.(x - y) is least, and that value, if it is below the one
// found.
void take_least(std::span<const Point> points, std::size_t first, std::size_t last, const Point& q,
                const Point& y, std::pair<std::size_t, double>& found) {
  for (std::size_t i = first; i < last; ++i) {
    const double value = q.dot(points[i] - y);
    if (value < found.second) found = {i, value};
  }
}

constexpr std::pair<std::size_t, double> kNoneFound{0, std::numeric_limits<double>::infinity()};

// @param least_along  Takes q, and returns the point where q.(x - y) is least, and that value.
template <class LeastAlong>
NearHull hull_seen_from(std::span<const Point> points, const Point& y, double enough,
                        const LeastAlong& least_along) {
  NearSimplex simplex = nearest_at(points.front() - y);
  double low = 0;
  Point towards = Point::Zero();
  for (int step = 0; step < 64; ++step) {
    if (!(simplex.squared > kLeastSquare) || simplex.size == 4) break;
    if (low > enough || simplex.squared <= enough * enough) break;
    const Point& q = simplex.nearest;
    const auto [beyond, least] = least_along(q);
    if (const double bound = least / std::sqrt(simplex.squared); bound > low) {
      low = bound;
      towards = q;
    }
    if (least >= simplex.squared * (1 - 0x1p-48)) break;
    const NearSimplex next = nearest_in(simplex, points[beyond] - y);
    if (!(next.squared < simplex.squared)) break;
    simplex = next;
  }
  return {{low, std::sqrt(std::max(simplex.squared, kLeastSquare))}, simplex.nearest, towards};
}

constexpr std::size_t kBlock = 32;      // points of a box
constexpr std::size_t kFewPoints = 96;  // of which a look at each is quicker

}  // namespace

HullPoints::HullPoints(std::vector<Point> points) : points_(std::move(points)) {
  if (points_.size() < kFewPoints) return;
  boxes_.resize((points_.size() + kBlock - 1) / kBlock);
  for (std::size_t i = 0; i < points_.size(); ++i) boxes_[i / kBlock].include(points_[i]);
}

// Rounding is monotone: at the corner of a box where q.x is least the value is at most that of any
// point in it. So what boxes leave out is not least, not even by rounding.
std::pair<std::size_t, double> HullPoints::least_along(const Point& q, const Point& y) const {
  std::pair<std::size_t, double> found = kNoneFound;
  if (boxes_.empty()) {
    take_least(points_, 0, points_.size(), q, y, found);
    return found;
  }
  const auto least_of_box = [&](const NearBox& box) {
    Point corner;
    for (int k = 0; k < 3; ++k) corner[k] = q[k] > 0 ? box.low[k] : box.high[k];
    return q.dot(corner - y);
  };
  const auto take_box = [&](std::size_t b, std::pair<std::size_t, double>& best) {
    take_least(points_, b * kBlock, std::min(points_.size(), (b + 1) * kBlock), q, y, best);
  };
  std::size_t lowest = 0;
  double lowest_value = std::numeric_limits<double>::infinity();
  for (std::size_t b = 0; b < boxes_.size(); ++b) {
    const double value = least_of_box(boxes_[b]);
    if (value < lowest_value) {
      lowest_value = value;
      lowest = b;
    }
  }
  std::pair<std::size_t, double> there = kNoneFound;
  take_box(lowest, there);
  for (std::size_t b = 0; b < boxes_.size(); ++b) {
    if (!(least_of_box(boxes_[b]) > there.second)) take_box(b, found);
  }
  return found;
}

NearHull near_hull(std::span<const Point> points, const Point& y, double enough) {
  return hull_seen_from(points, y, enough, [&](const Point& q) {
    std::pair<std::size_t, double> found = kNoneFound;
    take_least(points, 0, points.size(), q, y, found);
    return found;
  });
}

NearHull near_hull(const HullPoints& points, const Point& y, double enough) {
  return hull_seen_from(points.points(), y, enough,
                        [&](const Point& q) { return points.least_along(q, y); });
}

NearHull near_triangle(const std::array<Point, 3>& corners, const Point& y) {
  const std::array<Point, 3> w{corners[0] - y, corners[1] - y, corners[2] - y};
  const NearSimplex simplex = nearest_on_triangle(w[0], w[1], w[2]);
  const Point& q = simplex.nearest;
  double low = 0;
  if (simplex.squared > kLeastSquare) {
    low = std::min({q.dot(w[0]), q.dot(w[1]), q.dot(w[2])}) / std::sqrt(simplex.squared);
  }
  return {{std::max(0.0, low), std::sqrt(std::max(simplex.squared, kLeastSquare))}, q, q};
}

NearBounds widened(const NearBounds& bounds, const Point& y) {
  const double size = y.lpNorm<Eigen::Infinity>();
  if (!(size < 0x1p200)) return {};
  const double error = kDistanceError * std::max(1.0, size);
  return {std::max(0.0, bounds.low - error), bounds.high + error};
}

// ---- Parts

NearParts::NearParts(std::span<const ConvexPart> parts, const NearFrame& frame) : frame_(frame) {
  for (const ConvexPart& part : parts) {
    NearBox box;
    for (const RationalPoint& v : part.vertices) {
      vertices_.push_back(frame(v));
      box.include(vertices_.back());
    }
    starts_.push_back(vertices_.size());
    boxes_.push_back(box);
  }
}

std::span<const Point> NearParts::vertices(std::size_t part) const {
  return std::span(vertices_).subspan(starts_[part], starts_[part + 1] - starts_[part]);
}

double NearParts::box_distance(std::size_t part, const Point& y) const {
  return widened({boxes_[part].distance(y), 0}, y).low;
}

NearBounds NearParts::to_part(std::size_t part, const Point& y) const {
  return widened(near_hull(vertices(part), y).bounds, y);
}

NearBounds NearParts::to_union(const Point& y) const {
  std::size_t first = 0;
  for (std::size_t p = 1; p < size(); ++p) {
    if (box_distance(p, y) < box_distance(first, y)) first = p;
  }
  NearBounds all = to_part(first, y);
  for (std::size_t p = 0; p < size(); ++p) {
    if (p == first || box_distance(p, y) > all.high) continue;
    const NearBounds bounds = to_part(p, y);
    all = {std::min(all.low, bounds.low), std::min(all.high, bounds.high)};
  }
  return all;
}

std::vector<std::uint32_t> NearParts::candidates(const Point& y) const {
  const double high = to_union(y).high;
  std::vector<std::uint32_t> list;
  for (std::uint32_t p = 0; p < size(); ++p) {
    if (!(box_distance(p, y) > high) && !(to_part(p, y).low > high)) list.push_back(p);
  }
  return list;
}

// A part that is more than high + 2 radius from y is more than high + radius from the point, which
// is no farther than that from the part nearest to y.
std::vector<std::uint32_t> NearParts::candidates(const Point& y, double radius) const {
  const double reach = to_union(y).high + 2.125 * radius;
  std::vector<std::uint32_t> list;
  for (std::uint32_t p = 0; p < size(); ++p) {
    if (!(box_distance(p, y) > reach)) list.push_back(p);
  }
  return list;
}

}  // namespace convexact
