// SPDX-License-Identifier: MIT
// union_distance_cells.cpp - how far a union of parts reaches away from a surface or its solid:
// branch and bound over simplices that fill the parts. docs/design/union-distance.md.
#include <algorithm>
#include <array>
#include <queue>
#include <vector>

#include "convexact/error.hpp"
#include "convexact/overlay.hpp"
#include "overlay/union_distance_flat.hpp"
#include "overlay/union_distance_near.hpp"
#include "overlay/union_distance_triangles.hpp"
#include "surface/patches.hpp"
#include "task/parallel.hpp"

namespace convexact {
namespace {

// The error that rounding adds to the bounds of cells. A middle of a side is off by 2^-54 in each
// coordinate, so the halves of a cell leave out no point that is more than 2^-53 from them; with
// less than 128 cuts one after another a point of a part is within 2^-46 of a cell, and a corner of
// a cell within 2^-46 of the part.
constexpr double kCellError = 0x1p-45;

// A corner or a centroid of cells. Its distance to the surface is 0 or more.
struct Site {
  Point y;
  NearTriangles::Nearest surface;
  std::uint32_t part;
  std::optional<bool> is_outside;  // of the solid; of an open surface: always
};

// A simplex in a part, possibly with fewer than four corners.
struct DistanceCell {
  std::array<std::uint32_t, 4> corners;
  std::uint32_t size;  // 1 to 4
  double upper;
};

struct ByCellBound {
  bool operator()(const DistanceCell& a, const DistanceCell& b) const {
    return a.upper != b.upper ? a.upper < b.upper : a.corners > b.corners;
  }
};

// Sites and cells come in batches: those of one are looked at with the lower bound that there was
// before it, on any number of threads, and kept one after another.
class CellSearch {
 public:
  CellSearch(const NearTriangles& triangles, const NearFrame& frame, const Winding* winding,
             double gap, const Watch& watch, std::size_t jobs)
      : triangles_(triangles),
        frame_(frame),
        winding_(winding),
        gap_(gap),
        watch_(watch),
        jobs_(jobs) {}

  // Corners of cells in the part, which may be the farthest points so far. Returns the first of
  // their numbers, which ascend.
  std::uint32_t add_sites(std::span<const Point> points, std::uint32_t part) {
    const auto first = static_cast<std::uint32_t>(sites_.size());
    in_batches<Site>(
        points.size(), [&](std::size_t k) { return site_at(points[k], part); },
        [&](Site site) { (void)keep(std::move(site)); });
    return first;
  }

  void add_cells(std::span<const DistanceCell> cells) {
    in_batches<Judged>(
        cells.size(), [&](std::size_t k) { return judge(cells[k], corners_of(cells[k])); },
        [&](Judged judged) { keep(std::move(judged)); });
  }

  // Bisects cells until the bounds are close, or kReachPieces are spent.
  void run() {
    std::vector<DistanceCell> cells;
    for (std::size_t done = 0; done < kReachPieces; done += cells.size()) {
      watch_.ask();
      watch_.report(done, kReachPieces);
      cells.clear();
      while (cells.size() < kBatch && !queue_.empty() && queue_.top().size > 1 &&
             queue_.top().upper > lower_ + gap_) {
        cells.push_back(queue_.top());
        queue_.pop();
      }
      if (cells.empty()) return;
      in_batches<Halves>(
          cells.size(), [&](std::size_t k) { return bisect(cells[k]); },
          [&](Halves halves) { keep(std::move(halves)); });
    }
  }

  double lower() const { return std::max(0.0, lower_); }
  double upper() const {
    return std::max({lower(), dropped_, queue_.empty() ? 0 : queue_.top().upper});
  }
  // The site whose distance is at least lower(), if that is > 0.
  const Site& farthest() const { return sites_[farthest_]; }

 private:
  // Not one for each thread: bounds must not depend on their number.
  static constexpr std::size_t kBatch = 64;

  // A cell with its upper bound, and its centroid, which is kept if it is the farthest point.
  struct Judged {
    DistanceCell cell;
    Site center;
  };
  struct Halves {
    Site middle;
    std::array<Judged, 2> halves;        // The corner at the middle has no number yet:
    std::array<std::uint32_t, 2> moved;  // it is this one of each.
  };

  template <class Made, class Make, class Keep>
  void in_batches(std::size_t count, const Make& make, const Keep& keep_one) {
    std::vector<std::optional<Made>> made;
    for (std::size_t first = 0; first < count; first += kBatch) {
      watch_.ask();
      made.clear();
      made.resize(std::min(kBatch, count - first));
      const std::size_t jobs = made.size() < kBatch / 2 ? 1 : jobs_;  // few end at once
      for_each_in_parallel(made.size(), jobs,
                           [&](std::size_t k) { made[k].emplace(make(first + k)); });
      for (std::optional<Made>& one : made) keep_one(std::move(*one));
    }
  }

