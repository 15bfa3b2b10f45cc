// SPDX-License-Identifier: MIT
#include "interior_point.hpp"

#include <vector>

#include "convexact/lp/interior_point.hpp"
#include "convexact/number/sum.hpp"

namespace convexact::stored {

RationalPoint interior_point(const PointSet& points, std::span<const PointId> witnesses,
                             std::span<const Halfspace> halfspaces) {
  Point mean = Point::Zero();
  const auto count = static_cast<double>(witnesses.size());
  for (const PointId id : witnesses) mean += points.doubles()[id.index()] / count;
  if (mean.allFinite()) {
    const RationalPoint rounded = to_rational(mean);
    if (is_strictly_inside(halfspaces, rounded)) return rounded;
  }
  std::vector<RationalPoint> terms;
  for (const PointId id : witnesses) terms.push_back(points[id]);
  return balanced_sum(std::move(terms)) / Rational(witnesses.size());
}

}  // namespace convexact::stored
