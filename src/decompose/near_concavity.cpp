// SPDX-License-Identifier: MIT
#include "decompose/near_concavity.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "convexact/geometry.hpp"
#include "number/arithmetic.hpp"
#include "number/roundoff.hpp"
#include "surface/flat_polygon.hpp"

namespace convexact {
namespace {

/// Below this share of the largest coordinate, whether a ray has length 0 is asked exactly.
constexpr double kMaybeZero = 0x1p-30;
/// Fractions below this exponent lose digits as doubles: nothing is bounded then. Coordinates are
/// below 1 here, so that such an error says nothing of them.
constexpr long kLeastExponent = -900;
constexpr double kAnywhere = 2;
/// Below this one an upper bound is as good as the errors of doubles allow, whatever its planes.
constexpr double kAsRounding = 0x1p-46;

bool are_coplanar(const PointSet& points, const std::array<PointId, 4>& p) {
  if (!points.is_binary()) {
    const RationalPoint a = points[p[0]], b = points[p[1]], c = points[p[2]];
    return Halfspace::through(a, b, c)(points[p[3]]) == 0;
  }
  const auto at = [&](std::size_t k) { return points.doubles()[p[k].index()]; };
  return orient3d(at(0), at(1), at(2), at(3)) == Sign::Zero;
}

}  // namespace

NearConcavity::NearConcavity(const Surface& surface, ConcavityMeasure measure, bool is_float)
    : surface_(&surface), measure_(measure), is_float_(is_float), exact_(surface, measure) {
  double most = 0;
  for (const Point& p : surface.points.doubles()) most = std::max(most, p.cwiseAbs().maxCoeff());
  exponent_ = exponent_of(most);
  if (!surface.points.is_binary()) {
    off_ = exponent_ < kLeastExponent ? kAnywhere : kUnitRoundoff;
  }
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
  const auto direction_at = [&](const NearNormal& near, std::uint32_t t, int k) {
    const bool exists = near.value.cwiseAbs().maxCoeff() > near.error ||
                        !exact_.direction(TriangleId(t), k).isZero();
    return direction_of(near.value, near.error, exists);
  };
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
    const auto& [a, b, c] = surface.triangles[t];
    const NearNormal normal =
        near_normal(points_[a.index()], points_[b.index()], points_[c.index()], off_);
    if (!at_points) {
      directions_.push_back(direction_at(normal, t, 0));
      continue;
    }
    for (const PointId p : surface.triangles[t]) {
      NearNormal& sum = sums[p.index()];
      sum.value += normal.value;
      sum.error += normal.error + kUnitRoundoff * sum.value.cwiseAbs().maxCoeff();
    }
  }
  if (!at_points) return;
  directions_.resize(points_.size());
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const std::size_t p = surface.triangles[t][static_cast<std::size_t>(k)].index();
      directions_[p] = direction_at(sums[p], t, k);
    }
  }
}

NearConcavity::Corners NearConcavity::corners_of(std::uint32_t item) const {
  if (measure_ == ConcavityMeasure::Vertices) return {{PointId(item)}, 1};
  return {surface_->triangles[item], 3};
}

NearCluster NearConcavity::cluster(std::span<const TriangleId> triangles) const {
  NearCluster cluster = without_bounds(triangles);
  bound_rays(cluster, FacetsAtPoints(cluster.extreme, cluster.facets), kNoBound);
  return cluster;
}

bool NearConcavity::is_within(std::span<const TriangleId> triangles,
                              const LengthBounds& limit) const {
  constexpr std::size_t kSome = 64;
  NearCluster cluster = without_bounds(triangles);
  const FacetsAtPoints at_points(cluster.extreme, cluster.facets);
  NearCluster some{
      .extreme = cluster.extreme, .facets = cluster.facets, .rays = {}, .concavity = {}};
  const std::size_t stride = cluster.rays.size() / kSome + 1;
  for (std::size_t k = 0; k < cluster.rays.size(); k += stride) {
    some.rays.push_back(cluster.rays[k]);
  }
  bound_rays(some, at_points, limit.high);
  if (some.concavity.low > limit.high) return false;
  cluster.concavity.low = some.concavity.low;
  bound_rays(cluster, at_points, limit.high);
  return cluster.concavity.high <= limit.low;
}

// Hull and rays.
NearCluster NearConcavity::without_bounds(std::span<const TriangleId> triangles) const {
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
  std::tie(cluster.extreme, cluster.facets) =
      near_hull_of(surface_->points, points, points_, off_, is_float_);
  return cluster;
}

NearCluster NearConcavity::unite(const NearCluster& a, const NearCluster& b, double limit) const {
  NearCluster both;
  std::vector<PointId> points;
  points.reserve(a.extreme.size() + b.extreme.size());
  std::set_union(a.extreme.begin(), a.extreme.end(), b.extreme.begin(), b.extreme.end(),
                 std::back_inserter(points));
  std::tie(both.extreme, both.facets) =
      near_hull_of(surface_->points, points, points_, off_, is_float_);
  const FacetsAtPoints at_points(both.extreme, both.facets);
  const auto same_a = at_points.same_planes(a.facets);
  const auto same_b = at_points.same_planes(b.facets);
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
  bound_rays(both, at_points, limit);
  return both;
}

