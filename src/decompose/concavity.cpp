// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>

#include "convexact/cluster.hpp"
#include "number/arithmetic.hpp"
#include "surface/flat_polygon.hpp"

namespace convexact {
namespace {

// A multiple of v in coprime integers; 0 stays 0.
IntegerVector3 integer_direction(const RationalVector3& v) {
  return v.isZero() ? IntegerVector3(IntegerVector3::Zero())
                    : primitive_direction(clear_denominators(v).x);
}

using Ray = std::pair<Rational, IntegerVector3>;  // its length in multiples of its direction

Rational squared_length(const Ray& ray) {
  return ray.first * ray.first * Rational(ray.second.dot(ray.second));
}

// -(n.M + d), at least 0 of a point of the hull.
Rational depth(const Halfspace& plane, const RationalPoint& point) { return -plane(point); }

// The ray from a point of the hull leaves it at the first plane that it runs towards.
Rational length_of_ray(const ConvexPart& hull, const RationalPoint& from,
                       const IntegerVector3& direction) {
  std::optional<Rational> least;
  for (const Halfspace& plane : hull.halfspaces) {
    const Integer speed = plane.normal().dot(direction);
    if (speed <= 0) continue;
    Rational t = depth(plane, from) / Rational(speed);
    if (!least || t < *least) least = std::move(t);
  }
  return least.value_or(Rational(0));
}

// The longest ray from a point a + u (b - a) + w (c - a) of a triangle: at most t as each plane
// allows it, which is a linear program in u, w and t.
Optimal longest_ray(const ConvexPart& hull, const std::array<RationalPoint, 3>& corners,
                    const IntegerVector3& direction) {
  const auto& [a, b, c] = corners;
  std::vector<const Halfspace*> ahead;
  for (const Halfspace& plane : hull.halfspaces) {
    if (plane.normal().dot(direction) > 0) ahead.push_back(&plane);
  }
  const auto rows = static_cast<Eigen::Index>(ahead.size());
  LinearProgram lp{RationalMatrix::Zero(rows + 3, 3), RationalVector::Zero(rows + 3),
                   RationalVector::Zero(3)};
  for (Eigen::Index k = 0; k < rows; ++k) {
    const Halfspace& plane = *ahead[static_cast<std::size_t>(k)];
    const Rational at_a = plane(a);
    lp.normals(k, 0) = plane(b) - at_a;
    lp.normals(k, 1) = plane(c) - at_a;
    lp.normals(k, 2) = Rational(plane.normal().dot(direction));
    lp.offsets[k] = at_a;
  }
  lp.normals(rows, 0) = -1;      // u >= 0
  lp.normals(rows + 1, 1) = -1;  // w >= 0
  lp.normals(rows + 2, 0) = lp.normals(rows + 2, 1) = 1;
  lp.offsets[rows + 2] = -1;  // u + w <= 1
  lp.objective[2] = 1;
  return std::get<Optimal>(maximise(lp));  // the hull holds the triangle and is bounded
}

}  // namespace

ExactConcavity::ExactConcavity(const Surface& surface, ConcavityMeasure measure)
    : surface_(&surface), measure_(measure) {
  std::vector<RationalVector3> at_points(
      measure == ConcavityMeasure::Vertices ? surface.points.size() : 0, RationalVector3::Zero());
  for (const auto& triangle : surface.triangles) {
    const RationalVector3 area = area_vector(surface.points, triangle);
    if (measure == ConcavityMeasure::Surface) {
      normals_.push_back(integer_direction(area));
    } else {
      for (const PointId p : triangle) at_points[p.index()] += area;
    }
  }
  for (const RationalVector3& normal : at_points) normals_.push_back(integer_direction(normal));
}

IntegerVector3 ExactConcavity::direction(TriangleId triangle, int k) const {
  return measure_ == ConcavityMeasure::Surface
             ? normals_[triangle.index()]
             : normals_[surface_->triangles[triangle.index()][static_cast<std::size_t>(k)].index()];
}

Concavity ExactConcavity::operator()(TriangleId triangle, const ConvexPart& hull) const {
  std::array<RationalPoint, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    corners[k] = surface_->points[surface_->triangles[triangle.index()][k]];
  }
  Concavity found{.triangle = triangle,
                  .at = corners[0],
                  .leaves = corners[0],
                  .normal = IntegerVector3::Zero()};
  const auto keep = [&](const RationalPoint& from, const Ray& ray, bool is_first) {
    Rational squared = squared_length(ray);
    if (!is_first && squared <= found.squared) return;
    found.squared = std::move(squared);
    found.at = from;
    found.normal = ray.second;
    found.leaves = from + ray.first * ray.second.cast<Rational>();
  };
  if (measure_ == ConcavityMeasure::Surface) {
    const IntegerVector3 normal = direction(triangle, 0);
    if (normal.isZero()) return found;
    const Optimal best = longest_ray(hull, corners, normal);
    const RationalPoint from =
        corners[0] + best.x[0] * (corners[1] - corners[0]) + best.x[1] * (corners[2] - corners[0]);
    keep(from, {best.x[2], normal}, true);
    return found;
  }
  for (int k = 0; k < 3; ++k) {
    const IntegerVector3 normal = direction(triangle, k);
    if (normal.isZero()) continue;
    const RationalPoint& from = corners[static_cast<std::size_t>(k)];
    keep(from, {length_of_ray(hull, from, normal), normal}, found.normal.isZero());
  }
  return found;
}

