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

class CellSearch {
 public:
  CellSearch(const NearTriangles& triangles, const NearFrame& frame, const Winding* winding,
             double gap)
      : triangles_(triangles), frame_(frame), winding_(winding), gap_(gap) {}

  // A corner of cells in the part, which may be the farthest point so far.
  std::uint32_t add_site(const Point& y, std::uint32_t part) {
    sites_.push_back({y, triangles_.nearest(y), part, {}});
    Site& site = sites_.back();
    if (site.surface.distance.low - kCellError > lower_ && is_outside(site)) {
      lower_ = site.surface.distance.low - kCellError;
      farthest_ = static_cast<std::uint32_t>(sites_.size() - 1);
    }
    return static_cast<std::uint32_t>(sites_.size() - 1);
  }

  void add_cell(const std::array<std::uint32_t, 4>& corners, std::uint32_t size) {
    DistanceCell cell{corners, size, 0};
    cell.upper = upper_bound(cell);
    if (cell.upper <= lower_ + gap_) {
      dropped_ = std::max(dropped_, cell.upper);
    } else {
      queue_.push(cell);
    }
  }

  // Bisects cells until the bounds are close, or kReachPieces are spent.
  void run(const Watch& watch) {
    for (std::size_t done = 0; done < kReachPieces && !queue_.empty(); ++done) {
      watch.at(done, kReachPieces);
      const DistanceCell cell = queue_.top();
      if (cell.upper <= lower_ + gap_ || cell.size == 1) return;
      queue_.pop();
      bisect(cell);
    }
  }

  double lower() const { return std::max(0.0, lower_); }
  double upper() const {
    return std::max({lower(), dropped_, queue_.empty() ? 0 : queue_.top().upper});
  }
  // The site whose distance is at least lower(), if that is > 0.
  const Site& farthest() const { return sites_[farthest_]; }

 private:
  bool is_outside(Site& site) {
    if (winding_ == nullptr) return true;
    if (!site.is_outside) {
      const std::optional<long> number = (*winding_)(frame_.point(site.y));
      site.is_outside = number && *number == 0;
    }
    return *site.is_outside;
  }

  // There are three bounds; each is computed only if those before it are not low enough.
  double upper_bound(const DistanceCell& cell) {
    const double enough = lower_ + gap_;
    Point middle = Point::Zero();
    for (std::uint32_t k = 0; k < cell.size; ++k) middle += sites_[cell.corners[k]].y;
    middle /= cell.size;
    double radius = 0;
    for (std::uint32_t k = 0; k < cell.size; ++k) {
      radius = std::max(radius, (sites_[cell.corners[k]].y - middle).norm());
    }
    radius += kCellError;
    const std::uint32_t part = sites_[cell.corners[0]].part;
    const std::uint32_t index = add_site(middle, part);
    Site center = sites_[index];
    if (farthest_ != index) sites_.pop_back();
    // (1) The distance to the surface differs by at most the radius from that of the centroid.
    double upper = center.surface.distance.high + radius;
    if (upper <= enough) return upper;
    // (2) The distance to one triangle is convex, so it is largest at a corner.
    upper = std::min(upper, bound_by_triangle(cell, center.surface.triangle));
    for (std::uint32_t k = 0; k < cell.size && upper > enough; ++k) {
      upper = std::min(upper, bound_by_triangle(cell, sites_[cell.corners[k]].surface.triangle));
    }
    if (upper <= enough || is_outside(center)) return upper;
    // (3) The centroid is in the solid, with all points that are nearer to it than the surface. The
    // cell shrunk towards its centroid is also in the solid if no triangle meets it: then all of
    // the cell is near the solid.
    upper = std::min(upper, std::max(0.0, radius - center.surface.distance.low) + kCellError);
    if (upper <= enough) return upper;
    const double share = std::min(0.5, enough / radius * (1 - 0x1p-10));
    std::array<Point, 4> shrunk;
    for (std::uint32_t k = 0; k < cell.size; ++k) {
      shrunk[k] = sites_[cell.corners[k]].y * (1 - share) + middle * share;
    }
    if (triangles_.misses(std::span(shrunk).first(cell.size))) {
      upper = std::min(upper, share * radius + kCellError);
    }
    return upper;
  }

  double bound_by_triangle(const DistanceCell& cell, std::uint32_t triangle) const {
    double largest = 0;
    for (std::uint32_t k = 0; k < cell.size; ++k) {
      const Point& y = sites_[cell.corners[k]].y;
      largest = std::max(largest, triangles_.to_triangle(triangle, y).high);
    }
    return largest + kCellError;
  }

  void bisect(const DistanceCell& cell) {
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
    const Point middle = (a.y + b.y) / 2;
    const std::uint32_t m = add_site(middle, a.part);
    for (const std::uint32_t gone : {from, to}) {
      std::array<std::uint32_t, 4> half = cell.corners;
      half[gone] = m;
      add_cell(half, cell.size);
    }
  }

  const NearTriangles& triangles_;
  const NearFrame& frame_;
  const Winding* winding_;
  double gap_;
  std::vector<Site> sites_;
  std::priority_queue<DistanceCell, std::vector<DistanceCell>, ByCellBound> queue_;
  double lower_ = 0, dropped_ = 0;
  std::uint32_t farthest_ = 0xffffffffu;  // no site
};

// The simplices of parts[part]: a fan of tetrahedra from its first vertex to the facets without it,
// or of triangles to such sides of a polygon.
void add_part(CellSearch& search, const NearFrame& frame, const ConvexPart& part,
              std::uint32_t index) {
  const std::vector<RationalPoint>& vertices = part.solid ? part.solid->vertices : part.vertices;
  std::vector<std::uint32_t> sites;
  for (const RationalPoint& v : vertices) sites.push_back(search.add_site(frame(v), index));
  if (part.dimension == 2) {
    for (const auto& [a, b] : FlatFeatures(part).sides) {
      if (a != 0 && b != 0) search.add_cell({sites[0], sites[a], sites[b], 0}, 3);
    }
  } else if (!part.solid) {
    search.add_cell({sites.front(), sites.back(), 0, 0}, static_cast<std::uint32_t>(sites.size()));
  } else {
    for (const std::vector<std::uint32_t>& facet : part.solid->facets) {
      if (std::find(facet.begin(), facet.end(), 0u) != facet.end()) continue;
      for (std::size_t k = 1; k + 1 < facet.size(); ++k) {
        search.add_cell({sites[0], sites[facet[0]], sites[facet[k]], sites[facet[k + 1]]}, 4);
      }
    }
  }
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
                                  const Watch& watch) {
  if (squared_diameter <= 0) throw Error(ErrorCode::InvalidArgument, "a diameter that is not > 0");
  if (surface.triangles.empty()) throw Error(ErrorCode::InvalidArgument, "a surface of nothing");
  const UnionDistance distance(parts);
  std::vector<BoundingBox> boxes{bounding_box(surface.points)};
  for (const ConvexPart& part : parts) boxes.push_back(part.box);
  const NearFrame frame = frame_around(boxes);
  const NearTriangles triangles(seen_from_outside(surface, winding, watch), frame);
  // A little less, for the roundings of the bounds.
  const double gap = frame.root_down(squared_diameter) * (1 - 0x1p-10) / kDistanceSteps;
  CellSearch search(triangles, frame, winding, gap);
  for (std::size_t p = 0; p < parts.size(); ++p) {
    watch.ask();
    add_part(search, frame, parts[p], static_cast<std::uint32_t>(p));
  }
  search.run(watch);
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
