// SPDX-License-Identifier: MIT
#include "convexact/point_set.hpp"

namespace convexact {

PointSet subset(const PointSet& points, std::span<const PointId> ids) {
  if (!points.is_binary()) {
    std::vector<RationalPoint> chosen;
    for (const PointId id : ids) chosen.push_back(points[id]);
    return PointSet(std::move(chosen));
  }
  std::vector<Point> chosen;
  for (const PointId id : ids) chosen.push_back(points.doubles()[id.index()]);
  return PointSet(std::move(chosen));
}

}  // namespace convexact
