// SPDX-License-Identifier: MIT
// check_surface.hpp - whether triangles on dual points bound their convex hull, decided exactly.
#pragma once
#include <span>

#include "fast/fast_dual.hpp"

namespace convexact {

/// Whether the triangles, counter-clockwise from outside, are the surface of the convex hull of
/// their corners, and the center is strictly inside: then the planes of the corners bound a solid
/// whose vertices and edges they describe. Trusts nothing about where the triangles come from.
/// @par Cost    O(n log n) for n triangles; exact numbers only where doubles cannot decide.
/// @par Source  [Mehlhorn1999]; the argument is that of docs/design/hull.md
[[nodiscard]] bool is_dual_hull(const FastDual& dual, std::span<const DualTriangle> triangles);

}  // namespace convexact
