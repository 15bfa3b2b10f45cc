// SPDX-License-Identifier: MIT
// simple_polygon.hpp - whether a polygon in the plane crosses or touches itself.
#pragma once
#include <array>
#include <optional>
#include <span>
#include <utility>

#include "convexact/number.hpp"

namespace convexact {

using PlanarPoint = std::array<Rational, 2>;

/// Two edges of a closed polygon that have a point in common which is not the corner between
/// neighbours: the positions of their first corners, the lower one first; nothing if the polygon is
/// simple. Exact.
/// @param corners  At least three; no two neighbours are equal.
/// @par Cost  Linear for convex polygons; for others a sweep, in the worst case quadratic.
[[nodiscard]] std::optional<std::pair<std::size_t, std::size_t>> touching_edges(
    std::span<const PlanarPoint> corners);

}  // namespace convexact
