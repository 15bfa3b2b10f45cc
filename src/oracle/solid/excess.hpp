// SPDX-License-Identifier: MIT
// excess.hpp - how far points lie beyond planes and away from solids, exactly.
#pragma once
#include <optional>
#include <span>

#include "convexact/error.hpp"
#include "convexact/geometry.hpp"

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

/// A point outside a solid.
struct Farthest {
  PointId point;
  RationalPoint nearest;      ///< The point of the solid that is nearest to it.
  Rational squared_distance;  ///< From one to the other, in squared length units; positive.
};

/// The one of the points `ids` that is farthest from the solid, of equals the first; nothing if all
/// lie in it. A plane's distance is no more than a lower bound of this one: at a sharp edge a point
/// may be close to every plane and far from the solid.
/// @throws Error Stopped when the watch ends it.
/// @par Cost  NearestPoint for each of them.
[[nodiscard]] std::optional<Farthest> find_farthest(const Polytope& polytope,
                                                    const PointSet& points,
                                                    std::span<const PointId> ids,
                                                    const Watch& watch = {});

}  // namespace convexact