  Site site_at(const Point& y, std::uint32_t part) const {
    Site site{y, triangles_.nearest(y), part, {}};
    if (site.surface.distance.low - kCellError > lower_) (void)is_outside(site);
    return site;
  }

  std::uint32_t keep(Site site) {
    const double distance = site.surface.distance.low - kCellError;
    sites_.push_back(std::move(site));
    const auto index = static_cast<std::uint32_t>(sites_.size() - 1);
    if (distance > lower_ && is_outside(sites_.back())) {
      lower_ = distance;
      farthest_ = index;
    }
    return index;
  }

  void keep(Judged judged) {
    if (judged.center.surface.distance.low - kCellError > lower_) {
      const std::uint32_t index = keep(std::move(judged.center));
      if (farthest_ != index) sites_.pop_back();
    }
    if (judged.cell.upper <= lower_ + gap_) {
      dropped_ = std::max(dropped_, judged.cell.upper);
    } else {
      queue_.push(judged.cell);
    }
  }

  void keep(Halves made) {
    const std::uint32_t middle = keep(std::move(made.middle));
    for (std::size_t k = 0; k < 2; ++k) {
      made.halves[k].cell.corners[made.moved[k]] = middle;
      keep(std::move(made.halves[k]));
    }
  }

  bool is_outside(Site& site) const {
    if (winding_ == nullptr) return true;
    if (!site.is_outside) {
      const std::optional<long> number = (*winding_)(frame_.point(site.y));
      site.is_outside = number && *number == 0;
    }
    return *site.is_outside;
  }

  using Corners = std::array<const Site*, 4>;  // as many as the cell has
  Corners corners_of(const DistanceCell& cell) const {
    Corners corners{};
    for (std::uint32_t c = 0; c < cell.size; ++c) corners[c] = &sites_[cell.corners[c]];
    return corners;
  }

  Judged judge(DistanceCell cell, const Corners& all) const {
    const auto corners = std::span(all).first(cell.size);
    Point middle = Point::Zero();
    for (const Site* corner : corners) middle += corner->y;
    middle /= cell.size;
    Judged judged{cell, site_at(middle, corners[0]->part)};
    judged.cell.upper = upper_bound(corners, judged.center);
    return judged;
  }

  // There are three bounds; each is computed only if those before it are not low enough.
  double upper_bound(std::span<const Site* const> corners, Site& center) const {
    const double enough = lower_ + gap_;
    double radius = 0;
    for (const Site* corner : corners) radius = std::max(radius, (corner->y - center.y).norm());
    radius += kCellError;
    // (1) The distance to the surface differs by at most the radius from that of the centroid.
    double upper = center.surface.distance.high + radius;
    if (upper <= enough) return upper;
    // (2) The distance to one triangle is convex, so it is largest at a corner.
    upper = std::min(upper, bound_by_triangle(corners, center.surface.triangle));
    for (std::size_t k = 0; k < corners.size() && upper > enough; ++k) {
      upper = std::min(upper, bound_by_triangle(corners, corners[k]->surface.triangle));
    }
    if (upper <= enough || is_outside(center)) return upper;
    // (3) The centroid is in the solid, with all points that are nearer to it than the surface. The
    // cell shrunk towards its centroid is also in the solid if no triangle meets it: then all of
    // the cell is near the solid.
    upper = std::min(upper, std::max(0.0, radius - center.surface.distance.low) + kCellError);
    if (upper <= enough) return upper;
    const double share = std::min(0.5, enough / radius * (1 - 0x1p-10));
    std::array<Point, 4> shrunk;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      shrunk[k] = corners[k]->y * (1 - share) + center.y * share;
    }
    if (triangles_.misses(std::span(shrunk).first(corners.size()))) {
      upper = std::min(upper, share * radius + kCellError);
    }
    return upper;
  }

  double bound_by_triangle(std::span<const Site* const> corners, std::uint32_t triangle) const {
    double largest = 0;
    for (const Site* corner : corners) {
      largest = std::max(largest, triangles_.to_triangle(triangle, corner->y).high);
    }
    return largest + kCellError;
  }

