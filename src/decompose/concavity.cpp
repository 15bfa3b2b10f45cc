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
                    : primitive_direction(clear_denominators(v).n);
}

using ScaledRay = std::pair<Rational, IntegerVector3>;  // its length in multiples of its direction

Rational squared_length(const ScaledRay& ray) {
  return ray.first * ray.first * Rational(ray.second.dot(ray.second));
}

// The corners of a triangle over one denominator.
using TriangleCorners = std::array<HomogeneousPoint, 3>;

TriangleCorners corners_of(const Surface& surface, TriangleId triangle) {
  std::array<Rational, 9> coordinates;
  for (std::size_t k = 0; k < 3; ++k) {
    const RationalPoint corner = surface.points[surface.triangles[triangle.index()][k]];
    std::copy(corner.begin(), corner.end(), coordinates.begin() + 3 * k);
  }
  std::array<Integer, 9> x;
  const Integer w = clear_denominators(coordinates, x);
  return {{{{x[0], x[1], x[2]}, w}, {{x[3], x[4], x[5]}, w}, {{x[6], x[7], x[8]}, w}}};
}

// A plane that a ray runs towards, speed = n.direction > 0. From a point X / W it gets there after
// depth / (W speed) times its direction, where depth = -(n.X + d W), at least 0 of a point of the
// hull.
struct Wall {
  const Halfspace* plane;
  Integer depth, speed;

  // Of points with the same W.
  bool is_nearer(const Wall& other) const { return depth * other.speed < other.depth * speed; }
  Rational distance(const Integer& w) const { return {depth, w * speed}; }
};

// Where the ray from a point of the hull leaves it: the first plane that it reaches.
std::optional<Wall> wall_ahead(const ConvexPart& hull, const HomogeneousPoint& from,
                               const IntegerVector3& direction) {
  std::optional<Wall> first;
  for (const Halfspace& plane : hull.halfspaces) {
    Integer speed = dot(plane.normal(), direction);
    if (speed <= 0) continue;
    Wall wall{&plane, -plane_value(plane, from), std::move(speed)};
    if (!first || wall.is_nearer(*first)) first = std::move(wall);
  }
  return first;
}

// The wall ahead of the centroid of a triangle, at its distance from a corner: no ray from the
// triangle is longer.
Wall bounding_wall(const ConvexPart& hull, const TriangleCorners& corners,
                   const IntegerVector3& direction) {
  const auto& [a, b, c] = corners;
  Wall bound = *wall_ahead(hull, {a.n + b.n + c.n, 3 * a.w}, direction);
  bound.depth = 0;
  for (const HomogeneousPoint& corner : corners) {
    bound.depth = std::max<Integer>(bound.depth, -plane_value(*bound.plane, corner));
  }
  return bound;
}

// (t, u, v): a ray from the point a + u (b - a) + v (c - a) of a triangle, t times its direction.
// They compare by length, then by u and v, so there is one longest ray.
using TriangleRay = std::array<Rational, 3>;
// One plane as a wall for each corner of a triangle.
using WallAtCorners = std::array<Wall, 3>;

// At a corner, or on an edge where both planes are equally far; they may be the same plane.
TriangleRay longest_by_two(const WallAtCorners& p, const WallAtCorners& q, const Integer& w) {
  const std::array<TriangleRay, 3> to_p{
      {{p[0].distance(w), 0, 0}, {p[1].distance(w), 1, 0}, {p[2].distance(w), 0, 1}}};
  std::array<Integer, 3> lead;  // positive where q is nearer
  for (std::size_t k = 0; k < 3; ++k) {
    lead[k] = p[k].depth * q[k].speed - q[k].depth * p[k].speed;
  }
  TriangleRay longest;
  for (std::size_t k = 0; k < 3; ++k) {
    TriangleRay at_corner = to_p[k];
    if (lead[k] > 0) at_corner[0] = q[k].distance(w);
    longest = std::max(longest, at_corner);
    const std::size_t next = (k + 1) % 3;
    if (lead[k].sign() * lead[next].sign() >= 0) continue;
    const Rational share = Rational(lead[k]) / Rational(lead[k] - lead[next]);
    TriangleRay on_edge;
    for (std::size_t i = 0; i < 3; ++i) {
      on_edge[i] = to_p[k][i] + share * (to_p[next][i] - to_p[k][i]);
    }
    longest = std::max(longest, on_edge);
  }
  return longest;
}

