// SPDX-License-Identifier: MIT
// subset.hpp - some points of a point set.
#pragma once
#include <span>

#include "convexact/geometry/point_set.hpp"

namespace convexact {

/// The points with these ids, in this order.
[[nodiscard]] PointSet subset(const PointSet& points, std::span<const PointId> ids);

}  // namespace convexact
