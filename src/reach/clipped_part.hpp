// SPDX-License-Identifier: MIT
// clipped_part.hpp - what a convex part and a cell have in common, and distances to a surface, in
// exact numbers.
#pragma once
#include <span>
#include <vector>

#include "convexact/overlay.hpp"
#include "convexact/reach.hpp"
#include "reach/reach_cells.hpp"

namespace convexact {

/// Points of the part and the closed cell, their extreme points among them; none if they have no
/// point in common.
[[nodiscard]] std::vector<RationalPoint> common_corners(const ConvexPart& part,
                                                        const CellPlace& place,
                                                        const NearFrame& frame);

/// The points of a convex hull on one side of a plane, n.x + d <= 0, as points with that hull:
/// those of the given ones, and where the plane cuts the segments between points of different
/// sides.
[[nodiscard]] std::vector<RationalPoint> on_one_side(std::span<const RationalPoint> points,
                                                     const Halfspace& plane);

/// The squared distance of x to a triangle, and the point of it that is nearest.
[[nodiscard]] FarthestPoint nearest_on_triangle(const Surface& surface, std::uint32_t triangle,
                                                const RationalPoint& x);

/// The point of the surface that is nearest to x; of equal triangles that of the lowest.
[[nodiscard]] FarthestPoint nearest_on_surface(const ReachCells& cells, const RationalPoint& x);

}  // namespace convexact
