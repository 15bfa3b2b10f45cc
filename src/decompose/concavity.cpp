// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>

#include "convexact/cluster.hpp"
#include "number/arithmetic.hpp"
#include "overlay/arrangement.hpp"
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

// The corners of a triangle over one denominator.
using Corners = std::array<HomogeneousPoint, 3>;

Corners corners_of(const Surface& surface, TriangleId triangle) {
  std::array<Rational, 9> coordinates;
  for (std::size_t k = 0; k < 3; ++k) {
    const RationalPoint corner = surface.points[surface.triangles[triangle.index()][k]];
    std::copy(corner.begin(), corner.end(), coordinates.begin() + 3 * k);
  }
  std::array<Integer, 9> x;
  const Integer w = clear_denominators(coordinates, x);
  return {{{{x[0], x[1], x[2]}, w}, {{x[3], x[4], x[5]}, w}, {{x[6], x[7], x[8]}, w}}};
}

// -(n.X + d W), at least 0 of a point X / W of the hull.
Integer depth(const Halfspace& plane, const HomogeneousPoint& point) {
  return -plane_value(plane, point);
}

// A plane that a ray runs towards, speed = n.direction > 0. From a point X / W it gets there after
// depth / (W speed) times its direction.
struct Wall {
  const Halfspace* plane;
  Integer depth, speed;

  // Of points with the same W.
  bool is_nearer(const Wall& other) const { return depth * other.speed < other.depth * speed; }
  Rational distance(const Integer& w) const { return {depth, w * speed}; }
};

// Where the ray from a point of the hull leaves it: the first plane that it gets to.
std::optional<Wall> wall_ahead(const ConvexPart& hull, const HomogeneousPoint& from,
                               const IntegerVector3& direction) {
  std::optional<Wall> first;
  for (const Halfspace& plane : hull.halfspaces) {
    Integer speed = dot(plane.normal(), direction);
    if (speed <= 0) continue;
    Wall wall{&plane, depth(plane, from), std::move(speed)};
    if (!first || wall.is_nearer(*first)) first = std::move(wall);
  }
  return first;
}

// The wall ahead of the centroid of a triangle, as far as it is from a corner: no ray from the
// triangle is longer.
Wall bounding_wall(const ConvexPart& hull, const Corners& corners,
                   const IntegerVector3& direction) {
  const auto& [a, b, c] = corners;
  Wall bound = *wall_ahead(hull, {a.n + b.n + c.n, 3 * a.w}, direction);
  bound.depth = 0;
  for (const HomogeneousPoint& corner : corners) {
    bound.depth = std::max<Integer>(bound.depth, depth(*bound.plane, corner));
  }
  return bound;
}

// The longest ray from a point a + u (b - a) + v (c - a) of a triangle: at most t as each plane
// allows it, which is a linear program in u, v and t. Planes beyond the bound are left out: they
// cut off nothing.
Optimal longest_ray(const ConvexPart& hull, const Corners& corners,
                    const IntegerVector3& direction) {
  const Wall bound = bounding_wall(hull, corners, direction);
  std::vector<std::array<Rational, 4>> rows{
      {-1, 0, 0, 0}, {0, -1, 0, 0}, {1, 1, 0, -1}};  // u >= 0, v >= 0, u + v <= 1
  for (const Halfspace& plane : hull.halfspaces) {
    const Integer speed = dot(plane.normal(), direction);
    if (speed <= 0) continue;
    std::array<Wall, 3> at;
    for (std::size_t k = 0; k < 3; ++k) at[k] = {&plane, depth(plane, corners[k]), speed};
    if (std::all_of(at.begin(), at.end(), [&](const Wall& w) { return bound.is_nearer(w); })) {
      continue;
    }
    rows.push_back(
        {at[0].depth - at[1].depth, at[0].depth - at[2].depth, speed * corners[0].w, -at[0].depth});
  }
  const auto count = static_cast<Eigen::Index>(rows.size());
  LinearProgram lp{RationalMatrix(count, 3), RationalVector(count), RationalVector::Zero(3)};
  for (Eigen::Index k = 0; k < count; ++k) {
    auto& row = rows[static_cast<std::size_t>(k)];
    for (Eigen::Index i = 0; i < 3; ++i) lp.normals(k, i) = std::move(row[i]);
    lp.offsets[k] = std::move(row[3]);
  }
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
  const Corners corners = corners_of(*surface_, triangle);
  std::array<RationalPoint, 3> points;
  for (std::size_t k = 0; k < 3; ++k) {
    points[k] = surface_->points[surface_->triangles[triangle.index()][k]];
  }
  Concavity found{
      .triangle = triangle, .at = points[0], .leaves = points[0], .normal = IntegerVector3::Zero()};
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
        points[0] + best.x[0] * (points[1] - points[0]) + best.x[1] * (points[2] - points[0]);
    keep(from, {best.x[2], normal}, true);
    return found;
  }
  for (int k = 0; k < 3; ++k) {
    const IntegerVector3 normal = direction(triangle, k);
    if (normal.isZero()) continue;
    const HomogeneousPoint& corner = corners[static_cast<std::size_t>(k)];
    const auto wall = wall_ahead(hull, corner, normal);
    keep(points[static_cast<std::size_t>(k)],
         {wall ? wall->distance(corner.w) : Rational(0), normal}, found.normal.isZero());
  }
  return found;
}

bool ExactConcavity::is_no_longer(TriangleId triangle, const ConvexPart& hull,
                                  const Rational& squared) const {
  const IntegerVector3 normal = direction(triangle, 0);
  if (normal.isZero()) return true;
  const Corners corners = corners_of(*surface_, triangle);
  const Wall bound = bounding_wall(hull, corners, normal);
  return squared_length({bound.distance(corners[0].w), normal}) <= squared;
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
