// SPDX-License-Identifier: MIT
#include "decompose/near_concavity.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "convexact/predicates.hpp"
#include "decompose/near_rays.hpp"
#include "number/arithmetic.hpp"
#include "number/roundoff.hpp"
#include "surface/flat_polygon.hpp"

namespace convexact {
namespace {

/// More than the total loss by numbers that are too small for doubles.
constexpr double kTiny = 1e-290;
/// Below this share of the largest coordinate, an exact test decides whether a ray has length 0.
constexpr double kMaybeZero = 0x1p-30;

double largest(const Point& v) { return v.cwiseAbs().maxCoeff(); }

struct NearNormal {
  Point value;
  double error;  // of each component
};

// (b - a) x (c - a). An edge's component has a relative error of u, a product of two of them 3u,
// and the difference of two products is rounded once more: 2 * 3u + 2u times the largest
// components.
NearNormal normal_of(const Point& a, const Point& b, const Point& c) {
  const Point e = b - a, f = c - a;
  return {e.cross(f), 10 * kUnitRoundoff * largest(e) * largest(f) + kTiny};
}

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
                       bool is_float) {
  NearFacets near;
  near.origin = points[extreme.front().index()];
  double radius = 0;
  for (const PointId v : extreme) {
    radius = std::max(radius, largest(points[v.index()] - near.origin));
  }
  near.planes.reserve(corners.size());
  for (const auto& [a, b, c] : corners) {
    const NearNormal normal = normal_of(points[a.index()], points[b.index()], points[c.index()]);
    const Point local = points[a.index()] - near.origin;
    const double size = normal.value.cwiseAbs().sum();
    // n.(a - x) for coordinates up to `radius`: 2 * 3 * radius * error from the normal; each of
    // both points is within 10u radius, and the two products and their difference are rounded, 8u
    // each.
    const double depth_error =
        7 * radius * normal.error + 40 * kUnitRoundoff * size * radius + kTiny;
    near.planes.push_back({normal.value[0], normal.value[1], normal.value[2],
                           normal.value.dot(local), is_float ? 0 : depth_error,
                           is_float ? 0 : normal.error, size});
  }
  near.corners = std::move(corners);
  return near;
}

// Which planes of a hull are planes of another one as well.
std::vector<std::int32_t> same_planes(const NearFacets& from, const NearFacets& to) {
  std::map<std::array<PointId, 3>, std::int32_t> found;
  for (std::size_t h = 0; h < to.corners.size(); ++h) {
    found.emplace(to.corners[h], static_cast<std::int32_t>(h));
  }
  std::vector<std::int32_t> same(from.corners.size(), -1);
  for (std::size_t h = 0; h < from.corners.size(); ++h) {
    if (const auto it = found.find(from.corners[h]); it != found.end()) same[h] = it->second;
  }
  return same;
}

// The bound still holds if its planes are planes of the larger hull.
RayBound moved(RayBound ray, const std::vector<std::int32_t>& same) {
  bool holds = ray.planes[0] >= 0 || ray.planes[1] >= 0 || ray.planes[2] >= 0;
  for (std::int32_t& plane : ray.planes) {
    if (plane < 0) continue;
    plane = same[static_cast<std::size_t>(plane)];
    holds = holds && plane >= 0;
  }
  return holds ? ray : RayBound{.item = ray.item};
}

}  // namespace

NearConcavity::NearConcavity(const Surface& surface, ConcavityMeasure measure, bool is_float)
    : surface_(&surface),
      measure_(measure),
      is_float_(is_float),
      is_exact_input_(surface.points.is_binary()),
      exact_(surface, measure) {
  double most = 0;
  for (const Point& p : surface.points.doubles()) most = std::max(most, largest(p));
  exponent_ = exponent_of(most);
  for (const Point& p : surface.points.doubles()) {
    points_.push_back(
        p.unaryExpr([&](double x) { return std::ldexp(x, static_cast<int>(-exponent_)); }));
  }
  add_directions(surface);
}

NearConcavity::Direction NearConcavity::direction_of(const Point& normal, double error,
                                                     bool exists) const {
  const double length = normal.norm();
  Direction direction{.exists = exists};
  if (!exists) return direction;
  // A length with a relatively large error gives no direction; this is marked by an error of 2.
  direction.error = length > 8 * error ? 4 * error / length + 8 * kUnitRoundoff : 2;
  if (length > 0) direction.unit = normal / length;
  if (is_float_) direction.error = 0;
  return direction;
}

