// SPDX-License-Identifier: MIT
// reach_limit.cpp - whether a part lies within T of a solid: down the cells that it meets, those
// farthest from the surface first.
#include <algorithm>

#include "convexact/reach.hpp"
#include "reach/clipped_part.hpp"
#include "reach/met_cell.hpp"
#include "reach/reach_search.hpp"
#include "surface/flat_polygon.hpp"

namespace convexact {
namespace {

// A part with few planes at a cell of this share of T is decided in exact numbers at once: that is
// quicker than many small cells along a facet that lies just within T.
constexpr double kClipFrom = 1.0 / 8, kClipTo = 1.0 / 4;
constexpr std::size_t kClipPlanes = 24;
// What a part and a cell have in common is cut at the walls of so many triangles, one after
// another.
constexpr std::size_t kMostWalls = 3;

// The way down the cells for one part.
class PartWalk {
 public:
  PartWalk(ReachCells& cells, const ConvexPart& part, const Rational& squared_limit, bool may_clip,
           const Watch& watch)
      : cells_(cells),
        part_(part),
        near_(part, cells.frame()),
        squared_limit_(squared_limit),
        may_clip_(may_clip),
        watch_(watch) {
    for (const Point& y : near_.vertices()) {
      if (!(y.lpNorm<Eigen::Infinity>() < 2 - kReachError)) {
        throw Error(ErrorCode::InvalidArgument, "a part lies beyond the boxes of a reach limit");
      }
    }
  }

  // Whether all cells that the part meets are fine.
  bool is_within() {
    MetCell root{cells_.root(), {}};
    for (std::uint32_t k = 0; k < near_.planes(); ++k) root.planes.push_back(k);
    if (cells_.label(root.place) != ReachCells::Label::Open) return true;
    visit(root);
    return !is_beyond_ && !is_open_;
  }

  PartReach answer() {
    const bool is_within_limit = is_within();
    if (is_within_limit) return {};
    if (is_beyond_) return {Reach::Beyond, std::move(farthest_), {}};
    PartReach result{Reach::Undecided, {}, {}};
    if (most_found_ > 0) consider(point_of_part(found_at_), result.witness);
    const Rational high = cells_.frame().length(open_high_);
    result.bracket = SquaredBracket{
        result.witness ? std::min(result.witness->squared, squared_limit_) : Rational(0),
        high * high};
    return result;
  }

 private:
  // Whether the search goes on: a part that is refuted ends it, and one that is open if nothing can
  // be clipped.
  bool goes_on() const { return !is_beyond_ && (!is_open_ || may_clip_); }

  // The cell is not fine.
  void visit(const MetCell& met) {
    watch_.ask();
    const CellPlace& place = met.place;
    const bool holds_center =
        std::all_of(met.planes.begin(), met.planes.end(),
                    [&](std::uint32_t k) { return near_.is_within(k, place.center); });
    if (holds_center) {
      refute(place, place.center, cells_.distance(place.cell));
    } else {
      const NearHull hull = near_hull(near_.vertices(), place.center);
      if (widened(hull.bounds, place.center).low > place.radius()) return;
      const Point y = place.center + hull.nearest;
      if (cells_.distance(place.cell).high + hull.bounds.high > cells_.limit_up()) {
        refute(place, y, cells_.triangles().nearest(y, cells_.triangle(place.cell)).distance);
      }
    }
    if (is_beyond_) return;
    const double share = place.half / cells_.limit_up();
    const bool is_least = place.half <= cells_.least_half() || is_full(place);
    if (may_clip_ && (is_least || (share > kClipFrom && share <= kClipTo)) &&
        met.planes.size() <= kClipPlanes && clip(place, is_least)) {
      return;
    }
    if (is_least) {
      is_open_ = true;
      open_high_ = std::max(open_high_, cells_.distance(place.cell).high + place.radius());
      return;
    }
    visit_children(met);
  }

  bool is_full(const CellPlace& place) const {
    return cells_.is_full() && !cells_.has_children(place.cell);
  }

