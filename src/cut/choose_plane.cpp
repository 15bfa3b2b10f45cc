// SPDX-License-Identifier: MIT
#include "cut/choose_plane.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <set>
#include <tuple>

#include "hull/near_solid.hpp"
#include "surface/box_tree.hpp"
#include "task/parallel.hpp"

namespace convexact {
namespace {

NearBox box_of(const std::vector<Point>& points) {
  NearBox box;
  for (const Point& y : points) box.include(y);
  return box;
}

double size_of(const std::vector<Point>& points) {
  const NearBox box = box_of(points);
  return (box.high - box.low).norm();
}

// The cell that a vector points to, of a cube whose sides have n x n cells.
std::size_t cell_towards(const Point& to, std::size_t n) {
  int axis = 0;
  const double per_most = 1 / to.cwiseAbs().maxCoeff(&axis);
  std::size_t cell = 2 * static_cast<std::size_t>(axis) + (to[axis] > 0 ? 1 : 0);
  for (const int other : {(axis + 1) % 3, (axis + 2) % 3}) {
    const double share = (to[other] * per_most + 1) / 2;
    cell = cell * n + std::min(static_cast<std::size_t>(share * static_cast<double>(n)), n - 1);
  }
  return cell;
}

// In each such cell, seen from the middle of the points' box, the farthest point; the box counts as
// a cube. Their hull lies in that of all points.
std::vector<Point> farthest_of(const std::vector<Point>& points, std::size_t n) {
  const NearBox box = box_of(points);
  const Point middle = (box.low + box.high) / 2;
  // What is thinner than this is flat here; its inverse, times any extent, stays finite.
  constexpr double kThinnest = 0x1p-500;
  const Point to_unit =
      (box.high - box.low).unaryExpr([](double x) { return x > kThinnest ? 1 / x : 0.0; });
  constexpr std::size_t kNone = ~std::size_t{0};
  std::vector<std::pair<double, std::size_t>> farthest(6 * n * n, {0, kNone});
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Point to = (points[k] - middle).cwiseProduct(to_unit);
    const double distance = to.squaredNorm();
    if (!(distance > 0)) continue;
    auto& cell = farthest[cell_towards(to, n)];
    if (distance > cell.first) cell = {distance, k};
  }
  std::vector<Point> found;
  for (const auto& [distance, point] : farthest) {
    if (point != kNone) found.push_back(points[point]);
  }
  return found;
}

// On a grid that is far coarser than doubles. Points that lie in a cutting plane but for their last
// bits would make a hull ask for many signs in exact numbers, and a preference needs no last bits.
Point rounded(const Point& y) {
  constexpr double kGrid = 0x1p36;
  return (y * kGrid).array().round().matrix() / kGrid;
}

// Where a plane with these values at a and b cuts the segment between them.
Point between(const Point& a, double at_a, const Point& b, double at_b) {
  const double share = at_a / (at_a - at_b);
  // Signs are exact where values are not.
  return rounded(a + (share >= 0 && share <= 1 ? share : 0.5) * (b - a));
}

// A leaf as points and edges between them.
class LeafPoints {
 public:
  LeafPoints(const Leaf& leaf, const CutPoints& points) : leaf_(leaf), points_(points) {
    const Surface& surface = points.surface();
    ids_ = leaf.points(surface);
    for (const std::uint32_t id : ids_) near_.push_back(rounded(points.near(id)));
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

  // The points on both sides of a plane, without new corners of the region; none if all are on one
  // side. What lies in the plane goes where an edge leads to.
  using Halves = std::array<std::vector<Point>, 2>;
  Halves halves(const CutPlane& plane) const {
    std::vector<Sign> sides(ids_.size());
    std::vector<unsigned char> goes(ids_.size(), 0);  // 1: below, 2: above
    unsigned char reached = 0;
    for (std::size_t k = 0; k < ids_.size(); ++k) {
      sides[k] = points_.side(plane, ids_[k]);
      goes[k] = goes_with(sides[k]);
      reached |= goes[k];
    }
    Halves halves;
    if (reached != 3) return halves;
    for (std::vector<Point>& half : halves) half.reserve(ids_.size());
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

  const std::vector<Point>& near() const { return near_; }

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

// Values of planes at points are off by less.
constexpr double kNear = 0x1p-40;

bool is_within(const NearSolid& solid, const Point& y, double beyond = kNear) {
  return !solid.planes.empty() &&
         std::all_of(solid.planes.begin(), solid.planes.end(), [&](const NearSolid::Plane& plane) {
           return plane.normal.dot(y) + plane.offset <= beyond;
         });
}

// What a plane is judged by: how many hulls hold the farthest point, and their volumes together.
struct Judged {
  int held = 0;
  double volume = 0;

  friend auto operator<=>(const Judged&, const Judged&) = default;
};

// The hull of points that hold those of a hull: most of them lie in it.
NearSolid hull_around(const NearSolid& inner, const std::vector<Point>& points) {
  std::vector<Point> outer = inner.vertices;
  for (const Point& y : points) {
    if (!is_within(inner, y, -kNear)) outer.push_back(y);
  }
  return near_solid(outer);
}

// Planes that are judged by few points at first, and by more where these do not rule them out.
class PlaneChoice {
 public:
  PlaneChoice(const Leaf& leaf, const Point& far, std::span<const CutPlane> planes,
              const CutPoints& points, const Winding* winding, std::size_t jobs)
      : own_(leaf, points),
        far_(far),
        planes_(planes),
        winding_(winding),
        jobs_(own_.near().size() < kFewForThreads ? 1 : jobs) {
    // Volumes are compared in units of which a billion make the leaf's: those that are equal but
    // for rounding are equal.
    whole_ = hull_around(near_solid(farthest_of(own_.near(), kFew)), own_.near()).volume;
  }

  // With several threads some planes are judged further that the best one would have ruled out; it
  // is the same one.
  std::optional<std::size_t> best(const Watch& watch) {
    std::vector<Candidate> open(planes_.size());
    for (std::uint32_t k = 0; k < planes_.size(); ++k) open[k].plane = k;
    judge(open, watch);
    while (!queue_.empty()) {
      if (queue_.begin()->level == kLevels) return queue_.begin()->plane;
      open.clear();
      while (open.size() < jobs_ && !queue_.empty() && queue_.begin()->level < kLevels) {
        open.push_back(std::move(queue_.extract(queue_.begin()).value()));
      }
      judge(open, watch);
    }
    return {};
  }

 private:
  // Hulls of a few hundred points, of some more, of all.
  static constexpr int kLevels = 2;
  static constexpr std::size_t kFew = 6, kMany = 18;
  // Below that many points a thread takes longer to start than to judge.
  static constexpr std::size_t kFewForThreads = 1000;

  struct Candidate {
    Judged judged;
    double size = 0;
    std::uint32_t plane = 0;
    int level = -1;                  // by which it was judged
    std::array<NearSolid, 2> hulls;  // of few points, once they are known

    friend bool operator<(const Candidate& a, const Candidate& b) {
      return std::tie(a.judged, a.size, a.plane, a.level) <
             std::tie(b.judged, b.size, b.plane, b.level);
    }
  };

  // Lies in the hull of the points, which the last level has.
  // @param inner  Of few of the points, once that is known.
  NearSolid hull_at(int level, const std::vector<Point>& points, const NearSolid& inner) const {
    switch (level) {
      case 0:
        return near_solid(farthest_of(points, kFew));
      case 1:
        return near_solid(farthest_of(points, kMany));
      default:
        return hull_around(inner, points);
    }
  }

  // Judges planes by the next level. One that has all points on one side is none.
  void judge(std::vector<Candidate>& open, const Watch& watch) {
    std::vector<unsigned char> cuts(open.size(), 0);
    for_each_in_parallel(open.size(), jobs_, [&](std::size_t i) {
      watch.ask();
      cuts[i] = judge(open[i]) ? 1 : 0;
    });
    for (std::size_t i = 0; i < open.size(); ++i) {
      if (cuts[i] != 0) queue_.insert(std::move(open[i]));
    }
  }

  bool judge(Candidate& made) const {
    LeafPoints::Halves halves = own_.halves(planes_[made.plane]);
    if (halves[0].empty() || halves[1].empty()) return false;
    ++made.level;
    made.judged = {};
    made.size = 0;
    std::vector<Point> more;
    if (made.level == kLevels) more = own_.new_corners(planes_[made.plane], winding_);
    for (std::size_t k = 0; k < 2; ++k) {
      std::vector<Point>& half = halves[k];
      half.insert(half.end(), more.begin(), more.end());
      NearSolid hull = hull_at(made.level, half, made.hulls[k]);
      made.judged.held += is_within(hull, far_) ? 1 : 0;
      made.judged.volume += hull.volume;
      if (made.level == 0) made.hulls[k] = std::move(hull);
      // What is flat has no volume: then smaller is better.
      if (!(whole_ > 0)) made.size += size_of(half);
    }
    // A bound is rounded down, so that it does not come after what it bounds.
    const double units = whole_ > 0 ? made.judged.volume / whole_ * 0x1p30 : 0;
    made.judged.volume = made.level == kLevels ? std::round(units) : std::floor(units - 1);
    return true;
  }

  const LeafPoints own_;
  const Point& far_;
  std::span<const CutPlane> planes_;
  const Winding* winding_;
  const std::size_t jobs_;
  double whole_ = 0;
  std::set<Candidate> queue_;
};

}  // namespace

std::optional<std::size_t> choose_plane(const Leaf& leaf, const Point& far,
                                        std::span<const CutPlane> planes, const CutPoints& points,
                                        const Winding* winding, std::size_t jobs,
                                        const Watch& watch) {
  return PlaneChoice(leaf, far, planes, points, winding, jobs).best(watch);
}

}  // namespace convexact
