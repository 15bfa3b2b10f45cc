// SPDX-License-Identifier: MIT
#include "decompose/notch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "near/near_plane.hpp"
#include "number/arithmetic.hpp"

namespace convexact {

// ---- One facet, exactly

RationalPoint nearest_on_facet(const PointSet& points, const Association::Facet& facet,
                               const Halfspace& plane, const RationalPoint& x) {
  const RationalVector3 n = plane.normal().cast<Rational>();
  const RationalPoint foot = x - plane(x) / n.squaredNorm() * n;
  std::optional<RationalPoint> nearest;
  bool is_inside = true;
  for (std::size_t k = 0; k < facet.size(); ++k) {
    const RationalPoint a = points[facet[k]], b = points[facet[(k + 1) % facet.size()]];
    const RationalVector3 along = b - a;
    if (n.dot(along.cross(foot - a)) >= 0) continue;
    is_inside = false;
    const Rational share = along.dot(x - a) / along.squaredNorm();
    const RationalPoint on_edge = a + std::clamp<Rational>(share, Rational(0), Rational(1)) * along;
    if (!nearest || (on_edge - x).squaredNorm() < (*nearest - x).squaredNorm()) nearest = on_edge;
  }
  return is_inside ? foot : *nearest;
}

// ---- Planes of facets

namespace {

// The depth of points below the plane of a facet, in the frame. Points are off by u, differences by
// 3u times their length, at most 2 sqrt(3), and the unit normal by 4u: in total less than 40u.
class NearDepth {
 public:
  static constexpr double kError = kDistanceError;

  NearDepth(const Halfspace& plane, const Point& corner)
      : unit_(unit_vector(plane.normal())), corner_(corner) {}

  double operator()(const Point& y) const { return unit_.dot(corner_ - y); }

 private:
  Point unit_, corner_;
};

std::vector<NearDepth> near_depths(const PatchHull& hull, const NearSurface& near) {
  std::vector<NearDepth> depths;
  for (std::size_t f = 0; f < hull.facets.size(); ++f) {
    depths.emplace_back(hull.planes[f], near.points[hull.facets[f][0].index()]);
  }
  return depths;
}

// Where a patch lies on its hull.
class HullContact {
 public:
  HullContact(const Surface& surface, const Patch& patch, const PatchHull& hull,
              const NearSurface& near)
      : surface_(surface),
        patch_(patch),
        hull_(hull),
        near_(near),
        depths_(near_depths(hull, near)) {}

  /// Whether a point is on the hull, and each triangle at it lies on a facet: then it is no notch
  /// for any bridges.
  bool is_all_around(PointId p) {
    if (facets_at(p).empty()) return false;
    const auto triangles = patch_.triangles_at(patch_.number_of(p));
    return std::all_of(triangles.begin(), triangles.end(), [&](std::uint32_t t) {
      const auto& [a, b, c] = surface_.triangles[patch_.triangles()[t].index()];
      return have_common(facets_at(a), facets_at(b), facets_at(c));
    });
  }

 private:
  using Facets = std::vector<std::uint32_t>;  // ascending

  static bool have_common(const Facets& a, const Facets& b, const Facets& c) {
    return std::any_of(a.begin(), a.end(), [&](std::uint32_t f) {
      return std::binary_search(b.begin(), b.end(), f) && std::binary_search(c.begin(), c.end(), f);
    });
  }

  // Those whose planes hold a point.
  const Facets& facets_at(PointId p) {
    const auto [found, is_new] = facets_at_.try_emplace(p);
    for (std::uint32_t f = 0; is_new && f < depths_.size(); ++f) {
      if (depths_[f](near_.points[p.index()]) > NearDepth::kError) continue;
      if (hull_.planes[f](surface_.points[p]) == 0) found->second.push_back(f);
    }
    return found->second;
  }

