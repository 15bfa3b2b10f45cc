// SPDX-License-Identifier: MIT
// mixed_halfspaces.hpp - halfspaces that nobody thought of: tiny tilts, huge offsets, repeats, long
// numbers.
#pragma once
#include <cstdint>
#include <vector>

#include "convexact/halfspace.hpp"

namespace convexact {

/// A box, then `parts` groups of halfspaces that all hold one point: at random distances of it from
/// 2^-500 to 2^500, copies tilted or moved by as little as 2^-300, repeats, and normals and offsets
/// of 300 digits. Then everything is moved, perhaps far away. Bounded, not empty.
[[nodiscard]] std::vector<Halfspace> mixed_halfspaces(std::uint32_t parts, std::uint64_t seed);

}  // namespace convexact
