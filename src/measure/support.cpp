// SPDX-License-Identifier: MIT
#include "measure/support.hpp"

#include "convexact/error.hpp"

namespace convexact {

Support support(const PointSet& points, const RationalVector3& direction) {
  if (points.size() == 0) throw Error(ErrorCode::InvalidArgument, "a support needs a point");
  if (direction == RationalVector3::Zero()) {
    throw Error(ErrorCode::InvalidArgument, "a support needs a direction");
  }
  Support best{PointId(0), direction.dot(points[PointId(0)])};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Rational value = direction.dot(points[PointId(i)]);
    if (value > best.value) best = {PointId(i), value};
  }
  return best;
}

}  // namespace convexact
