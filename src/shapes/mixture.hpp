// SPDX-License-Identifier: MIT
// mixture.hpp - random families, squeezed, moved and put together.
#pragma once
#include <cstdint>
#include <vector>

#include "convexact/point_set.hpp"

namespace convexact::shapes {

/// 1 <= `parts` <= 64 random shapes of the other families, few points each, with random values.
/// Each may be turned, stretched by random powers of two along the axes, and moved; its points may
/// come twice, once of them one ulp off. All coordinates are at most 2^1000. May span no volume.
[[nodiscard]] std::vector<Point> mixture(std::uint32_t parts, std::uint64_t seed);

}  // namespace convexact::shapes