  void visit_children(const MetCell& met) {
    std::vector<std::pair<double, MetCell>> open;
    MetCell half;
    for (const CellPlace& at : cells_.children(met.place)) {
      if (!met.may_meet(near_, at, half)) continue;
      if (cells_.label(at) != ReachCells::Label::Open) continue;
      open.emplace_back(cells_.distance(at.cell).low, half);
    }
    std::stable_sort(open.begin(), open.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    for (const auto& [distance, next] : open) {
      if (!goes_on()) return;
      visit(next);
    }
  }

  // A point y of the part, up to rounding, that is about in the cell.
  void refute(const CellPlace& place, const Point& y, const NearBounds& distance) {
    if (distance.low <= std::min(most_found_, cells_.limit_up() + kReachError)) return;
    const bool is_center = y == place.center;
    if (!(is_center ? cells_.is_outside(place) : cells_.is_outside(y))) return;
    if (distance.low > most_found_) {
      most_found_ = distance.low;
      found_at_ = place;
    }
    // Rounding moved y by less than kReachError, so it did not take it through the surface.
    if (distance.low <= cells_.limit_up() + kReachError) return;
    is_beyond_ = !may_clip_ || consider(point_of_part(place), farthest_);
  }

  // The point of the part that is nearest to the center of a cell.
  RationalPoint point_of_part(const CellPlace& place) const {
    const RationalPoint center = cells_.frame().point(place.center);
    if (holds(part_, center)) return center;
    return UnionDistance(std::span(&part_, 1)).nearest_in(0, center);
  }

  // Whether a point of the part is outside of the solid and farther than T, exactly. It becomes the
  // witness if it is outside.
  bool consider(const RationalPoint& x, std::optional<FarthestPoint>& witness) const {
    FarthestPoint found = nearest_on_surface(cells_, x);
    if (found.squared == 0 || !cells_.is_outside(x)) return false;
    const bool is_farther = found.squared > squared_limit_;
    witness = std::move(found);
    return is_farther;
  }

  // Whether what the part and the cell have in common decides: all of it is within T of triangles,
  // or a corner of it is a witness.
  bool clip(const CellPlace& place, bool is_least) {
    const std::vector<RationalPoint> corners = common_corners(part_, place, cells_.frame());
    if (corners.empty() || are_near(corners, cells_.triangle(place.cell))) return true;
    for (const RationalPoint& x : corners) {
      if (near_surface(x).distance.low <= cells_.limit_up() || !consider(x, farthest_)) continue;
      is_beyond_ = true;
      return true;
    }
    return are_near(corners, is_least ? kMostWalls : 0);
  }

  NearTriangles::Nearest near_surface(const RationalPoint& x) const {
    return cells_.triangles().nearest(cells_.frame()(x));
  }

  // Whether the hull of some points is within T of one triangle, or is so in pieces: what lies
  // above a triangle is tested against that, and what lies beyond one of its walls by itself. So a
  // facet of the part at a distance of exactly T from a face is proven, into whatever triangles the
  // face is cut.
  bool are_near(const std::vector<RationalPoint>& points, std::size_t walls) const {
    std::vector<std::uint32_t> triangles;
    for (const RationalPoint& x : points) {
      const std::uint32_t t = near_surface(x).triangle;
      if (std::find(triangles.begin(), triangles.end(), t) == triangles.end())
        triangles.push_back(t);
    }
    for (const std::uint32_t t : triangles) {
      if (are_near(points, t)) return true;
    }
    for (const std::uint32_t t : triangles) {
      if (walls == 0) return false;
      std::vector<RationalPoint> above = points;
      std::vector<std::vector<RationalPoint>> beyond;
      for (const Halfspace& wall : walls_of(t)) {
        std::vector<RationalPoint> rest =
            on_one_side(above, Halfspace(IntegerVector3(-wall.normal()), -wall.offset()));
        if (!rest.empty()) beyond.push_back(std::move(rest));
        above = on_one_side(above, wall);
        if (above.empty()) break;
      }
      if (beyond.empty() || above.empty() || !are_near(above, t)) continue;
      return std::all_of(beyond.begin(), beyond.end(),
                         [&](const auto& rest) { return are_near(rest, walls - 1); });
    }
    return false;
  }

  // Planes at right angles to a triangle through its sides; the triangle lies where all hold.
  std::vector<Halfspace> walls_of(std::uint32_t triangle) const {
    const auto& corners = cells_.surface().triangles[triangle];
    const auto& points = cells_.surface().points;
    const RationalVector3 normal = area_vector(points, corners);
    std::vector<Halfspace> walls;
    for (std::size_t k = 0; k < 3 && !normal.isZero(); ++k) {
      const RationalPoint from = points[corners[k]];
      const RationalVector3 along = points[corners[(k + 1) % 3]] - from;
      const RationalVector3 outward = along.cross(normal);
      walls.emplace_back(outward, Rational(-outward.dot(from)));
    }
    return walls;
  }

  bool are_near(const std::vector<RationalPoint>& corners, std::uint32_t triangle) const {
    return std::all_of(corners.begin(), corners.end(), [&](const RationalPoint& x) {
      const NearBounds near = cells_.triangles().to_triangle(triangle, cells_.frame()(x));
      if (near.high <= cells_.limit_down()) return true;
      if (near.low > cells_.limit_up()) return false;
      return nearest_on_triangle(cells_.surface(), triangle, x).squared <= squared_limit_;
    });
  }

  ReachCells& cells_;
  const ConvexPart& part_;
  const NearPart near_;
  const Rational& squared_limit_;
  const bool may_clip_;
  const Watch& watch_;
  bool is_beyond_ = false, is_open_ = false;
  std::optional<FarthestPoint> farthest_;  // if beyond
  double most_found_ = 0, open_high_ = 0;
  CellPlace found_at_{};
};

NearFrame frame_for(const Surface& surface, std::span<const BoundingBox> boxes) {
  std::vector<BoundingBox> all(boxes.begin(), boxes.end());
  all.push_back(bounding_box(surface.points));
  return frame_around(all);
}

}  // namespace

ReachLimit::Search::Search(const Surface& surface, const Winding* winding, const Rational& squared,
                           std::span<const BoundingBox> boxes)
    : squared_limit(squared), cells(surface, winding, frame_for(surface, boxes), squared) {}

ReachLimit::ReachLimit(const Surface& surface, const Winding* winding,
                       const Rational& squared_limit, std::span<const BoundingBox> boxes) {
  if (squared_limit <= 0) throw Error(ErrorCode::InvalidArgument, "a reach limit that is not > 0");
  if (surface.triangles.empty()) throw Error(ErrorCode::InvalidArgument, "a surface of nothing");
  search_ = std::make_unique<Search>(surface, winding, squared_limit, boxes);
}
ReachLimit::~ReachLimit() = default;
ReachLimit::ReachLimit(ReachLimit&&) noexcept = default;

PartReach ReachLimit::operator()(const ConvexPart& part, const Watch& watch) {
  return PartWalk(search_->cells, part, search_->squared_limit, true, watch).answer();
}

bool ReachLimit::allows(const ConvexPart& part, const Watch& watch) {
  return PartWalk(search_->cells, part, search_->squared_limit, false, watch).is_within();
}

const Rational& ReachLimit::squared_limit() const { return search_->squared_limit; }
std::size_t ReachLimit::cells() const { return search_->cells.size(); }

}  // namespace convexact