void NearConcavity::add_directions(const Surface& surface) {
  const bool at_points = measure_ == ConcavityMeasure::Vertices;
  std::vector<NearNormal> sums(at_points ? points_.size() : 0, {Point::Zero(), 0});
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
    const auto& [a, b, c] = surface.triangles[t];
    const NearNormal normal = normal_of(points_[a.index()], points_[b.index()], points_[c.index()]);
    if (!at_points) {
      directions_.push_back(
          direction_of(normal.value, normal.error, !exact_.direction(TriangleId(t), 0).isZero()));
      continue;
    }
    for (const PointId p : surface.triangles[t]) {
      NearNormal& sum = sums[p.index()];
      sum.value += normal.value;
      sum.error += normal.error + kUnitRoundoff * largest(sum.value);
    }
  }
  if (!at_points) return;
  directions_.resize(points_.size());
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const std::size_t p = surface.triangles[t][static_cast<std::size_t>(k)].index();
      directions_[p] =
          direction_of(sums[p].value, sums[p].error, !exact_.direction(TriangleId(t), k).isZero());
    }
  }
}

std::vector<PointId> NearConcavity::corners_of(std::uint32_t item) const {
  if (measure_ == ConcavityMeasure::Vertices) return {PointId(item)};
  const auto& triangle = surface_->triangles[item];
  return {triangle.begin(), triangle.end()};
}

void NearConcavity::find_hull(NearCluster& cluster, const std::vector<PointId>& points) const {
  cluster.extreme = points;
  if (points.size() <= 2) return;
  if (points.size() == 3) {
    // Ids are in lexicographic order: of points on a line the ends come first and last.
    if (has_no_area(surface_->points, {points[0], points[1], points[2]})) {
      cluster.extreme = {points[0], points[2]};
    }
    return;
  }
  if (points.size() == 4 && is_exact_input_) {
    const auto at = surface_->points.doubles();
    const Sign side = orient3d(at[points[0].index()], at[points[1].index()], at[points[2].index()],
                               at[points[3].index()]);
    if (side != Sign::Zero) {
      cluster.facets = near_facets(corners_of_tetrahedron(points, side == Sign::Negative), points,
                                   points_, is_float_);
      return;
    }
  }
  const HullOutcome hull = convex_hull(subset(surface_->points, points));
  if (const auto* solid = std::get_if<Hull>(&hull)) {
    cluster.extreme.clear();
    for (const PointId v : solid->vertices) cluster.extreme.push_back(points[v.index()]);
    cluster.facets =
        near_facets(corners_of_facets(*solid, points), cluster.extreme, points_, is_float_);
  } else {
    cluster.extreme = flat_extreme(surface_->points, points, std::get<FlatInput>(hull));
  }
}

NearCluster NearConcavity::cluster(std::span<const TriangleId> triangles) const {
  NearCluster cluster;
  const std::vector<PointId> points = convexact::points_of(*surface_, triangles);
  const auto add = [&](std::uint32_t item) {
    if (directions_[item].exists) cluster.rays.push_back({.item = item});
  };
  if (measure_ == ConcavityMeasure::Vertices) {
    for (const PointId p : points) add(p.value);
  } else {
    for (const TriangleId t : triangles) add(t.value);
  }
  find_hull(cluster, points);
  bound_rays(cluster, kNoBound);
  return cluster;
}

NearCluster NearConcavity::unite(const NearCluster& a, const NearCluster& b, double limit) const {
  NearCluster both;
  std::vector<PointId> points;
  std::set_union(a.extreme.begin(), a.extreme.end(), b.extreme.begin(), b.extreme.end(),
                 std::back_inserter(points));
  find_hull(both, points);
  const auto same_a = same_planes(a.facets, both.facets);
  const auto same_b = same_planes(b.facets, both.facets);
  both.rays.reserve(a.rays.size() + b.rays.size());
  auto x = a.rays.begin(), y = b.rays.begin();
  while (x != a.rays.end() || y != b.rays.end()) {
    if (y == b.rays.end() || (x != a.rays.end() && x->item < y->item)) {
      both.rays.push_back(moved(*x++, same_a));
    } else if (x == a.rays.end() || y->item < x->item) {
      both.rays.push_back(moved(*y++, same_b));
    } else {  // a point of both
      const RayBound one = moved(*x++, same_a), other = moved(*y++, same_b);
      both.rays.push_back(one.high < other.high ? one : other);
    }
  }
  // Concavity never falls when a cluster grows.
  both.concavity.low = std::max(a.concavity.low, b.concavity.low);
  bound_rays(both, limit);
  return both;
}

