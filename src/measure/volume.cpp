// SPDX-License-Identifier: MIT
#include "convexact/measure/volume.hpp"

#include <algorithm>
#include <array>

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

namespace {

using EnclosureVector3 = std::array<Enclosure, 3>;

// Six times the volume by tetrahedra from vertex 0, whose corners are rounded first. The rounding
// is cheap, but what it costs in digits depends on how far from the origin the polytope lies.
Enclosure six_volumes_of_rounded(const Polytope& polytope, long precision) {
  std::vector<EnclosureVector3> arms;
  for (const RationalPoint& p : polytope.vertices) {
    const auto coordinate = [&](int k) {
      Enclosure x(p[k], precision);
      return x -= Enclosure(polytope.vertices[0][k], precision);
    };
    arms.push_back({coordinate(0), coordinate(1), coordinate(2)});
  }
  Enclosure sum(precision);
  for (const auto& facet : polytope.facets) {
    if (std::find(facet.begin(), facet.end(), 0u) != facet.end()) continue;  // apex in its plane
    for (std::size_t m = 2; m < facet.size(); ++m) {
      const EnclosureVector3 &a = arms[facet[0]], &b = arms[facet[m - 1]], &c = arms[facet[m]];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
        sum += a[k] * (b[i] * c[j] - b[j] * c[i]);
      }
    }
  }
  return sum;
}

// From exact heights and areas: no term is negative, so the digits are there at once.
Enclosure enclose_by_heights(const Polytope& polytope, long precision) {
  Enclosure sum(precision);
  for (std::size_t f = 0; f < polytope.facets.size(); ++f) {
    const Rational depth = -polytope.planes[f](polytope.vertices.front());
    if (depth == 0) continue;
    sum += Enclosure(area_per_normal(polytope, f), precision) * Enclosure(depth, precision);
  }
  return sum / Enclosure(Integer(3), precision);
}

}  // namespace

Enclosure enclose_volume(const Polytope& polytope, long precision) {
  constexpr long kSpareBits = 96;  // for what cancels in an ordinary scene
  const Enclosure rounded =
      six_volumes_of_rounded(polytope, precision + kSpareBits) / Enclosure(Integer(6), precision);
  const bool is_narrow = scale_by_power_of_two(rounded.width(), precision) <= rounded.low();
  return is_narrow ? rounded : enclose_by_heights(polytope, precision);
}

}  // namespace convexact