// A plane of the hull that holds the corners of a ray's item, so that the ray leaves at once: the
// one that bounds it, or one at a corner.
void NearConcavity::look_for_plane_of(const NearFacets& facets, const FacetsAtPoints& at_points,
                                      RayBound& ray) const {
  const Corners corners = corners_of(ray.item);
  const Direction& direction = directions_[ray.item];
  const auto holds = [&](std::int32_t h) {
    const NearFacets::Plane& plane = facets.planes[static_cast<std::size_t>(h)];
    if (!plane.along(direction.unit, direction.error).surely_positive()) return false;
    const auto& of = facets.corners[static_cast<std::size_t>(h)];
    return std::all_of(corners.begin(), corners.end(), [&](PointId p) {
      if (p == of[0] || p == of[1] || p == of[2]) return true;
      return plane.depth(points_[p.index()] - facets.origin) <= plane.depth_error &&
             are_coplanar(surface_->points, {of[0], of[1], of[2], p});
    });
  };
  const auto take = [&](std::int32_t h) {
    if (!holds(h)) return false;
    ray = {.item = ray.item, .planes = {h, -1, -1}, .high = 0};
    return true;
  };
  if (take(ray.planes[0])) return;
  for (const PointId p : corners) {
    for (const std::int32_t h : at_points.at(p)) {
      if (take(h)) return;
    }
  }
}

// A ray leaves a flat hull at once, unless it runs along it.
void NearConcavity::bound_flat_rays(NearCluster& cluster) const {
  const std::size_t n = cluster.extreme.size();
  const auto corner = [&](std::size_t k) { return points_[cluster.extreme[k * n / 3].index()]; };
  const NearNormal normal =
      n < 3 ? NearNormal{Point::Zero(), 1} : near_normal(corner(0), corner(1), corner(2), off_);
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

// No search makes the lower bound positive, nor the upper one much smaller.
bool NearConcavity::is_as_good_as_errors(const RayBound& ray) const {
  return !is_float_ && (ray.high <= kAsRounding || (ray.is_rounding && ray.high <= kMaybeZero));
}

void NearConcavity::bound_rays(NearCluster& cluster, const FacetsAtPoints& at_points,
                               double limit) const {
  if (cluster.facets.planes.empty()) return bound_flat_rays(cluster);
  NearRays rays(cluster.facets);
  std::vector<Point> corners;
  const auto go_on_with = [&](const RayBound& ray) {
    corners.clear();
    for (const PointId p : corners_of(ray.item)) corners.push_back(points_[p.index()]);
    const Direction& direction = directions_[ray.item];
    rays.assign(corners, direction.unit, direction.error);
  };
  std::vector<std::uint32_t> longer;  // rays that may be longer than the known bound
  LengthBounds& found = cluster.concavity;
  for (std::uint32_t k = 0; k < cluster.rays.size(); ++k) {
    RayBound& ray = cluster.rays[k];
    if (std::isinf(ray.high)) {
      // In a nearly convex cluster rays leave beside their own points.
      go_on_with(ray);
      for (const PointId p : corners_of(ray.item)) rays.bound_by(at_points.at(p), ray);
      // A ray that is certain to be shorter than the longest one stays so.
      if (ray.high < found.low) continue;
      if (!is_as_good_as_errors(ray)) rays.bound_quickly(ray);
      if (ray.high <= kMaybeZero && !is_float_) look_for_plane_of(cluster.facets, at_points, ray);
    }
    if (ray.high > found.low) longer.push_back(k);
  }
  const auto by_bound = [&](std::uint32_t a, std::uint32_t b) {
    const double x = cluster.rays[a].high, y = cluster.rays[b].high;
    return x > y || (x == y && a < b);
  };
  std::sort(longer.begin(), longer.end(), by_bound);
  for (const std::uint32_t k : longer) {
    RayBound& ray = cluster.rays[k];
    if (ray.high <= found.low) break;
    if (is_as_good_as_errors(ray)) continue;
    go_on_with(ray);
    const double low = rays.bound_tightly(ray, found.low);
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
  const double rounding = 4 * kUnitRoundoff * near.cwiseAbs().maxCoeff() + kLostToUnderflow;
  near -= facets.origin;
  const auto planes = static_cast<std::int32_t>(facets.planes.size());
  for (std::int32_t h = 0; h < planes; ++h) {
    const NearFacets::Plane& plane = facets.planes[static_cast<std::size_t>(h)];
    if (!is_float_ && plane.depth(near) > 2 * plane.depth_error + plane.size * rounding) continue;
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
    bool may_be_longest = false, is_bounded = true;
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