  const Surface& surface_;
  const Patch& patch_;
  const PatchHull& hull_;
  const NearSurface& near_;
  const std::vector<NearDepth> depths_;  // by facet
  std::map<PointId, Facets> facets_at_;
};

}  // namespace

// ---- Points and their bridges

namespace {

class BridgeDistances {
 public:
  BridgeDistances(const Surface& surface, const PatchHull& hull, const Association& association,
                  BridgeChoice choice, const NearSurface& near)
      : surface_(surface), hull_(hull), choice_(choice), near_(near) {
    for (const Association::Facet& facet : hull.facets) {
      std::vector<Point>& corners = corners_.emplace_back();
      NearBox& box = boxes_.emplace_back();
      for (const PointId p : facet) {
        corners.push_back(near.points[p.index()]);
        box.include(corners.back());
      }
    }
    for (const auto& bridge : association.bridges) {
      std::vector<std::uint32_t>& facets = facets_of_.emplace_back();
      for (const Association::Facet& facet : bridge) {
        const auto place = std::lower_bound(hull.facets.begin(), hull.facets.end(), facet);
        facets.push_back(static_cast<std::uint32_t>(place - hull.facets.begin()));
      }
    }
    for (std::uint32_t f = 0; f < hull.facets.size(); ++f) all_facets_.push_back(f);
  }

  // At least the distance, by the corners alone.
  double quick_high(PointId p, const std::vector<std::uint32_t>& bridges) const {
    if (bridges.empty()) return to_corner(p, all_facets_);
    double found = to_corner(p, facets_of_[bridges[0]]);
    for (std::size_t k = 1; k < bridges.size(); ++k) {
      found = chosen(found, to_corner(p, facets_of_[bridges[k]]));
    }
    return found;
  }

  NearBounds bounds(PointId p, const std::vector<std::uint32_t>& bridges) const {
    if (bridges.empty()) return to_nearest(p, all_facets_);
    NearBounds found = to_nearest(p, facets_of_[bridges[0]]);
    for (std::size_t k = 1; k < bridges.size(); ++k) {
      const NearBounds other = to_nearest(p, facets_of_[bridges[k]]);
      found.low = chosen(found.low, other.low);
      found.high = chosen(found.high, other.high);
    }
    return found;
  }

  Notch exact(PointId p, const std::vector<std::uint32_t>& bridges) const {
    if (bridges.empty()) return nearest(p, all_facets_);
    Notch found = nearest(p, facets_of_[bridges[0]]);
    for (std::size_t k = 1; k < bridges.size(); ++k) {
      Notch other = nearest(p, facets_of_[bridges[k]]);
      const bool is_better = choice_ == BridgeChoice::Farther ? other.squared > found.squared
                                                              : other.squared < found.squared;
      if (is_better) found = std::move(other);
    }
    return found;
  }

 private:
  // By Region, only points on paths have several bridges, and there the nearest counts.
  double chosen(double a, double b) const {
    return choice_ == BridgeChoice::Farther ? std::max(a, b) : std::min(a, b);
  }

  double to_corner(PointId p, const std::vector<std::uint32_t>& facets) const {
    const Point& y = near_.points[p.index()];
    double squared = std::numeric_limits<double>::infinity();
    for (const std::uint32_t f : facets) {
      for (const Point& corner : corners_[f]) {
        squared = std::min(squared, (corner - y).squaredNorm());
      }
    }
    return std::sqrt(squared) + kDistanceError;
  }

  NearBounds to_facet(PointId p, std::uint32_t facet) const {
    const Point& y = near_.points[p.index()];
    return widened(near_hull(corners_[facet], y).bounds, y);
  }
  NearBounds to_nearest(PointId p, const std::vector<std::uint32_t>& facets) const {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    const Point& y = near_.points[p.index()];
    NearBounds found{kFar, kFar};
    for (const std::uint32_t f : facets) {
      if (boxes_[f].distance(y) > found.high + kDistanceError) continue;
      const NearBounds other = to_facet(p, f);
      found.low = std::min(found.low, other.low);
      found.high = std::min(found.high, other.high);
    }
    return found;
  }

