// SPDX-License-Identifier: MIT
// Directions of the facets of a mesh that has lost edges: by quadrics on the hull and on its dual
// [GarlandHeckbert1997], and by added volume, where no vertex moves inward [Sander2000]. For solids
// inside, the vertices that are left.
#include <algorithm>
#include <cmath>
#include <limits>

#include "convexact/hull.hpp"
#include "lab/compare/collapse.hpp"
#include "lab/compare/method.hpp"
#include "number/arithmetic.hpp"

namespace convexact {
namespace {

// The squared distances of a point from some planes, each weighted by the area that lies on it:
// x A x + 2 b x + c.
struct Quadric {
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Point b = Point::Zero();
  double c = 0;

  void add(const Quadric& other) {
    a += other.a;
    b += other.b;
    c += other.c;
  }
  double operator()(const Point& x) const { return std::max(0.0, x.dot(a * x) + 2 * b.dot(x) + c); }
};

// Of the plane of a triangle; zero if the triangle has no area.
Quadric quadric_of(const Point& p, const Point& q, const Point& r) {
  const Point vector = area_vector(p, q, r);
  const double length = vector.norm();
  if (!(length > 0)) return {};
  const Point n = vector / length;
  const double weight = length / 2, offset = -n.dot(p);
  return {weight * n * n.transpose(), weight * offset * n, weight * offset * offset};
}

enum class QuadricPlacement { Free, Ends };

// Edges are collapsed by quadrics: to the least point or, if that is undetermined or not allowed,
// to the best of the midpoint and the ends. Or only to the better end.
class QuadricRule : public CollapseRule {
 public:
  QuadricRule(std::span<const Point> vertices, std::span<const MeshTriangle> triangles,
              QuadricPlacement placement = QuadricPlacement::Free)
      : placement_(placement), quadrics_(vertices.size()) {
    for (const MeshTriangle& t : triangles) {
      const Quadric quadric = quadric_of(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
      for (const MeshCorner v : t) quadrics_[v].add(quadric);
    }
  }

  std::vector<Contraction> contractions(const CollapsingMesh& mesh, MeshCorner a,
                                        MeshCorner b) const override {
    Quadric sum = quadrics_[a];
    sum.add(quadrics_[b]);
    std::vector<Contraction> ways;
    std::vector<Point> places = {mesh.at(a), mesh.at(b)};
    const bool is_free = placement_ == QuadricPlacement::Free;
    if (is_free) places.insert(places.begin(), (mesh.at(a) + mesh.at(b)) / 2);
    for (const Point& p : places) ways.push_back({sum(p), p});
    std::stable_sort(ways.begin(), ways.end(),
                     [](const Contraction& x, const Contraction& y) { return x.cost < y.cost; });
    if (!is_free) return ways;
    if (const auto least = least_point(sum)) ways.insert(ways.begin(), {sum(*least), *least});
    return ways;
  }
  void merged(MeshCorner a, MeshCorner b) override { quadrics_[a].add(quadrics_[b]); }

 private:
  // Planes that are nearly parallel to a line leave the point along it open.
  static std::optional<Point> least_point(const Quadric& q) {
    constexpr double kLeastShare = 1e-9;  // of the determinant, in the cubed size of the matrix
    const double size = q.a.trace();
    if (!(std::abs(q.a.determinant()) > kLeastShare * size * size * size)) return {};
    return Point(-q.a.inverse() * q.b);
  }

  QuadricPlacement placement_;
  std::vector<Quadric> quadrics_;
};

// Edges are collapsed by the added volume, to a point on or beyond all planes at the edge: the
// solution of a linear program in three unknowns.
class OutwardRule : public CollapseRule {
 public:
  std::vector<Contraction> contractions(const CollapsingMesh& mesh, MeshCorner a,
                                        MeshCorner b) const override {
    // An edge with more planes waits until its ends have fewer, because all triples are tried.
    constexpr std::size_t kMostPlanes = 40;
    const std::vector<MeshTriangle> triangles = mesh.triangles_at(a, b);
    if (triangles.size() > kMostPlanes) return {};
    const Point origin = (mesh.at(a) + mesh.at(b)) / 2;
    std::vector<Plane> planes;
    Point goal = Point::Zero();
    double constant = 0;
    for (const MeshTriangle& t : triangles) {
      const Point vector = area_vector(mesh.at(t[0]), mesh.at(t[1]), mesh.at(t[2]));
      const double length = vector.norm();
      if (!(length > 0)) continue;
      const Plane plane{vector / length, vector.dot(origin - mesh.at(t[0])) / length};
      goal += vector;
      constant += length * plane.d;
      planes.push_back(plane);
    }
    const auto best = lowest(planes, goal);
    if (!best) return {};
    // A sixth of it is the volume between the old triangles and the point.
    return {{std::max(0.0, goal.dot(*best) + constant), Point(origin + *best)}};
  }
  void merged(MeshCorner, MeshCorner) override {}

 private:
  struct Plane {  // n x + d, from the middle of the edge
    Point n;
    double d;
  };

