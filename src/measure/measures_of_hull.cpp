// SPDX-License-Identifier: MIT
// The measures of a hull of points, in integers and without its planes.
#include <algorithm>
#include <bit>
#include <vector>

#include "convexact/measure.hpp"
#include "measure/fixed_point.hpp"
#include "measure/integer_hull.hpp"
#include "number/arithmetic.hpp"

namespace convexact {
namespace {

// low / divisor to high / divisor.
Enclosure quotient(const Integer& low, const Integer& high, const Rational& divisor,
                   long precision) {
  return {Rational(low) / divisor, Rational(high) / divisor, precision};
}

// No digits cancel: the sum is at least as large as its largest root, which has `bits` bits.
Enclosure area_of(const IntegerHull& hull, long precision) {
  std::vector<Integer> squares;
  for (std::size_t f = 0; f < hull.facets().size(); ++f) {
    const IntegerVector3 normal = hull.twice_area(f);
    squares.push_back(dot(normal, normal));
  }
  const long bits = precision + static_cast<long>(std::bit_width(squares.size()));
  const long shift = shift_for_root(*std::max_element(squares.begin(), squares.end()), bits);
  Integer sum = 0, cut = 0;
  for (const Integer& square : squares) {
    const FixedRoot root = fixed_root(square, shift);
    sum += root.floor;
    if (!root.is_exact) ++cut;
  }
  return quotient(sum, sum + cut, scale_by_power_of_two(2 * hull.scale() * hull.scale(), shift),
                  precision);
}

// As mean_width() of a polytope: each edge with the angle between its facets. An edge of length l
// has a mean width of l / 2, and no solid around it has less, so the sum is at least 2 pi times the
// longest length. The angles of n edges change it by at most n 2 error() 2^-bits of that length,
// and the lengths, which are cut by 2^-bits of it, by n pi 2^-bits.
Enclosure mean_width_of(const IntegerHull& hull, long precision) {
  Polytope topology;
  std::vector<IntegerVector3> normals;
  for (std::size_t f = 0; f < hull.facets().size(); ++f) {
    std::vector<std::uint32_t>& corners = topology.facets.emplace_back();
    for (const PointId corner : hull.facets()[f]) corners.push_back(corner.value);
    normals.push_back(hull.twice_area(f));
  }
  const std::vector<Edge> all = edges(topology);
  std::vector<Integer> squares;
  for (const Edge& edge : all) {
    const IntegerVector3 along = hull.vertex(PointId(edge.head)) - hull.vertex(PointId(edge.tail));
    squares.push_back(dot(along, along));
  }
  constexpr long kForErrors = 8;
  const long bits = precision + static_cast<long>(std::bit_width(all.size())) + kForErrors;
  const long shift = shift_for_root(*std::max_element(squares.begin(), squares.end()), bits);
  FixedAngles angles(bits);
  Integer low = 0, high = 0;
  for (std::size_t e = 0; e < all.size(); ++e) {
    const IntegerVector3 &m = normals[all[e].left], &n = normals[all[e].right];
    IntegerVector3 cross = IntegerVector3::Zero();
    add_cross_product(cross, m, n);
    const Integer angle = angles.angle(dot(cross, cross), dot(m, n));
    const Integer length = fixed_root(squares[e], shift).floor;
    low += length * (angle - angles.error());
    high += (length + 1) * (angle + angles.error());
  }
  return quotient(low, high, scale_by_power_of_two(4 * hull.scale(), shift + bits), precision) /
         Enclosure::pi(precision);
}

}  // namespace

Rational volume(const Hull& hull, const PointSet& points) {
  const IntegerHull integers(hull, points);
  // The sum of det(a, b, c) over a fan of each facet, in place: most of the time went to
  // temporaries.
  Integer six_volumes = 0, minor;
  for (std::size_t f = 0; f < hull.facets.size(); ++f) {
    const auto corners = hull.facets[f];
    const IntegerVector3& a = integers.vertex(corners[0]);
    for (std::size_t m = 2; m < corners.size(); ++m) {
      const IntegerVector3 &b = integers.vertex(corners[m - 1]), &c = integers.vertex(corners[m]);
      for (int k = 0; k < 3; ++k) {
        const int k1 = (k + 1) % 3, k2 = (k + 2) % 3;
        mpz_mul(raw(minor), raw(b[k1]), raw(c[k2]));
        subtract_product(minor, b[k2], c[k1]);
        add_product(six_volumes, a[k], minor);
      }
    }
  }
  const Rational& scale = integers.scale();
  return Rational(six_volumes) / (6 * scale * scale * scale);
}

Enclosure enclose_measure(const Hull& hull, const PointSet& points, CostMeasure measure,
                          long precision) {
  if (measure == CostMeasure::Volume) return Enclosure(volume(hull, points), precision);
  const IntegerHull integers(hull, points);
  return measure == CostMeasure::Area ? area_of(integers, precision)
                                      : mean_width_of(integers, precision);
}

}  // namespace convexact
