// SPDX-License-Identifier: MIT
// interior_point.hpp - an interior point with short coordinates.
#pragma once
#include <optional>
#include <span>

#include "convexact/geometry/halfspace.hpp"

namespace convexact {

/// Each coordinate rounded to the nearest multiple of 2^exponent (half of it: upwards).
[[nodiscard]] RationalPoint round_to_grid(const RationalPoint& x, long exponent);

/// Whether dot(n, x) + d < 0 for every halfspace.
[[nodiscard]] bool is_strictly_inside(std::span<const Halfspace> halfspaces,
                                      const RationalPoint& x);

/// The first strictly interior point among `inside` rounded to ever finer grids 2^k: the coarsest
/// power of two that serves, starting with the one on which `inside` becomes the origin. How deep
/// it lies is not promised.
/// @param inside  A strictly interior point: any rational, or a good guess such as a centroid of
///                doubles; it is tested.
/// @return Nothing if `inside` is not strictly interior.
/// @par Cost  Few exact evaluations per grid that fails, m for the one that serves.
[[nodiscard]] std::optional<RationalPoint> short_dyadic_interior_point(
    std::span<const Halfspace> halfspaces, const RationalPoint& inside);

}  // namespace convexact