  // The point on or beyond all planes at which the goal is least; on a tie the first.
  static std::optional<Point> lowest(const std::vector<Plane>& planes, const Point& goal) {
    constexpr double kNear = 1e-12;       // of the size of the mesh, which is about 1
    constexpr double kLeastAngle = 1e-9;  // below it, three planes meet in no definite point
    std::optional<Point> best;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < planes.size(); ++i) {
      for (std::size_t j = i + 1; j < planes.size(); ++j) {
        const Point line = planes[i].n.cross(planes[j].n);
        for (std::size_t k = j + 1; k < planes.size(); ++k) {
          const double det = line.dot(planes[k].n);
          if (!(std::abs(det) > kLeastAngle)) continue;
          const Point x = -(planes[i].d * planes[j].n.cross(planes[k].n) +
                            planes[j].d * planes[k].n.cross(planes[i].n) + planes[k].d * line) /
                          det;
          const double value = goal.dot(x);
          if (value >= least || !std::all_of(planes.begin(), planes.end(), [&](const Plane& p) {
                return p.n.dot(x) + p.d >= -kNear;
              })) {
            continue;
          }
          least = value;
          best = x;
        }
      }
    }
    return best;
  }
};

RationalVector3 exact_normal(const CollapsingMesh& mesh, const MeshTriangle& t) {
  const RationalPoint a = to_rational(mesh.at(t[0])), b = to_rational(mesh.at(t[1])),
                      c = to_rational(mesh.at(t[2]));
  return (b - a).cross(c - a);
}

// The closed surface of the dual hull: its vertices are the dual points, in an even scale.
struct DualMesh {
  std::vector<Point> vertices;
  std::vector<MeshTriangle> triangles;
};

DualMesh dual_mesh_of(const HullToFit& hull) {
  const DualHull& dual = hull.solid.dual;
  RationalPoint center = RationalPoint::Zero();
  for (const RationalPoint& v : hull.polytope().vertices) center += v;
  center /= Rational(hull.polytope().vertices.size());
  std::vector<RationalVector3> points;
  Rational largest = 0;
  for (const Halfspace& h : dual.halfspaces) {
    points.push_back(h.normal().cast<Rational>() / Rational(-h(center)));
    for (const int k : {0, 1, 2}) largest = std::max(largest, Rational(abs(points.back()[k])));
  }
  const long exponent = exponent_of(largest);
  DualMesh mesh;
  for (const RationalVector3& p : points) {
    Point near;
    for (const int k : {0, 1, 2}) {
      near[k] = to_double(scale_by_power_of_two(p[k], -exponent), Rounding::Nearest);
    }
    mesh.vertices.push_back(near);
  }
  for (const DualTriangle& t : dual.triangles) {
    mesh.triangles.push_back({t[0].value, t[1].value, t[2].value});
  }
  return mesh;
}

// Of a closed mesh of triangles.
std::size_t vertices_for(std::size_t faces) { return faces / 2 + 2; }

}  // namespace

std::unique_ptr<CollapseRule> quadric_rule(std::span<const Point> vertices,
                                           std::span<const MeshTriangle> triangles) {
  return std::make_unique<QuadricRule>(vertices, triangles);
}

std::unique_ptr<CollapseRule> outward_rule() { return std::make_unique<OutwardRule>(); }

Normals propose_bloom(const HullToFit& hull, std::size_t faces, std::uint64_t) {
  QuadricRule rule(hull.vertices, hull.triangles);
  CollapsingMesh mesh(hull.vertices, hull.triangles, rule);
  mesh.reduce_to(vertices_for(faces), hull.watch);
  Normals normals;
  for (const MeshTriangle& t : mesh.triangles()) {
    const RationalVector3 normal = exact_normal(mesh, t);
    if (!normal.isZero()) normals.push_back(normal);
  }
  return normals;
}

Normals propose_qem_dual(const HullToFit& hull, std::size_t faces, std::uint64_t) {
  const DualMesh dual = dual_mesh_of(hull);
  QuadricRule rule(dual.vertices, dual.triangles);
  CollapsingMesh mesh(dual.vertices, dual.triangles, rule);
  mesh.reduce_to(faces, hull.watch);
  Normals normals;
  for (const MeshCorner v : mesh.corners()) {
    if (!mesh.at(v).isZero()) normals.push_back(to_rational(mesh.at(v)));
  }
  return normals;
}

// A remaining vertex has the place of an original one. Where rounding gave two the same place, the
// first stands for both.
HullCorners select_qem_ends(const HullToFit& hull, std::size_t vertices, std::uint64_t) {
  QuadricRule rule(hull.vertices, hull.triangles, QuadricPlacement::Ends);
  CollapsingMesh mesh(hull.vertices, hull.triangles, rule);
  mesh.reduce_to(vertices, hull.watch);
  HullCorners left;
  for (const MeshCorner v : mesh.corners()) {
    const auto found = std::find(hull.vertices.begin(), hull.vertices.end(), mesh.at(v));
    left.push_back(static_cast<std::uint32_t>(found - hull.vertices.begin()));
  }
  return left;
}

// The remaining mesh may have dents, so the hull of its vertices is used.
Normals propose_tlg(const HullToFit& hull, std::size_t faces, std::uint64_t seed) {
  OutwardRule rule;
  CollapsingMesh mesh(hull.vertices, hull.triangles, rule);
  mesh.reduce_to(vertices_for(faces), hull.watch);
  std::vector<Point> left;
  for (const MeshCorner v : mesh.corners()) left.push_back(mesh.at(v));
  const PointSet points(left);
  const HullOutcome outcome = convex_hull(points, {.seed = seed});
  const auto* found = std::get_if<Hull>(&outcome);
  if (found == nullptr) return {};
  Normals normals;
  for (const Halfspace& h : dual_of(*found, points).halfspaces) {
    normals.push_back(h.normal().cast<Rational>());
  }
  return normals;
}

}  // namespace convexact
