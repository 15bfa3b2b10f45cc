// SPDX-License-Identifier: MIT
// excess.hpp - how far points lie beyond planes, exactly: the first of the two ways to containment.
#pragma once
#include <optional>
#include <span>

#include "convexact/geometry/halfspace.hpp"
#include "convexact/geometry/point_set.hpp"

namespace convexact {

/// A point strictly beyond a plane.
struct Excess {
  PointId point;
  std::size_t plane;          ///< Index into the halfspaces.
  Rational squared_distance;  ///< (n.p + d)^2 / n.n, in squared length units; positive.
};

/// The pair of a point and a plane of largest distance among those where the point is strictly
/// beyond; of equals the lowest plane, then the lowest point. Nothing if no point is beyond any
/// plane.
/// @par Cost  A product in doubles for each pair; exact for the pairs that may be the largest.
[[nodiscard]] std::optional<Excess> find_excess(std::span<const Halfspace> halfspaces,
                                                const PointSet& points);

}  // namespace convexact
