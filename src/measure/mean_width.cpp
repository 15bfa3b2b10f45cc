// SPDX-License-Identifier: MIT
#include "convexact/geometry.hpp"
#include "convexact/measure.hpp"
#include "number/arithmetic.hpp"

namespace convexact {
namespace {

// 4 pi times the mean width: each edge with the angle between the outward normals of its facets;
// 0 would mean coplanar facets, pi a knife edge.
AngleSum edges_times_angles(const Polytope& polytope, const Watch& watch) {
  std::vector<AngleTerm> terms;
  const std::vector<Edge> all = edges(polytope);
  for (std::size_t i = 0; i < all.size(); ++i) {
    watch.at(i, all.size());
    const Edge& edge = all[i];
    const RationalVector3 along = polytope.vertices[edge.head] - polytope.vertices[edge.tail];
    const IntegerVector3 &m = polytope.planes[edge.left].normal(),
                         &n = polytope.planes[edge.right].normal();
    const IntegerVector3 cross = m.cross(n);
    terms.push_back({1, along.squaredNorm(), dot(cross, cross), dot(m, n)});
  }
  return AngleSum(std::move(terms));
}

}  // namespace

Enclosure mean_width(const Polytope& polytope, long precision, const Watch& watch) {
  return edges_times_angles(polytope, watch).enclose(precision, watch) /
         (Enclosure(Integer(4), precision) * Enclosure::pi(precision));
}

Enclosure enclose_measure(const Polytope& polytope, CostMeasure measure, long precision,
                          const Watch& watch) {
  switch (measure) {
    case CostMeasure::Volume:
      return enclose_volume(polytope, precision);
    case CostMeasure::Area:
      return surface_area(polytope, precision, watch);
    case CostMeasure::MeanWidth:
      break;
  }
  return mean_width(polytope, precision, watch);
}

Cost exact_measure(const Polytope& polytope, CostMeasure measure, const Watch& watch) {
  switch (measure) {
    case CostMeasure::Volume:
      return volume(polytope);
    case CostMeasure::Area:
      return Cost(RootSum(facet_areas(polytope, watch)));
    case CostMeasure::MeanWidth:
      break;
  }
  return Cost(edges_times_angles(polytope, watch));
}

}  // namespace convexact
