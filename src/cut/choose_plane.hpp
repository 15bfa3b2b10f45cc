// SPDX-License-Identifier: MIT
// choose_plane.hpp - the plane that cuts a leaf best.
//
// A choice is a preference: no proof hangs on it. It is made in doubles, in a fixed order, so that
// every machine chooses alike.
#pragma once
#include <optional>
#include <span>

#include "convexact/partition.hpp"
#include "cut/leaf.hpp"

namespace convexact {

/// Of the planes that leave something on both sides: first those whose sides' hulls hold `far`
/// least often, then the one whose sides' hulls have the least volume together; the first of equal
/// ones. Nothing if there is none.
/// @param far      The point of the leaf's hull to get rid of, in the frame.
/// @param winding  Null for an open surface.
/// @param jobs     Threads, at least 1; the choice does not depend on them.
/// @return An index into `planes`.
/// @throws Error Stopped when the watch ends the call.
/// @par Cost  For each plane the leaf's edges, and hulls of up to 216 points; hulls of up to 1,944
///            and then of all points, where these do not rule the plane out.
[[nodiscard]] std::optional<std::size_t> choose_plane(const Leaf& leaf, const Point& far,
                                                      std::span<const CutPlane> planes,
                                                      const CutPoints& points,
                                                      const Winding* winding, std::size_t jobs,
                                                      const Watch& watch);

}  // namespace convexact
