// SPDX-License-Identifier: MIT
#include "fast/near_vertices.hpp"

#include <algorithm>
#include <cmath>

#include "number/arithmetic.hpp"

namespace convexact {

NearVertices::NearVertices(const PointSet& points)
    : exact_(points), near_(points.size()), error_(0), unit_(exact_.unit()) {
  for (int axis = 0; axis < 3; ++axis) {
    if (points.is_binary()) {
      double largest = 0;
      for (const Point& p : points.doubles()) largest = std::max(largest, std::abs(p[axis]));
      const int exponent = exponent_of(largest);
      for (std::size_t v = 0; v < near_.size(); ++v) {
        near_[v][axis] = std::ldexp(points.doubles()[v][axis], -exponent);
      }
      unit_ = scale_by_power_of_two(unit_, -exponent);
    } else {
      std::vector<Rational> coordinates;
      Rational largest = 0;
      for (std::size_t v = 0; v < near_.size(); ++v) {
        coordinates.push_back(points[PointId(v)][axis]);
        largest = std::max<Rational>(largest, abs(coordinates.back()));
      }
      const long exponent = exponent_of(largest);
      for (std::size_t v = 0; v < near_.size(); ++v) {
        near_[v][axis] =
            to_double(scale_by_power_of_two(coordinates[v], -exponent), Rounding::Nearest);
      }
      unit_ = scale_by_power_of_two(unit_, -exponent);
      error_ = kUnitRoundoff;
    }
  }
}

Interval<double> NearVertices::scaled(const Integer& six_volumes) const {
  const Rational value = Rational(six_volumes) * unit_;
  return {to_double(value, Rounding::Down), to_double(value, Rounding::Up)};
}

}  // namespace convexact
