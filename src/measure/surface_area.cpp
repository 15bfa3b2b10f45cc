// SPDX-License-Identifier: MIT
#include "convexact/measure.hpp"
#include "measure/facet_area.hpp"

namespace convexact {

std::vector<RootTerm> facet_areas(const Polytope& polytope, const Watch& watch) {
  std::vector<RootTerm> areas;
  for (std::size_t f = 0; f < polytope.facets.size(); ++f) {
    watch.at(f, polytope.facets.size());
    const IntegerVector3& n = polytope.planes[f].normal();
    const Integer common = gcd(gcd(n[0], n[1]), n[2]);
    const Integer x = n[0] / common, y = n[1] / common, z = n[2] / common;
    areas.push_back({area_per_normal(polytope, f) * Rational(common), x * x + y * y + z * z});
  }
  return areas;
}

Enclosure enclose_sum(const std::vector<RootTerm>& terms, long precision) {
  Enclosure sum(precision);
  for (const RootTerm& term : terms) {
    sum += Enclosure(term.factor, precision) * sqrt(Enclosure(term.radicand, precision));
  }
  return sum;
}

Enclosure surface_area(const Polytope& polytope, long precision, const Watch& watch) {
  return enclose_sum(facet_areas(polytope, watch), precision);
}

}  // namespace convexact
