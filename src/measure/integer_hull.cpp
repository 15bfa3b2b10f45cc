// SPDX-License-Identifier: MIT
#include "measure/integer_hull.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace convexact {

IntegerHull::IntegerHull(const Hull& hull, const PointSet& points)
    : hull_(hull), vertices_(hull.vertices.size()), place_(points.size()) {
  if (!scale_doubles(points)) scale_rationals(points);
  for (std::size_t v = 0; v < hull.vertices.size(); ++v) {
    place_[hull.vertices[v].index()] = static_cast<std::uint32_t>(v);
  }
}

bool IntegerHull::scale_doubles(const PointSet& points) {
  constexpr int kWidestSpread = 900;
  int lowest = 2000, highest = -2000;
  for (const PointId id : hull_.vertices) {
    for (const double x : points.doubles()[id.index()]) {
      if (x == 0) continue;
      lowest = std::min(lowest, unit_exponent(x));
      highest = std::max(highest, unit_exponent(x));
    }
  }
  if (!points.is_binary() || highest - lowest > kWidestSpread) return false;
  scale_ = scale_by_power_of_two(Rational(1), -lowest);
  for (std::size_t v = 0; v < vertices_.size(); ++v) {
    const Point& p = points.doubles()[hull_.vertices[v].index()];
    for (int k = 0; k < 3; ++k) mpz_set_d(raw(vertices_[v][k]), std::ldexp(p[k], -lowest));
  }
  return true;
}

void IntegerHull::scale_rationals(const PointSet& points) {
  std::vector<Rational> coordinates;
  for (const PointId id : hull_.vertices) {
    const RationalPoint p = points[id];
    coordinates.insert(coordinates.end(), p.begin(), p.end());
  }
  std::vector<Integer> multiples(coordinates.size());
  scale_ = clear_denominators(coordinates, multiples);
  for (std::size_t v = 0; v < vertices_.size(); ++v) {
    for (int k = 0; k < 3; ++k) vertices_[v][k] = std::move(multiples[3 * v + k]);
  }
}

// Of the closed polygon p_0, p_1, ... it is the sum of p_m x p_(m+1).
IntegerVector3 IntegerHull::twice_area(std::size_t facet) const {
  const auto corners = hull_.facets[facet];
  IntegerVector3 normal = IntegerVector3::Zero();
  PointId last = corners.back();
  for (const PointId corner : corners) {
    add_cross_product(normal, vertex(last), vertex(corner));
    last = corner;
  }
  return normal;
}

}  // namespace convexact