// The largest t that all planes allow: a linear program in u, v and t.
TriangleRay longest_by_program(const std::vector<WallAtCorners>& walls, const Integer& w) {
  const auto count = static_cast<Eigen::Index>(walls.size());
  LinearProgram lp{RationalMatrix::Zero(count + 3, 3), RationalVector::Zero(count + 3),
                   RationalVector::Zero(3)};
  for (Eigen::Index k = 0; k < count; ++k) {
    const auto& [a, b, c] = walls[static_cast<std::size_t>(k)];
    lp.normals(k, 0) = a.depth - b.depth;
    lp.normals(k, 1) = a.depth - c.depth;
    lp.normals(k, 2) = a.speed * w;
    lp.offsets[k] = -a.depth;
  }
  lp.normals(count, 0) = -1;      // u >= 0
  lp.normals(count + 1, 1) = -1;  // v >= 0
  lp.normals(count + 2, 0) = lp.normals(count + 2, 1) = 1;
  lp.offsets[count + 2] = -1;  // u + v <= 1
  lp.objective[2] = 1;
  const auto best = std::get<Optimal>(maximise(lp));  // the hull holds the triangle
  return {best.x[2], best.x[0], best.x[1]};
}

// Planes that are beyond the bound at all corners cut off nothing, and are left out.
TriangleRay longest_ray(const ConvexPart& hull, const TriangleCorners& corners,
                        const IntegerVector3& direction) {
  const Wall bound = bounding_wall(hull, corners, direction);
  std::vector<WallAtCorners> walls;
  for (const Halfspace& plane : hull.halfspaces) {
    const Integer speed = dot(plane.normal(), direction);
    if (speed <= 0) continue;
    WallAtCorners at;
    for (std::size_t k = 0; k < 3; ++k) at[k] = {&plane, -plane_value(plane, corners[k]), speed};
    const auto is_beyond = [&](const Wall& wall) { return bound.is_nearer(wall); };
    if (!std::all_of(at.begin(), at.end(), is_beyond)) walls.push_back(std::move(at));
  }
  const Integer& w = corners[0].w;
  return walls.size() <= 2 ? longest_by_two(walls.front(), walls.back(), w)
                           : longest_by_program(walls, w);
}

}  // namespace

ExactConcavity::ExactConcavity(const Surface& surface, ConcavityMeasure measure)
    : surface_(&surface), measure_(measure) {
  if (measure == ConcavityMeasure::Surface) return;
  std::vector<RationalVector3> at_points(surface.points.size(), RationalVector3::Zero());
  for (const auto& triangle : surface.triangles) {
    const RationalVector3 area = area_vector(surface.points, triangle);
    for (const PointId p : triangle) at_points[p.index()] += area;
  }
  for (const RationalVector3& normal : at_points) normals_.push_back(integer_direction(normal));
}

IntegerVector3 ExactConcavity::direction(TriangleId triangle, int k) const {
  const Triangle& corners = surface_->triangles[triangle.index()];
  return measure_ == ConcavityMeasure::Surface
             ? integer_direction(area_vector(surface_->points, corners))
             : normals_[corners[static_cast<std::size_t>(k)].index()];
}

Concavity ExactConcavity::operator()(TriangleId triangle, const ConvexPart& hull) const {
  const TriangleCorners corners = corners_of(*surface_, triangle);
  std::array<RationalPoint, 3> points;
  for (std::size_t k = 0; k < 3; ++k) {
    points[k] = surface_->points[surface_->triangles[triangle.index()][k]];
  }
  Concavity found{
      .triangle = triangle, .at = points[0], .leaves = points[0], .normal = IntegerVector3::Zero()};
  const auto keep = [&](const RationalPoint& from, const ScaledRay& ray, bool is_first) {
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
    const auto [t, u, v] = longest_ray(hull, corners, normal);
    const RationalPoint from =
        points[0] + u * (points[1] - points[0]) + v * (points[2] - points[0]);
    keep(from, {t, normal}, true);
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
  const TriangleCorners corners = corners_of(*surface_, triangle);
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