// The plane is the one where the ray from its centroid leaves the hull.
bool ExactConcavity::is_no_longer(TriangleId triangle, const ConvexPart& hull,
                                  const Rational& squared) const {
  const IntegerVector3 normal = direction(triangle, 0);
  if (normal.isZero()) return true;
  std::array<RationalPoint, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    corners[k] = surface_->points[surface_->triangles[triangle.index()][k]];
  }
  const RationalPoint sum = corners[0] + corners[1] + corners[2];
  const Halfspace* first = nullptr;
  Rational least, speed_there;
  for (const Halfspace& plane : hull.halfspaces) {
    const Integer speed = plane.normal().dot(normal);
    if (speed <= 0) continue;
    const RationalVector3 n = plane.normal().cast<Rational>();
    Rational t = -(n.dot(sum) + 3 * Rational(plane.offset())) / Rational(speed);
    if (first != nullptr && t >= least) continue;
    least = std::move(t);
    speed_there = Rational(speed);
    first = &plane;
  }
  Rational longest = 0;
  for (const RationalPoint& corner : corners) {
    longest = std::max<Rational>(longest, depth(*first, corner) / speed_there);
  }
  return squared_length({longest, normal}) <= squared;
}

Concavity ExactConcavity::operator()(std::span<const TriangleId> cluster, const ConvexPart& hull,
                                     const Watch& watch) const {
  std::optional<Concavity> largest;
  for (const TriangleId triangle : cluster) {
    watch.ask();
    if (largest && measure_ == ConcavityMeasure::Surface &&
        is_no_longer(triangle, hull, largest->squared)) {
      continue;
    }
    Concavity found = (*this)(triangle, hull);
    if (!largest || found.squared > largest->squared) largest = std::move(found);
  }
  return std::move(*largest);
}

std::vector<PointId> points_of(const Surface& surface, std::span<const TriangleId> cluster) {
  std::vector<PointId> points;
  for (const TriangleId triangle : cluster) {
    const auto& corners = surface.triangles[triangle.index()];
    points.insert(points.end(), corners.begin(), corners.end());
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

Rational ConcavityLimit::squared(const Rational& squared_diameter) const {
  return is_share ? Rational(value * value * squared_diameter) : Rational(value * value);
}

}  // namespace convexact
