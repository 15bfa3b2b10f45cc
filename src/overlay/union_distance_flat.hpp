// SPDX-License-Identifier: MIT
// union_distance_flat.hpp - the features of flat parts, and the nearest points of flat sets.
#pragma once
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "convexact/overlay.hpp"

namespace convexact {

/// A polygon's plane and sides. A side is two vertices on the boundary of one halfspace on which no
/// third vertex lies; the plane holds all vertices.
struct FlatFeatures {
  explicit FlatFeatures(const ConvexPart& polygon);

  const Halfspace* plane = nullptr;  ///< One of the part's.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> sides;
};

/// The point of a part of dimension 2, 1 or 0 that is nearest to x, exactly.
/// @param features  Used for dimension 2 only.
[[nodiscard]] RationalPoint nearest_in_flat(const ConvexPart& part, const FlatFeatures& features,
                                            const RationalPoint& x);

/// The point of a triangle that is nearest to x, exactly. It may be a segment or a point.
[[nodiscard]] RationalPoint nearest_in_triangle(const std::array<RationalPoint, 3>& corners,
                                                const RationalPoint& x);

}  // namespace convexact
