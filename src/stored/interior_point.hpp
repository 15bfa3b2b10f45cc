// SPDX-License-Identifier: MIT
// interior_point.hpp - a point strictly inside solids that hold the same points.
#pragma once
#include <span>

#include "convexact/halfspace.hpp"
#include "convexact/point_set.hpp"

namespace convexact::stored {

/// The mean of `witnesses`, rounded to doubles if it is still strictly inside all of `halfspaces`,
/// otherwise exactly: the mean of points that span a volume is strictly inside every halfspace that
/// holds them.
[[nodiscard]] RationalPoint interior_point(const PointSet& points,
                                           std::span<const PointId> witnesses,
                                           std::span<const Halfspace> halfspaces);

}  // namespace convexact::stored
