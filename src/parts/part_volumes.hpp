// SPDX-License-Identifier: MIT
// part_volumes.hpp - the volumes of a surface's solid and of convex parts laid over it.
#pragma once
#include <vector>

#include "convexact/decompose.hpp"
#include "solid/stage_log.hpp"

namespace convexact {

/// Solid, uncovered and excess volume only of a closed surface.
/// @param wanted  Not None.
/// @param exact   Fractions, too.
/// @param hold_solid  The parts are proven to hold the solid: nothing of it is uncovered, and if no
///                    more is wanted, nothing is measured.
[[nodiscard]] DecompositionMeasures measure_volumes(const Surface& surface,
                                                    const std::vector<ConvexPart>& parts,
                                                    PartMeasures wanted, bool exact, StageLog& log,
                                                    bool hold_solid = false);

/// The volume of the union of parts outside of a closed surface's solid, exactly, if each part has
/// a volume. If it is 0 no point of the union is outside, as each is the limit of interior points.
[[nodiscard]] std::optional<Rational> exact_excess(const Surface& surface,
                                                   const std::vector<ConvexPart>& parts,
                                                   const StageWatch& watch);

}  // namespace convexact
