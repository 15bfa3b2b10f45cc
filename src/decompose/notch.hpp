// SPDX-License-Identifier: MIT
// notch.hpp - how deep the points of a part lie under its bridges, and where it is split.
#pragma once
#include <optional>

#include "decompose/bridges.hpp"

namespace convexact {

/// The point of a convex facet that is nearest to x, exactly.
[[nodiscard]] RationalPoint nearest_on_facet(const PointSet& points,
                                             const Association::Facet& facet,
                                             const Halfspace& plane, const RationalPoint& x);

struct Notch {
  PointId point;
  RationalPoint on_bridge;  ///< The point of the bridge nearest to it.
  Rational squared = 0;     ///< Their distance, squared.
};

/// The deepest point, the lowest one on a tie; none if no point has a distance from its bridge. The
/// distance to a bridge is that to the nearest of its facets; the choice says to which of its
/// bridges. Corners of the hull have distance 0, and so have points around which the patch lies on
/// the hull.
/// @par Cost  Bounds in doubles for each point and each facet of its bridges; exact numbers where
///            these leave open which is deepest.
[[nodiscard]] std::optional<Notch> deepest_notch(const Surface& surface, const Patch& patch,
                                                 const PatchHull& hull,
                                                 const Association& association,
                                                 BridgeChoice choice, const NearSurface& near,
                                                 const Watch& watch);

/// The largest distance of a point to the nearest facet, squared; 0 of a flat hull.
[[nodiscard]] Rational least_concavity(const Surface& surface, const Patch& patch,
                                       const PatchHull& hull, const NearSurface& near,
                                       const Watch& watch);

}  // namespace convexact
