// SPDX-License-Identifier: MIT
// inner_part.hpp - convex parts that lie in another one.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "convexact/overlay.hpp"

namespace convexact {

/// Whether all points of a part lie in another one, exactly.
[[nodiscard]] bool lies_in(const ConvexPart& inner, const ConvexPart& outer);

/// By part: the first of those that it lies in and that lie in no other one themselves. Nothing for
/// those that stay; of equal parts the first one does.
/// @throws Error Stopped when the watch ends the call.
/// @par Cost  Two boxes of doubles for each pair, and corners where one box holds the other.
[[nodiscard]] std::vector<std::optional<std::size_t>> find_holders(
    std::span<const ConvexPart* const> parts, const Watch& watch);

}  // namespace convexact