// A plane of the hull that holds the corners of a ray's item, so that the ray leaves at once: first
// of all the one that bounds it.
void NearConcavity::look_for_plane_of(const NearFacets& facets, RayBound& ray) const {
  const auto points = surface_->points.doubles();
  const std::vector<PointId> corners = corners_of(ray.item);
  const Direction& direction = directions_[ray.item];
  const auto holds = [&](std::int32_t h) {
    const NearFacets::Plane& plane = facets.planes[static_cast<std::size_t>(h)];
    const Point normal(plane.x, plane.y, plane.z);
    if (normal.dot(direction.unit) <=
        plane.size * (direction.error + 8 * kUnitRoundoff) + 4 * plane.normal_error) {
      return false;
    }
    const auto& of = facets.corners[static_cast<std::size_t>(h)];
    return std::all_of(corners.begin(), corners.end(), [&](PointId p) {
      if (p == of[0] || p == of[1] || p == of[2]) return true;
      const double depth = plane.d - normal.dot(points_[p.index()] - facets.origin);
      return depth <= plane.depth_error &&
             orient3d(points[of[0].index()], points[of[1].index()], points[of[2].index()],
                      points[p.index()]) == Sign::Zero;
    });
  };
  const auto planes = static_cast<std::int32_t>(facets.planes.size());
  std::int32_t found = ray.planes[0];
  if (!holds(found)) {
    for (found = 0; found < planes && !holds(found); ++found) {
    }
  }
  if (found < planes) ray = {.item = ray.item, .planes = {found, -1, -1}, .high = 0};
}

// A ray leaves a flat hull at once, unless it runs along it.
void NearConcavity::bound_flat_rays(NearCluster& cluster) const {
  const std::size_t n = cluster.extreme.size();
  const auto corner = [&](std::size_t k) { return points_[cluster.extreme[k * n / 3].index()]; };
  const NearNormal normal =
      n < 3 ? NearNormal{Point::Zero(), 1} : normal_of(corner(0), corner(1), corner(2));
  double high = 0;
  for (RayBound& ray : cluster.rays) {
    const Direction& direction = directions_[ray.item];
    const double across = std::abs(direction.unit.dot(normal.value));
    const double error =
        4 * normal.error + normal.value.cwiseAbs().sum() * (direction.error + 8 * kUnitRoundoff);
    const bool leaves = measure_ == ConcavityMeasure::Surface || across > error;
    if (leaves) ray.high = 0;
    high = std::max(high, ray.high);
  }
  cluster.concavity.high = high;
}

void NearConcavity::bound_rays(NearCluster& cluster, double limit) const {
  if (!is_exact_input_) return;
  if (cluster.facets.planes.empty()) return bound_flat_rays(cluster);
  std::vector<Point> corners;
  const auto rays_of = [&](const RayBound& ray) {
    corners.clear();
    for (const PointId p : corners_of(ray.item)) corners.push_back(points_[p.index()]);
    const Direction& direction = directions_[ray.item];
    return NearRays(cluster.facets, corners, direction.unit, direction.error);
  };
  std::vector<std::uint32_t> longer;  // rays that may be longer than the known bound
  LengthBounds& found = cluster.concavity;
  for (std::uint32_t k = 0; k < cluster.rays.size(); ++k) {
    RayBound& ray = cluster.rays[k];
    if (std::isinf(ray.high)) {
      rays_of(ray).bound_quickly(ray);
      if (ray.high <= kMaybeZero && !is_float_) look_for_plane_of(cluster.facets, ray);
    }
    if (ray.high > found.low) longer.push_back(k);
  }
  const auto by_bound = [&](std::uint32_t a, std::uint32_t b) {
    return cluster.rays[a].high > cluster.rays[b].high;
  };
  std::sort(longer.begin(), longer.end(), by_bound);
  for (const std::uint32_t k : longer) {
    RayBound& ray = cluster.rays[k];
    if (ray.high <= found.low) break;
    const double low = rays_of(ray).bound_tightly(ray, found.low);
    found.low = std::max(found.low, is_float_ ? ray.high : low);
    if (found.low > limit) return;
  }
  found.high = found.low;
  for (const RayBound& ray : cluster.rays) found.high = std::max(found.high, ray.high);
  if (is_float_) found.high = found.low;
}

