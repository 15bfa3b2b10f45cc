// SPDX-License-Identifier: MIT
#include "stored/interior_point.hpp"

#include <vector>

#include "convexact/linear_program.hpp"
#include "number/balanced_sum.hpp"

namespace convexact::stored {

RationalPoint interior_point(const PointSet& points, std::span<const PointId> witnesses,
                             std::span<const Halfspace> halfspaces) {
  Point mean = Point::Zero();
  const auto count = static_cast<double>(witnesses.size());
  for (const PointId id : witnesses) mean += points.doubles()[id.index()] / count;
  if (mean.allFinite()) {
    RationalPoint rounded = to_rational(mean);
    if (is_strictly_inside(halfspaces, rounded)) return rounded;
  }
  RationalPoint exact;
  for (int k = 0; k < 3; ++k) {
    std::vector<Rational> terms;
    for (const PointId id : witnesses) terms.push_back(points[id][k]);
    exact[k] = balanced_sum(std::move(terms)) / witnesses.size();
  }
  return exact;
}

}  // namespace convexact::stored
