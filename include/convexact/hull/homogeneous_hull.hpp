// SPDX-License-Identifier: MIT
// homogeneous_hull.hpp - the hull of homogeneous points, such as the dual points of halfspaces.
#pragma once
#include <span>

#include "convexact/hull/homogeneous_point.hpp"
#include "convexact/hull/hull.hpp"

namespace convexact {

/// The hull of rational points n / w in homogeneous integers; ids are indices. Of use for dual
/// points above all, of which the extreme ones are the halfspaces that are not redundant.
/// @throws Error InvalidArgument if some w <= 0.
[[nodiscard]] HullOutcome convex_hull(std::span<const HomogeneousPoint> points,
                                      const HullOptions& options = {});

/// check_hull() for homogeneous points.
[[nodiscard]] bool check_hull(const Hull& hull, std::span<const HomogeneousPoint> points);

}  // namespace convexact
