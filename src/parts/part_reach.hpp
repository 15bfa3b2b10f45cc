// SPDX-License-Identifier: MIT
// part_reach.hpp - which parts, as stored, are not proven to be within a distance of the solid.
#pragma once
#include <vector>

#include "convexact/decompose.hpp"
#include "convexact/reach.hpp"

namespace convexact {

/// @param squared_share  The distance allowed, squared, over the diameter squared.
/// @throws Error InvalidArgument for a distance that cells cannot tell, and for 0 without a solid.
void require_told(const Rational& squared_share, bool is_closed);

/// The parts that are not proven to be within the distance, ascending, with what is known of them.
/// By cells; at a distance of 0 the volume outside of the solid decides what they leave open.
/// @param limit  Of that distance, with room for the parts.
/// @param made   With its surface, its parts, and `reach->squared_distance`.
/// @param jobs   Threads, at least 1, on which the answer does not depend.
/// @param quiet  For the volumes: it stops, and reports nothing.
/// @throws Error Stopped.
[[nodiscard]] std::vector<DecompositionReach::Farther> farther_parts(
    const Decomposition& made, const std::vector<ConvexPart>& stored, ReachLimit& limit,
    std::size_t jobs, const StageWatch& quiet, const Watch& watch);

}  // namespace convexact
