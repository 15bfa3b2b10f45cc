// SPDX-License-Identifier: MIT
// reach_limit.cpp - whether a part lies within T of a solid: down the cells that it meets, those
// farthest from the surface first.
#include <algorithm>
#include <atomic>

#include "convexact/hull.hpp"
#include "convexact/reach.hpp"
#include "reach/clear_cell.hpp"
#include "reach/clipped_part.hpp"
#include "reach/met_cell.hpp"
#include "reach/reach_search.hpp"
#include "reach/walk_cells.hpp"
#include "surface/flat_polygon.hpp"
#include "task/parallel.hpp"

namespace convexact {
namespace {

// A part with few planes at a cell of this share of T is decided in exact numbers at once: that is
// quicker than many small cells along a facet that lies just within T.
constexpr double kClipFrom = 1.0 / 8, kClipTo = 1.0 / 4;
constexpr std::size_t kClipPlanes = 24;
// What a part and a cell have in common is cut at the walls of so many triangles, one after
// another.
constexpr std::size_t kMostWalls = 3;
// Parts that are asked about at the same time: each opens kReachCells a walk, of which there may be
// two.
constexpr std::size_t kTogether = 4;

// The way down the cells for one part, by cells alone.
class CellWalk {
 public:
  CellWalk(ReachCells& cells, const NearPart& part, const Watch& watch)
      : cells_(cells), near_(part), watch_(watch) {}
  virtual ~CellWalk() = default;

  // Whether all cells that the part meets are fine.
  bool is_within() {
    walk_cells(cells_, near_, [&](const MetCell& met) { return visit(met); });
    return !is_beyond_ && !is_open_;
  }

  // Of a part that is not within T: a point near it in a cell that is not fine.
  FarPlace open_place() const { return open_; }

 protected:
  // Smaller cells are not visited.
  virtual double least_half() const { return cells_.least_half(); }
  // What exact numbers know of a cell: nothing here.
  virtual bool may_decide() const { return false; }
  // Whether the part has a point that is beyond T: y, or the one nearest to the center of a cell.
  virtual bool confirms(const CellPlace&, const Point&) { return true; }
  // Whether what the part and the cell have in common is near enough, or beyond T.
  virtual bool decides(const MetCell&, bool) { return false; }

  ReachCells& cells_;
  bool is_beyond_ = false, is_open_ = false;
  double most_found_ = 0, open_high_ = 0;  // distances from the surface: found, and possible
  CellPlace found_at_{};

 private:
  // The cell is not fine. A part that is refuted ends the search, and one that is open if nothing
  // else can decide.
  Below visit(const MetCell& met) {
    watch_.ask();
    const CellPlace& place = met.place;
    const SeenPart part = seen_from(met, near_);
    if (part.is_apart) return Below::Skip;
    if (part.has_center) {
      refute(place, place.center, cells_.distance(place.cell), cells_.is_at_zero());
    } else if (cells_.distance(place.cell).high + part.hull.bounds.high > cells_.limit_up()) {
      const Point& y = part.nearest;
      refute(place, y, cells_.triangles().nearest(y, cells_.triangle(place.cell)).distance, false);
    }
    if (is_beyond_) return Below::Stop;
    if (const auto clear = clear_point(cells_, near_, met, part.nearest)) {
      if (!clear->is_outside) return Below::Skip;
      if (cells_.is_at_zero()) {
        const Point& y = clear->point;
        refute(place, y, cells_.triangles().nearest(y, cells_.triangle(place.cell)).distance, true);
        if (is_beyond_) return Below::Stop;
      }
    }
    const bool is_least = place.half <= least_half() || opened_ == kReachCells;
    if (decides(met, is_least)) return is_beyond_ ? Below::Stop : Below::Skip;
    if (!is_least) {
      opened_ += 8;
      return Below::Visit;
    }
    is_open_ = true;
    if (open_.distance < cells_.distance(place.cell).high) {
      open_ = {nearest_point(place), cells_.distance(place.cell).high};
    }
    open_high_ = std::max(open_high_, cells_.distance(place.cell).high + place.radius());
    return may_decide() ? Below::Skip : Below::Stop;
  }

