// SPDX-License-Identifier: MIT
#include "proof/hull_rays.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "convexact/cluster.hpp"
#include "convexact/hull.hpp"
#include "convexact/linear_program.hpp"
#include "convexact/overlay.hpp"
#include "near/near_plane.hpp"
#include "number/arithmetic.hpp"

namespace convexact {
namespace {

ClusterPlane cluster_plane(const Halfspace& plane, const Point& on_it) {
  const Point normal = unit_vector(plane.normal());
  return {normal, -normal.dot(on_it)};
}

}  // namespace

ClusterHull hull_of_cluster(const Surface& surface, std::span<const TriangleId> triangles) {
  ClusterHull made;
  made.points = points_of(surface, triangles);
  const PointSet points = subset(surface.points, made.points);
  const auto near = surface.points.doubles();
  const HullOutcome outcome = convex_hull(points);
  if (const auto* hull = std::get_if<Hull>(&outcome)) {
    made.planes = facet_halfspaces(*hull, points);
    for (std::size_t f = 0; f < hull->facets.size(); ++f) {
      std::vector<PointId> corners;
      for (const PointId p : hull->facets[f]) corners.push_back(made.points[p.index()]);
      made.number.push_back(made.facets.size());
      for (std::size_t k = 2; k < corners.size(); ++k) {
        made.facets.push_back({corners[0], corners[k - 1], corners[k]});
      }
      made.near.push_back(cluster_plane(made.planes[f], near[corners[0].index()]));
      made.corners.push_back(std::move(corners));
    }
    return made;
  }
  made.planes = convex_part(points).halfspaces;
  for (std::size_t f = 0; f < made.planes.size(); ++f) {
    made.number.push_back(f);
    made.corners.push_back(made.points);
    // Only the values of its planes at the points count, so any point near the plane can be used.
    const auto on_it = std::find_if(made.points.begin(), made.points.end(), [&](PointId p) {
      return made.planes[f](surface.points[p]) == 0;
    });
    made.near.push_back(cluster_plane(made.planes[f], near[on_it->index()]));
  }
  return made;
}

// The length of a ray as the plane cuts it, in doubles; infinity if it runs away from the plane.
double HullRays::near_length(const RaySource& source, std::size_t plane, const Point& from) const {
  const ClusterPlane& near = hull_.near[plane];
  const double speed = near.normal.dot(source.near_direction);
  constexpr double kLeastSpeed = 1e-12;  // of unit vectors; below it are roundings
  if (!(speed > kLeastSpeed)) return std::numeric_limits<double>::infinity();
  return -(near.normal.dot(from) + near.offset) / speed;
}

std::pair<std::size_t, double> HullRays::near_exit(const RaySource& source,
                                                   const Point& from) const {
  std::pair<std::size_t, double> first{0, std::numeric_limits<double>::infinity()};
  for (std::size_t h = 0; h < hull_.planes.size(); ++h) {
    const double length = near_length(source, h, from);
    if (length < first.second) first = {h, length};
  }
  return first;
}

std::pair<std::size_t, double> HullRays::near_bound(const RaySource& source) const {
  std::pair<std::size_t, double> best{0, std::numeric_limits<double>::infinity()};
  for (std::size_t h = 0; h < hull_.planes.size(); ++h) {
    double longest = 0;
    for (const PointId p : source.corners) {
      longest = std::max(longest, near_length(source, h, near_point(p)));
    }
    if (longest < best.second) best = {h, longest};
  }
  return best;
}

RationalPoint HullRays::point(const RaySource& source, const HullRay& ray) const {
  RationalPoint a = surface_.points[source.corners[0]];
  if (source.corners.size() == 1) return a;
  return a + ray.u * (surface_.points[source.corners[1]] - a) +
         ray.w * (surface_.points[source.corners[2]] - a);
}

RationalPoint HullRays::end(const RaySource& source, const HullRay& ray) const {
  return point(source, ray) + ray.length * source.direction.cast<Rational>();
}

HullRay HullRays::leave(const RaySource& source, HullRay ray) const {
  const RationalPoint from = point(source, ray);
  std::optional<Rational> least;
  for (std::size_t h = 0; h < hull_.planes.size(); ++h) {
    const Integer speed = dot(hull_.planes[h].normal(), source.direction);
    if (speed <= 0) continue;
    Rational length = -hull_.planes[h](from) / Rational(speed);
    if (least && *least <= length) continue;
    least = std::move(length);
    ray.plane = h;
  }
  ray.length = least.value_or(Rational(0));
  return ray;
}

bool HullRays::is_bound(const RaySource& source, const RationalVector3& n, const Rational& d,
                        const Rational& squared_limit) const {
  const Rational speed = n.dot(source.direction.cast<Rational>());
  if (speed <= 0) return false;
  return std::all_of(source.corners.begin(), source.corners.end(), [&](PointId p) {
    const Rational length = (n.dot(surface_.points[p]) + d) / speed;
    return length * length * source.squared_length <= squared_limit;
  });
}

bool HullRays::is_bound(const RaySource& source, std::size_t plane,
                        const Rational& squared_limit) const {
  const Halfspace& h = hull_.planes[plane];
  return is_bound(source, h.normal().cast<Rational>(), Rational(h.offset()), squared_limit);
}

bool HullRays::is_bound(const RaySource& source, const PlaneSum& combination,
                        const Rational& squared_limit) const {
  RationalVector3 n = RationalVector3::Zero();
  Rational d = 0;
  for (const auto& [plane, factor] : combination) {
    n += factor * hull_.planes[plane].normal().cast<Rational>();
    d += factor * Rational(hull_.planes[plane].offset());
  }
  return is_bound(source, n, d, squared_limit);
}

// A linear program in u, w and the length. Among the planes that it does not have yet, the one that
// the ray passes farthest is added, until the ray passes none.
HullRays::Longest HullRays::longest(const RaySource& source, const Rational& squared_limit) const {
  const RationalPoint a = surface_.points[source.corners[0]],
                      b = surface_.points[source.corners[1]],
                      c = surface_.points[source.corners[2]];
  std::vector<std::size_t> planes{leave(source, {Rational(1, 3), Rational(1, 3)}).plane};
  for (;;) {
    const auto rows = static_cast<Eigen::Index>(planes.size());
    LinearProgram lp{RationalMatrix::Zero(rows + 3, 3), RationalVector::Zero(rows + 3),
                     RationalVector::Zero(3)};
    for (Eigen::Index k = 0; k < rows; ++k) {
      const Halfspace& plane = hull_.planes[planes[static_cast<std::size_t>(k)]];
      const Rational at_a = plane(a);
      lp.normals(k, 0) = plane(b) - at_a;
      lp.normals(k, 1) = plane(c) - at_a;
      lp.normals(k, 2) = Rational(dot(plane.normal(), source.direction));
      lp.offsets[k] = at_a;
    }
    lp.normals(rows, 0) = -1;      // u >= 0
    lp.normals(rows + 1, 1) = -1;  // w >= 0
    lp.normals(rows + 2, 0) = lp.normals(rows + 2, 1) = 1;
    lp.offsets[rows + 2] = -1;  // u + w <= 1
    lp.objective[2] = 1;
    const Optimal best = std::get<Optimal>(maximise(lp));
    Longest found{{best.x[0], best.x[1], best.x[2]}, false, {}};
    for (const auto& [row, factor] : best.tight) {
      if (row < planes.size()) found.bound.emplace_back(planes[row], factor);
    }
    found.is_within = best.x[2] * best.x[2] * source.squared_length <= squared_limit;
    if (found.is_within) return found;
    const HullRay exact = leave(source, found.ray);
    if (exact.length == found.ray.length) {
      found.ray.plane = exact.plane;
      return found;
    }
    planes.push_back(exact.plane);
  }
}

}  // namespace convexact