  Halves bisect(const DistanceCell& cell) const {
    std::uint32_t from = 0, to = 1;
    double longest = -1;
    for (std::uint32_t i = 0; i < cell.size; ++i) {
      for (std::uint32_t k = i + 1; k < cell.size; ++k) {
        const double length = (sites_[cell.corners[i]].y - sites_[cell.corners[k]].y).norm();
        if (length > longest) {
          longest = length;
          from = i;
          to = k;
        }
      }
    }
    const Site& a = sites_[cell.corners[from]];
    const Site& b = sites_[cell.corners[to]];
    const Site middle = site_at((a.y + b.y) / 2, a.part);
    const auto half = [&](std::uint32_t gone) {
      Corners corners = corners_of(cell);
      corners[gone] = &middle;
      return judge(cell, corners);
    };
    return {middle, {half(from), half(to)}, {from, to}};
  }

  const NearTriangles& triangles_;
  const NearFrame& frame_;
  const Winding* winding_;
  double gap_;
  const Watch& watch_;
  std::size_t jobs_;
  std::vector<Site> sites_;
  std::priority_queue<DistanceCell, std::vector<DistanceCell>, ByCellBound> queue_;
  double lower_ = 0, dropped_ = 0;
  std::uint32_t farthest_ = 0xffffffffu;  // no site
};

// The simplices of a part: a fan of tetrahedra from its first vertex to the facets without it, or
// of triangles to such sides of a polygon.
void add_part(CellSearch& search, const NearFrame& frame, const ConvexPart& part,
              std::uint32_t index) {
  const std::vector<RationalPoint>& vertices = part.solid ? part.solid->vertices : part.vertices;
  std::vector<Point> points;
  for (const RationalPoint& v : vertices) points.push_back(frame(v));
  const std::uint32_t first = search.add_sites(points, index);
  std::vector<DistanceCell> cells;
  if (part.dimension == 2) {
    for (const auto& [a, b] : FlatFeatures(part).sides) {
      if (a != 0 && b != 0) cells.push_back({{first, first + a, first + b, 0}, 3, 0});
    }
  } else if (!part.solid) {
    const auto size = static_cast<std::uint32_t>(points.size());
    cells.push_back({{first, first + size - 1, 0, 0}, size, 0});
  } else {
    for (const std::vector<std::uint32_t>& facet : part.solid->facets) {
      if (std::find(facet.begin(), facet.end(), 0u) != facet.end()) continue;
      for (std::size_t k = 1; k + 1 < facet.size(); ++k) {
        cells.push_back({{first, first + facet[0], first + facet[k], first + facet[k + 1]}, 4, 0});
      }
    }
  }
  search.add_cells(cells);
}

constexpr long kCellDistanceBits = 64;

// The surface without triangles inside of its solid, such as walls between parts: they are near
// nothing that is outside, and cells would be cut until they miss them.
Surface seen_from_outside(const Surface& surface, const Winding* winding, const Watch& watch) {
  Surface seen;
  seen.points = surface.points;
  seen.triangles = surface.triangles;
  if (winding == nullptr) return seen;
  const std::vector<std::uint32_t> ids = without_inner_triangles(surface, *winding, watch);
  if (ids.empty()) return seen;
  seen.triangles.clear();
  for (const std::uint32_t t : ids) seen.triangles.push_back(surface.triangles[t]);
  return seen;
}

}  // namespace

DirectedDistance union_to_surface(std::span<const ConvexPart> parts, const Surface& surface,
                                  const Winding* winding, const Rational& squared_diameter,
                                  const Watch& watch, std::size_t jobs) {
  if (squared_diameter <= 0) throw Error(ErrorCode::InvalidArgument, "a diameter that is not > 0");
  if (surface.triangles.empty()) throw Error(ErrorCode::InvalidArgument, "a surface of nothing");
  require_threads(jobs);
  const UnionDistance distance(parts);
  std::vector<BoundingBox> boxes{bounding_box(surface.points)};
  for (const ConvexPart& part : parts) boxes.push_back(part.box);
  const NearFrame frame = frame_around(boxes);
  const NearTriangles triangles(seen_from_outside(surface, winding, watch), frame);
  // A little less, for the roundings of the bounds.
  const double gap = frame.root_down(squared_diameter) * (1 - 0x1p-10) / kDistanceSteps;
  CellSearch search(triangles, frame, winding, gap, watch, jobs);
  for (std::size_t p = 0; p < parts.size(); ++p) {
    add_part(search, frame, parts[p], static_cast<std::uint32_t>(p));
  }
  search.run();
  DirectedDistance result{
      Enclosure(frame.length(search.lower()), frame.length(search.upper()), kCellDistanceBits), {}};
  // Rounding may have moved the site out of its part.
  if (search.lower() > 0) {
    const Site& site = search.farthest();
    result.at = distance.nearest_in(site.part, frame.point(site.y));
  }
  return result;
}

}  // namespace convexact