  // A point y of the part, up to rounding, that is about in the cell. Rounding moved it by less
  // than kReachError, so it did not take it through the surface.
  // @param suffices  It is beyond T if it is outside, however near.
  void refute(const CellPlace& place, const Point& y, const NearBounds& distance, bool suffices) {
    const bool is_far = distance.low > (suffices ? 0 : cells_.limit_up()) + kReachError;
    if (!is_far && (!may_decide() || distance.low <= most_found_)) return;
    const bool is_center = y == place.center;
    if (!(is_center ? cells_.is_outside(place) : cells_.is_outside(y))) return;
    if (distance.low > most_found_) {
      most_found_ = distance.low;
      found_at_ = place;
    }
    if (is_far && open_.distance < distance.low) open_ = {y, distance.low};
    is_beyond_ = is_far && confirms(place, y);
  }

  // The point of the part that is nearest to the center of a cell.
  Point nearest_point(const CellPlace& place) const {
    return place.center + near_.seen_from(place.center).nearest;
  }

  FarPlace open_{Point::Zero(), 0};
  std::size_t opened_ = 0;  // cells, known ones as well
  const NearPart& near_;
  const Watch& watch_;
};

// The same with exact numbers, for a witness and for cells that are open.
class PartWalk : public CellWalk {
 public:
  PartWalk(ReachCells& cells, const NearPart& near, const ConvexPart& part,
           const Rational& squared_limit, const Watch& watch)
      : CellWalk(cells, near, watch), part_(part), squared_limit_(squared_limit) {}

  // By cells that are not too small, whose first open one ends the search; `near` may be smaller
  // than the part.
  std::optional<PartReach> answer_of_cells() {
    clips_ = false;
    if (is_within()) return PartReach{};
    if (is_beyond_) return PartReach{Reach::Beyond, std::move(farthest_), {}};
    return {};
  }

  PartReach answer() {
    if (is_within()) return {};
    if (is_beyond_) return {Reach::Beyond, std::move(farthest_), {}};
    PartReach result{Reach::Undecided, {}, {}};
    if (most_found_ > 0) consider(point_of_part(found_at_, found_at_.center), result.witness);
    const Rational high = cells_.frame().length(open_high_);
    const Rational low = result.witness ? result.witness->squared : Rational(0);
    result.bracket = SquaredBracket{std::min(low, squared_limit_), high * high};
    return result;
  }

 private:
  double least_half() const override {
    return clips_ ? cells_.least_half()
                  : std::max(cells_.least_half(), kClipTo * cells_.limit_up());
  }
  bool may_decide() const override { return clips_; }
  bool confirms(const CellPlace& place, const Point& y) override {
    return consider(point_of_part(place, y), farthest_);
  }

  bool decides(const MetCell& met, bool is_least) override {
    if (!clips_) return false;
    const double share = met.place.half / cells_.limit_up();
    if (!is_least && (share <= kClipFrom || share > kClipTo)) return false;
    return met.planes.size() <= kClipPlanes && clip(met.place, is_least);
  }

  // A point, if the part holds it, else the one that is nearest to the center of a cell.
  RationalPoint point_of_part(const CellPlace& place, const Point& y) const {
    RationalPoint exact = cells_.frame().point(y);
    if (holds(part_, exact)) return exact;
    return UnionDistance(std::span(&part_, 1)).nearest_in(0, cells_.frame().point(place.center));
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
    if (corners.empty() || are_near_triangle(corners, cells_.triangle(place.cell))) return true;
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
      if (are_near_triangle(points, t)) return true;
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
      if (beyond.empty() || above.empty() || !are_near_triangle(above, t)) continue;
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

  bool are_near_triangle(const std::vector<RationalPoint>& corners, std::uint32_t triangle) const {
    return std::all_of(corners.begin(), corners.end(), [&](const RationalPoint& x) {
      const NearBounds near = cells_.triangles().to_triangle(triangle, cells_.frame()(x));
      if (near.high <= cells_.limit_down()) return true;
      if (near.low > cells_.limit_up()) return false;
      return nearest_on_triangle(cells_.surface(), triangle, x).squared <= squared_limit_;
    });
  }

  const ConvexPart& part_;
  const Rational& squared_limit_;
  bool clips_ = true;
  std::optional<FarthestPoint> farthest_;  // if beyond
};

// The farthest center of a cell in the part, up to a few percent.
class FarthestWalk {
 public:
  FarthestWalk(ReachCells& cells, const NearPart& part, const Watch& watch)
      : cells_(cells), near_(part), watch_(watch) {}

