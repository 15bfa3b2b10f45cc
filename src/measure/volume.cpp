// SPDX-License-Identifier: MIT
#include "convexact/measure/volume.hpp"

#include "convexact/number/balanced_sum.hpp"
#include "facet_area.hpp"

namespace convexact {

// The cone from a point x over facet f has the volume area * height / 3 with the height
// -(n.x + d) / |n|, so (area / |n|) * -(n.x + d) / 3.

Rational volume(const Polytope& polytope) {
  // From the origin, wherever it lies: heights are the plain offsets, and have a sign.
  std::vector<Rational> cones;
  for (std::size_t f = 0; f < polytope.facets.size(); ++f) {
    const Integer& offset = polytope.planes[f].offset();
    if (offset != 0) cones.push_back(area_per_normal(polytope, f) * Rational(Integer(-offset)));
  }
  return balanced_sum(std::move(cones)) / 3;
}

Enclosure enclose_volume(const Polytope& polytope, long precision) {
  Enclosure sum(precision);
  for (std::size_t f = 0; f < polytope.facets.size(); ++f) {
    const Rational depth = -polytope.planes[f](polytope.vertices.front());
    if (depth == 0) continue;
    sum += Enclosure(area_per_normal(polytope, f), precision) * Enclosure(depth, precision);
  }
  return sum / Enclosure(Integer(3), precision);
}

}  // namespace convexact