  Notch nearest(PointId p, const std::vector<std::uint32_t>& facets) const {
    const double within = to_nearest(p, facets).high;
    const RationalPoint x = surface_.points[p];
    std::optional<Notch> best;
    for (const std::uint32_t f : facets) {
      if (facets.size() > 1 && to_facet(p, f).low > within) continue;
      const RationalPoint q =
          nearest_on_facet(surface_.points, hull_.facets[f], hull_.planes[f], x);
      Rational squared = (q - x).squaredNorm();
      if (!best || squared < best->squared) best = Notch{p, q, std::move(squared)};
    }
    return *best;
  }

  const Surface& surface_;
  const PatchHull& hull_;
  BridgeChoice choice_;
  const NearSurface& near_;
  std::vector<std::vector<Point>> corners_;            // by facet
  std::vector<NearBox> boxes_;                         // by facet
  std::vector<std::vector<std::uint32_t>> facets_of_;  // by bridge
  std::vector<std::uint32_t> all_facets_;
};

}  // namespace

std::optional<Notch> deepest_notch(const Surface& surface, const Patch& patch,
                                   const PatchHull& hull, const Association& association,
                                   BridgeChoice choice, const NearSurface& near,
                                   const Watch& watch) {
  HullContact contact(surface, patch, hull, near);
  const BridgeDistances distances(surface, hull, association, choice, near);
  using Bounded = std::pair<double, std::size_t>;  // an upper bound, and the index of the point
  std::vector<Bounded> points;
  for (std::size_t k = 0; k < association.points.size(); ++k) {
    const PointId p = association.points[k];
    if (std::binary_search(hull.corners.begin(), hull.corners.end(), p)) continue;
    points.emplace_back(distances.quick_high(p, association.bridges_of[k]), k);
  }
  // The deepest first, by the bounds from corners; points that are less deep than one of them are
  // left out.
  std::sort(points.begin(), points.end(), std::greater<>());
  double deepest = 0;
  std::vector<Bounded> candidates;
  for (const auto& [quick_high, k] : points) {
    if (quick_high < deepest) break;
    watch.ask();
    if (contact.is_all_around(association.points[k])) continue;
    const NearBounds bounds = distances.bounds(association.points[k], association.bridges_of[k]);
    deepest = std::max(deepest, bounds.low);
    candidates.emplace_back(bounds.high, k);
  }
  std::optional<Notch> found;
  for (const auto& [high, k] : candidates) {
    if (high < deepest) continue;
    watch.ask();
    Notch notch = distances.exact(association.points[k], association.bridges_of[k]);
    if (notch.squared == 0) continue;
    const bool is_deeper = !found || notch.squared > found->squared ||
                           (notch.squared == found->squared && notch.point < found->point);
    if (is_deeper) found = std::move(notch);
  }
  return found;
}

// ---- Points and all facets

Rational least_concavity(const Surface& surface, const Patch& patch, const PatchHull& hull,
                         const NearSurface& near, const Watch& watch) {
  const std::vector<NearDepth> depths = near_depths(hull, near);
  if (depths.empty()) return 0;
  const auto least_near = [&](PointId p) {
    double least = std::numeric_limits<double>::infinity();
    for (const NearDepth& depth : depths) {
      least = std::min(least, depth(near.points[p.index()]));
    }
    return least;
  };
  std::vector<double> least;
  for (const PointId p : patch.points()) {
    watch.ask();
    least.push_back(least_near(p));
  }
  const double deepest = *std::max_element(least.begin(), least.end());
  Rational found = 0;
  for (std::size_t k = 0; k < least.size(); ++k) {
    if (least[k] + 2 * NearDepth::kError < deepest) continue;
    const PointId p = patch.points()[k];
    const RationalPoint x = surface.points[p];
    std::optional<Rational> squared;
    for (std::size_t f = 0; f < depths.size(); ++f) {
      if (depths[f](near.points[p.index()]) > least[k] + 2 * NearDepth::kError) continue;
      const Rational value = hull.planes[f](x);
      const auto& n = hull.planes[f].normal();
      Rational distance = value * value / Rational(dot(n, n));
      if (!squared || distance < *squared) squared = std::move(distance);
    }
    found = std::max(found, *squared);
  }
  return found;
}

}  // namespace convexact