  std::optional<FarPlace> find() {
    walk_cells(cells_, near_, [&](const MetCell& met) { return visit(met); });
    return best_;
  }

 private:
  // The cell is not fine.
  Below visit(const MetCell& met) {
    constexpr double kSlack = 1.03, kFine = 1.0 / 8;
    watch_.ask();
    const CellPlace& place = met.place;
    const NearBounds distance = cells_.distance(place.cell);
    const double best = best_ ? best_->distance * kSlack : cells_.limit_up();
    if (distance.high + place.radius() <= best) return Below::Skip;
    const SeenPart part = seen_from(met, near_);
    if (part.is_apart) return Below::Skip;
    if (part.has_center && distance.low > best && cells_.is_outside(place)) {
      best_ = FarPlace{place.center, distance.low};
    }
    const auto clear = clear_point(cells_, near_, met, part.nearest);
    if (clear && !clear->is_outside) return Below::Skip;
    if (place.half <= cells_.limit_up() * kFine) return Below::Skip;
    if (opened_ == kReachCells) return Below::Skip;
    opened_ += 8;
    return Below::Visit;
  }

  ReachCells& cells_;
  const NearPart& near_;
  const Watch& watch_;
  std::optional<FarPlace> best_;
  std::size_t opened_ = 0;  // cells, known ones as well
};

// The part in the frame of the cells, which must hold it.
NearPart in_frame(const ReachCells& cells, NearPart part) {
  for (const Point& y : part.vertices()) {
    if (!(y.lpNorm<Eigen::Infinity>() < cells.root().half - kReachError)) {
      throw Error(ErrorCode::InvalidArgument, "a part lies beyond the boxes of a reach limit");
    }
  }
  return part;
}

// Points that are all within T of one triangle have a hull that is, too.
bool are_near_one_triangle(const ReachCells& cells, std::span<const Point> points) {
  Point sum = Point::Zero();
  for (const Point& y : points) sum += y;
  const std::uint32_t middle =
      cells.triangles().nearest(sum / static_cast<double>(points.size())).triangle;
  return std::all_of(points.begin(), points.end(), [&](const Point& y) {
    return cells.triangles().to_triangle(middle, y).high <= cells.limit_down();
  });
}

// The same for a walk by cells alone.
NearPart inner_in_frame(const ReachCells& cells, NearPart part) {
  NearPart whole = in_frame(cells, std::move(part));
  std::optional<InnerPart> inner = inner_part(cells, whole);
  return inner ? std::move(inner->part) : std::move(whole);
}

Rational least_squared_limit(const Surface& surface) {
  return bounding_box(surface.points).squared_diameter() * kLeastReach * kLeastReach;
}

NearFrame frame_for(const Surface& surface, std::span<const BoundingBox> boxes) {
  std::vector<BoundingBox> all(boxes.begin(), boxes.end());
  all.push_back(bounding_box(surface.points));
  return frame_around(all);
}

}  // namespace

ReachLimit::Search::Search(const Surface& surface, const Winding* winding, const Rational& squared,
                           std::span<const BoundingBox> boxes)
    : squared_limit(squared),
      cells(surface, winding, frame_for(surface, boxes),
            squared > 0 ? squared : least_squared_limit(surface), squared == 0) {}

ReachLimit::ReachLimit(const Surface& surface, const Winding* winding,
                       const Rational& squared_limit, std::span<const BoundingBox> boxes) {
  if (squared_limit < 0) throw Error(ErrorCode::InvalidArgument, "a reach limit below 0");
  if (surface.triangles.empty()) throw Error(ErrorCode::InvalidArgument, "a surface of nothing");
  search_ = std::make_unique<Search>(surface, winding, squared_limit, boxes);
}
ReachLimit::~ReachLimit() = default;
ReachLimit::ReachLimit(ReachLimit&&) noexcept = default;
ReachLimit& ReachLimit::operator=(ReachLimit&&) noexcept = default;

PartReach ReachLimit::operator()(const ConvexPart& part, const Watch& watch) {
  ReachCells& cells = search_->cells;
  cells.make_room();
  const Rational& squared = search_->squared_limit;
  const NearPart near = in_frame(cells, NearPart(part, cells.frame()));
  if (const std::optional<InnerPart> inner = inner_part(cells, near)) {
    if (auto answer = PartWalk(cells, inner->part, part, squared, watch).answer_of_cells()) {
      return std::move(*answer);
    }
  }
  return PartWalk(cells, near, part, squared, watch).answer();
}

bool ReachLimit::Search::allows(NearPart part, const Watch& watch) {
  return CellWalk(cells, inner_in_frame(cells, std::move(part)), watch).is_within();
}

bool ReachLimit::allows(const ConvexPart& part, const Watch& watch) {
  search_->cells.make_room();
  return search_->allows(NearPart(part, frame()), watch);
}

// That settles most small clusters.
bool ReachLimit::allows_hull(std::span<const PointId> points, const Watch& watch) {
  constexpr std::size_t kFew = 64;  // points, of which it does not pay to find the extreme ones
  ReachCells& cells = search_->cells;
  cells.make_room();
  std::vector<Point> near;
  for (const PointId p : points) near.push_back(cells.triangles().point(p));
  if (are_near_one_triangle(cells, near)) return true;
  if (near.size() > kFew) {
    const HullOutcome outcome = convex_hull(subset(cells.surface().points, points));
    if (const auto* hull = std::get_if<Hull>(&outcome)) {
      std::vector<Point> extreme;
      for (const PointId p : hull->vertices) extreme.push_back(near[p.index()]);
      near = std::move(extreme);
    }
  }
  return CellWalk(cells, NearPart(std::move(near)), watch).is_within();
}

bool ReachLimit::allows_near(std::span<const Point> points, const Watch& watch) {
  search_->cells.make_room();
  return search_->allows(NearPart(near_solid(points)), watch);
}

// Where the part is so thin that it holds no center, the place is near it, in a cell that is not
// fine.
std::optional<FarPlace> ReachLimit::Search::farthest(std::span<const Point> points,
                                                     const Watch& watch) {
  // A sliver along a face would take cells as small as T all over it.
  if (cells.is_at_zero() && are_near_one_triangle(cells, points)) return {};
  const NearPart near = inner_in_frame(cells, NearPart(near_solid(points)));
  CellWalk walk(cells, near, watch);
  if (walk.is_within()) return {};
  if (cells.is_at_zero()) return walk.open_place();
  if (auto found = FarthestWalk(cells, near, watch).find()) return found;
  return walk.open_place();
}

void ReachLimit::Search::ask_each(std::size_t count, std::size_t jobs,
                                  const std::function<void(std::size_t)>& ask,
                                  const std::function<bool(std::size_t)>& goes_on) {
  for (std::size_t first = 0; first < count && (!goes_on || goes_on(first)); first += kTogether) {
    cells.make_room();
    for_each_in_parallel(std::min(kTogether, count - first), jobs,
                         [&](std::size_t k) { ask(first + k); });
  }
}

std::vector<bool> ReachLimit::allows_each(std::span<const ConvexPart> parts, std::size_t jobs,
                                          const Watch& watch) {
  std::vector<char> allowed(parts.size());  // bits of one word are not for several threads
  search_->ask_each(
      parts.size(), jobs,
      [&](std::size_t k) { allowed[k] = search_->allows(NearPart(parts[k], frame()), watch); },
      [&](std::size_t done) {
        watch.report(done, parts.size());
        return true;
      });
  return {allowed.begin(), allowed.end()};
}

bool ReachLimit::allows_all(std::span<const ConvexPart> parts, std::size_t jobs,
                            const Watch& watch) {
  std::atomic<bool> are_allowed = true;
  search_->ask_each(
      parts.size(), jobs,
      [&](std::size_t k) {
        if (!search_->allows(NearPart(parts[k], frame()), watch)) are_allowed = false;
      },
      [&](std::size_t) { return are_allowed.load(); });
  return are_allowed;
}

std::vector<std::optional<FarPlace>> ReachLimit::farthest_of_each(
    std::span<const std::vector<Point>> parts, std::size_t jobs, const Watch& watch) {
  std::vector<std::optional<FarPlace>> found(parts.size());
  search_->ask_each(parts.size(), jobs,
                    [&](std::size_t k) { found[k] = search_->farthest(parts[k], watch); });
  return found;
}

const NearFrame& ReachLimit::frame() const { return search_->cells.frame(); }

const Rational& ReachLimit::squared_limit() const { return search_->squared_limit; }
std::size_t ReachLimit::cells() const { return search_->cells.size(); }

}  // namespace convexact
