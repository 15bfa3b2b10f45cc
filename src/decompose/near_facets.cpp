// SPDX-License-Identifier: MIT
#include "decompose/near_facets.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <variant>

#include "convexact/geometry.hpp"
#include "surface/flat_polygon.hpp"

namespace convexact {
namespace {

// The corners of the hull of points in a plane or on a line.
std::vector<PointId> flat_extreme(const PointSet& points, const std::vector<PointId>& ids,
                                  const FlatInput& flat) {
  if (flat.dimension < 2) {  // ids ascend with the points, which are in lexicographic order
    return ids.size() == 1 ? ids : std::vector<PointId>{ids.front(), ids.back()};
  }
  const IntegerVector3& normal = flat.equations.front().normal();
  const PlaneView view(points, normal[0] != 0 ? 0 : normal[1] != 0 ? 1 : 2);
  // Ids are in the order of x + e y + e^2 z, e infinitesimal: linear on the plane as well, so a
  // sweep may follow it.
  std::vector<PointId> chain;
  const auto sweep = [&](auto first, auto last) {
    const std::size_t start = chain.size();
    for (; first != last; ++first) {
      while (chain.size() >= start + 2 &&
             view.turn(chain[chain.size() - 2], chain.back(), *first) != Sign::Positive) {
        chain.pop_back();
      }
      chain.push_back(*first);
    }
    chain.pop_back();
  };
  sweep(ids.begin(), ids.end());
  sweep(ids.rbegin(), ids.rend());
  std::sort(chain.begin(), chain.end());
  return chain;
}

// Three corners of each facet, counter-clockwise from outside, far apart if there are more.
std::vector<std::array<PointId, 3>> corners_of_facets(const Hull& hull,
                                                      const std::vector<PointId>& ids) {
  std::vector<std::array<PointId, 3>> corners;
  corners.reserve(hull.facets.size());
  for (std::size_t f = 0; f < hull.facets.size(); ++f) {
    const auto cycle = hull.facets[f];
    const std::size_t n = cycle.size();
    corners.push_back(
        {ids[cycle[0].index()], ids[cycle[n / 3].index()], ids[cycle[2 * n / 3].index()]});
  }
  return corners;
}

// The same of a tetrahedron with a volume, each beginning at its lowest point.
std::vector<std::array<PointId, 3>> corners_of_tetrahedron(const std::vector<PointId>& p,
                                                           bool is_last_beyond_others) {
  std::vector<std::array<PointId, 3>> corners{
      {p[0], p[2], p[1]}, {p[0], p[1], p[3]}, {p[1], p[2], p[3]}, {p[0], p[3], p[2]}};
  if (!is_last_beyond_others) {
    for (auto& corner : corners) std::swap(corner[1], corner[2]);
  }
  return corners;
}

// The planes of facets, about the lowest point of the cluster.
NearFacets near_facets(std::vector<std::array<PointId, 3>> corners,
                       const std::vector<PointId>& extreme, std::span<const Point> points,
                       double off, bool is_float) {
  NearFacets near;
  near.origin = points[extreme.front().index()];
  double radius = 0;  // of the true points, too
  for (const PointId v : extreme) {
    radius = std::max(radius, (points[v.index()] - near.origin).cwiseAbs().maxCoeff());
  }
  radius += 2 * off;
  near.planes.reserve(corners.size());
  for (const auto& [a, b, c] : corners) {
    const NearNormal normal =
        near_normal(points[a.index()], points[b.index()], points[c.index()], off);
    const Point local = points[a.index()] - near.origin;
    const double size = normal.value.cwiseAbs().sum();
    // n.(a - x) for coordinates up to `radius`: 2 * 3 * radius * error from the normal; each of
    // both points is within 10u radius and `off`, and the two products and their difference are
    // rounded, 8u each.
    const double depth_error = 7 * radius * normal.error +
                               size * (40 * kUnitRoundoff * radius + 3 * off) + kLostToUnderflow;
    near.planes.push_back({.x = normal.value[0],
                           .y = normal.value[1],
                           .z = normal.value[2],
                           .d = normal.value.dot(local),
                           .depth_error = is_float ? 0 : depth_error,
                           .normal_error = is_float ? 0 : normal.error,
                           .size = size});
  }
  near.corners = std::move(corners);
  return near;
}

}  // namespace

// (b - a) x (c - a). An edge's component has a relative error of u, a product of two of them 3u,
// and the difference of two products is rounded once more: 2 * 3u + 2u times the largest
// components. Both ends of an edge are off: by g = 2 off, which two products change by
// 2g (E + F) + 2g^2, E and F the largest components.
NearNormal near_normal(const Point& a, const Point& b, const Point& c, double off) {
  const Point e = b - a, f = c - a;
  const double size_e = e.cwiseAbs().maxCoeff(), size_f = f.cwiseAbs().maxCoeff();
  return {e.cross(f), 10 * kUnitRoundoff * size_e * size_f + 5 * off * (size_e + size_f) +
                          10 * off * off + kLostToUnderflow};
}

std::pair<std::vector<PointId>, NearFacets> near_hull_of(const PointSet& points,
                                                         const std::vector<PointId>& ids,
                                                         std::span<const Point> near, double off,
                                                         bool is_float) {
  if (ids.size() <= 2) return {ids, {}};
  if (ids.size() == 3) {
    // Ids are in lexicographic order: of points on a line the ends come first and last.
    if (has_no_area(points, {ids[0], ids[1], ids[2]})) return {{ids[0], ids[2]}, {}};
    return {ids, {}};
  }
  if (ids.size() == 4 && points.is_binary()) {
    const auto at = points.doubles();
    const Sign side =
        orient3d(at[ids[0].index()], at[ids[1].index()], at[ids[2].index()], at[ids[3].index()]);
    if (side != Sign::Zero) {
      return {ids, near_facets(corners_of_tetrahedron(ids, side == Sign::Negative), ids, near, off,
                               is_float)};
    }
  }
  const HullOutcome hull = convex_hull(subset(points, ids));
  const auto* solid = std::get_if<Hull>(&hull);
  if (solid == nullptr) return {flat_extreme(points, ids, std::get<FlatInput>(hull)), {}};
  std::vector<PointId> extreme;
  for (const PointId v : solid->vertices) extreme.push_back(ids[v.index()]);
  NearFacets facets = near_facets(corners_of_facets(*solid, ids), extreme, near, off, is_float);
  return {std::move(extreme), std::move(facets)};
}

FacetsAtPoints::FacetsAtPoints(const std::vector<PointId>& extreme, const NearFacets& facets)
    : extreme_(extreme), facets_(facets), starts_(extreme.size() + 1, 0) {
  std::vector<std::size_t> places;
  places.reserve(3 * facets.corners.size());
  for (const auto& corners : facets.corners) {
    for (const PointId p : corners) {
      places.push_back(place_of(p));
      ++starts_[places.back()];
    }
  }
  // From the last facet to the first, each point's range is filled from its end.
  std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
  at_.resize(places.size());
  for (std::size_t k = places.size(); k-- > 0;) {
    at_[--starts_[places[k]]] = static_cast<std::int32_t>(k / 3);
  }
}

std::size_t FacetsAtPoints::place_of(PointId point) const {
  return static_cast<std::size_t>(std::lower_bound(extreme_.begin(), extreme_.end(), point) -
                                  extreme_.begin());
}

std::span<const std::int32_t> FacetsAtPoints::at(PointId point) const {
  const std::size_t place = place_of(point);
  if (place == extreme_.size() || extreme_[place] != point) return {};
  return std::span(at_).subspan(starts_[place], starts_[place + 1] - starts_[place]);
}

std::vector<std::int32_t> FacetsAtPoints::same_planes(const NearFacets& other) const {
  std::vector<std::int32_t> same(other.corners.size(), -1);
  for (std::size_t h = 0; h < other.corners.size(); ++h) {
    for (const std::int32_t own : at(other.corners[h][0])) {
      if (facets_.corners[static_cast<std::size_t>(own)] == other.corners[h]) same[h] = own;
    }
  }
  return same;
}

}  // namespace convexact