// A plane of the hull that the point is beyond, if there is one.
std::optional<std::int32_t> NearConcavity::plane_behind(const NearFacets& facets,
                                                        const RationalPoint& x) const {
  Point near;
  for (int k = 0; k < 3; ++k) {
    near[k] = std::ldexp(to_double(x[k], Rounding::Nearest), static_cast<int>(-exponent_));
  }
  const double rounding = 4 * kUnitRoundoff * largest(near) + kTiny;
  near -= facets.origin;
  const auto planes = static_cast<std::int32_t>(facets.planes.size());
  for (std::int32_t h = 0; h < planes; ++h) {
    const NearFacets::Plane& plane = facets.planes[static_cast<std::size_t>(h)];
    const double depth = plane.d - (plane.x * near[0] + plane.y * near[1] + plane.z * near[2]);
    if (!is_float_ && depth > 2 * plane.depth_error + plane.size * rounding) continue;
    if (exact_plane(facets, h)(x) > 0) return h;
  }
  return std::nullopt;
}

Halfspace NearConcavity::exact_plane(const NearFacets& facets, std::int32_t plane) const {
  const auto& [a, b, c] = facets.corners[static_cast<std::size_t>(plane)];
  return surface_->points.is_binary()
             ? Halfspace::through(surface_->points.doubles()[a.index()],
                                  surface_->points.doubles()[b.index()],
                                  surface_->points.doubles()[c.index()])
             : Halfspace::through(surface_->points[a], surface_->points[b], surface_->points[c]);
}

// Uses the planes that bound its rays, and those that the rays are then found to pass through;
// nothing if one of these planes shows that all rays are shorter than the longest one so far.
std::optional<Concavity> NearConcavity::exact(const NearFacets& facets, TriangleId triangle,
                                              std::span<RayBound* const> rays,
                                              const std::optional<Concavity>& longest) const {
  ConvexPart some;
  std::vector<std::int32_t> used;
  for (const RayBound* ray : rays) {
    for (const std::int32_t plane : ray->planes) {
      if (plane >= 0) used.push_back(plane);
    }
  }
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  for (const std::int32_t plane : used) some.halfspaces.push_back(exact_plane(facets, plane));
  if (longest && measure_ == ConcavityMeasure::Surface &&
      exact_.is_no_longer(triangle, some, longest->squared)) {
    return std::nullopt;
  }
  for (;;) {
    // With only some of the planes, rays are at least as long; so the longest one is right if it
    // fits.
    Concavity found = exact_(triangle, some);
    if (const auto behind = plane_behind(facets, found.leaves)) {
      used.push_back(*behind);
      some.halfspaces.push_back(exact_plane(facets, *behind));
      continue;
    }
    if (rays.size() == 1 && used.size() <= 3) {
      // Other unions get it as exactly as a double can hold it.
      RayBound& ray = *rays.front();
      ray.high = std::min(ray.high, root_bounds(found.squared).high);
      ray.planes.fill(-1);
      std::copy(used.begin(), used.end(), ray.planes.begin());
    }
    return found;
  }
}

LengthBounds NearConcavity::root_bounds(const Rational& squared) const {
  const Enclosure root = sqrt(Enclosure(scale_by_power_of_two(squared, -2 * exponent_), 64));
  return {root.low_double(), root.high_double()};
}

Rational NearConcavity::squared(NearCluster& cluster, std::span<const TriangleId> triangles,
                                const Watch& watch) const {
  return cluster.concavity.high == 0 ? Rational(0) : exact(cluster, triangles, watch).squared;
}

Concavity NearConcavity::exact(NearCluster& cluster, std::span<const TriangleId> triangles,
                               const Watch& watch) const {
  std::optional<ConvexPart> hull;
  std::optional<Concavity> largest;
  std::vector<RayBound*> rays;
  for (const TriangleId t : triangles) {
    watch.ask();
    rays.clear();
    bool may_be_longest = false, is_bounded = is_exact_input_;
    const auto add = [&](std::uint32_t item) {
      const auto ray = std::lower_bound(
          cluster.rays.begin(), cluster.rays.end(), item,
          [](const RayBound& each, std::uint32_t name) { return each.item < name; });
      if (ray == cluster.rays.end() || ray->item != item) return;
      rays.push_back(&*ray);
      may_be_longest = may_be_longest || ray->high >= cluster.concavity.low;
      is_bounded = is_bounded && ray->planes != RayBound{}.planes;
    };
    if (measure_ == ConcavityMeasure::Surface) {
      add(t.value);
    } else {
      for (const PointId p : surface_->triangles[t.index()]) add(p.value);
    }
    if (largest && !may_be_longest) continue;
    if (!is_bounded && !hull) hull = convex_part(subset(surface_->points, cluster.extreme));
    const auto found = is_bounded ? exact(cluster.facets, t, rays, largest) : exact_(t, *hull);
    if (found && (!largest || found->squared > largest->squared)) largest = found;
    if (cluster.concavity.high == 0) break;
  }
  cluster.concavity = root_bounds(largest->squared);
  return std::move(*largest);
}

}  // namespace convexact
