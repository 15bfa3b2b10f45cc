// SPDX-License-Identifier: MIT
#include "convexact/hull.hpp"

#include <algorithm>
#include <numeric>

#include "hull/facet_order.hpp"
#include "hull/hull_observer.hpp"
#include "hull/hull_steps.hpp"
#include "number/arithmetic.hpp"
#include "task/parallel.hpp"

namespace convexact {
namespace {

Halfspace plane(const IntegerVector3& normal, const Integer& offset) { return {normal, offset}; }

// The plane through p with the given normal.
Halfspace plane_at(const RationalVector3& normal, const RationalPoint& p) {
  return {normal, Rational(-normal.dot(p))};
}

// 3 - dimension independent planes that hold the affine hull of the basis.
std::vector<Halfspace> equations_of(const std::vector<RationalPoint>& basis) {
  const IntegerVector3 unit[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  std::vector<Halfspace> planes;
  if (basis.empty()) {  // no point satisfies x = y = z = 0 and x = 1
    for (const IntegerVector3& axis : unit) planes.push_back(plane(axis, 0));
    planes.push_back(plane(unit[0], -1));
  } else if (basis.size() == 1) {
    for (const IntegerVector3& axis : unit)
      planes.push_back(plane_at(axis.cast<Rational>(), basis[0]));
  } else if (basis.size() == 2) {
    // u x e_i and u x e_j are independent if u has a component along the third axis.
    const RationalVector3 u = basis[1] - basis[0];
    const int along = u[0] != 0 ? 0 : u[1] != 0 ? 1 : 2;
    for (const int other : {(along + 1) % 3, (along + 2) % 3}) {
      const RationalVector3 axis = unit[other].cast<Rational>();
      planes.push_back(plane_at(u.cross(axis), basis[0]));
    }
  } else {
    planes.push_back(Halfspace::through(basis[0], basis[1], basis[2]));
  }
  return planes;
}

template <class Points>
HullOutcome hull_of(Points points, const HullOptions& options) {
  require_threads(options.jobs);
  const std::vector<PointId> basis = find_simplex(points);
  if (basis.size() < 4) {
    std::vector<RationalPoint> corners;
    for (const PointId p : basis) corners.push_back(points.rational(p));
    return FlatInput{static_cast<int>(basis.size()) - 1, basis, equations_of(corners)};
  }
  const std::array<PointId, 4> simplex{basis[0], basis[1], basis[2], basis[3]};
  points.center_at(simplex);
  Hull hull = merge_facets(points, triangulate(points, simplex, options), simplex);
  if (options.observer != nullptr) options.observer->finished(hull);
  return hull;
}

}  // namespace

HullOutcome convex_hull(const PointSet& points, const HullOptions& options) {
  if (points.is_binary()) return hull_of(DoublePoints(points.doubles()), options);
  return hull_of(HomogeneousPoints(points), options);
}

HullOutcome convex_hull(std::span<const HomogeneousPoint> points, const HullOptions& options) {
  return hull_of(HomogeneousPoints(points), options);
}

std::vector<Halfspace> facet_halfspaces(const Hull& hull, const PointSet& points) {
  std::vector<Halfspace> halfspaces;
  halfspaces.reserve(hull.facets.size());
  for (std::size_t f = 0; f < hull.facets.size(); ++f) {
    // Corners are extreme, so no three of them are collinear.
    const auto c = hull.facets[f];
    if (points.is_binary()) {
      const auto p = points.doubles();
      halfspaces.push_back(Halfspace::through(p[c[0].index()], p[c[1].index()], p[c[2].index()]));
    } else {
      halfspaces.push_back(Halfspace::through(points[c[0]], points[c[1]], points[c[2]]));
    }
  }
  return halfspaces;
}

std::vector<std::vector<std::uint32_t>> polygons_of(const FacetList& facets) {
  std::vector<std::vector<std::uint32_t>> polygons(facets.size());
  for (std::size_t f = 0; f < facets.size(); ++f) {
    for (const PointId corner : facets[f]) polygons[f].push_back(corner.value);
  }
  return polygons;
}

namespace {

std::vector<std::uint32_t> canonical_order(const std::vector<Halfspace>& planes) {
  std::vector<std::uint32_t> order(planes.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t f, std::uint32_t g) { return planes[f] < planes[g]; });
  return order;
}

}  // namespace

FacetList in_canonical_order(const Hull& hull, const PointSet& points) {
  FacetList facets;
  for (const std::uint32_t f : canonical_order(facet_halfspaces(hull, points))) {
    facets.push_back(hull.facets[f]);
  }
  return facets;
}

Polytope to_polytope(const Hull& hull, const PointSet& points) {
  Polytope polytope;
  std::vector<std::uint32_t> vertex_of(points.size());
  for (const PointId p : hull.vertices) {
    vertex_of[p.index()] = static_cast<std::uint32_t>(polytope.vertices.size());
    polytope.vertices.push_back(points[p]);
  }
  std::vector<Halfspace> planes = facet_halfspaces(hull, points);
  for (const std::uint32_t f : canonical_order(planes)) {
    std::vector<std::uint32_t> corners;
    for (const PointId p : hull.facets[f]) corners.push_back(vertex_of[p.index()]);
    polytope.facets.push_back(std::move(corners));
    polytope.planes.push_back(std::move(planes[f]));
  }
  return polytope;
}

}  // namespace convexact
