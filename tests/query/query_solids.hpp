// SPDX-License-Identifier: MIT
// query_solids.hpp - boxes anywhere and small random solids, by the definition.
#pragma once
#include <vector>

#include "affine_dimension.hpp"
#include "number/random.hpp"
#include "polytope_by_definition.hpp"

namespace support {

/// The box between two corners.
inline convexact::Polytope box_between(const convexact::Point& low, const convexact::Point& high) {
  std::vector<convexact::Point> corners;
  for (int k = 0; k < 8; ++k) {
    corners.push_back(
        {k & 1 ? high[0] : low[0], k & 2 ? high[1] : low[1], k & 4 ? high[2] : low[2]});
  }
  return solid(corners);
}

/// |x_k| <= half.
inline convexact::Polytope cube_of(double half) {
  return box_between({-half, -half, -half}, {half, half, half});
}

/// Of `count` points of the grid [-reach, reach]^3, moved by a grid vector of the same kind.
inline convexact::Polytope grid_solid(convexact::Random& random, int count, int reach, int away) {
  using namespace convexact;
  const auto entry = [&](int most) {
    return static_cast<int>(uniform_below(random, 2 * most + 1)) - most;
  };
  while (true) {
    const Point by(entry(away), entry(away), entry(away));
    std::vector<Point> points;
    std::vector<RationalPoint> exact;
    for (int i = 0; i < count; ++i) {
      points.push_back(by + Point(entry(reach), entry(reach), entry(reach)));
      exact.push_back(to_rational(points.back()));
    }
    if (affine_dimension(exact) == 3) return solid(points);
  }
}

}  // namespace support
