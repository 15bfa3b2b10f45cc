// SPDX-License-Identifier: MIT
// mass.hpp - volume, center of mass and moments of inertia of surfaces and of unions, exactly.
#pragma once
#include <optional>
#include <span>

#include "convexact/measure.hpp"
#include "convexact/overlay.hpp"

namespace convexact {

/// Of what a closed surface winds about, each point counted once; nothing if that has no volume.
/// @throws Error InvalidArgument unless the surface is closed; Stopped when the watch ends the
///               call.
/// @par Cost  As solid_volume(), exactly: where triangles cross, fractions may have thousands of
///            digits.
[[nodiscard]] std::optional<MassProperties> mass_properties(const Surface& surface,
                                                            const Watch& watch = {});

/// Of the union of parts; flat parts have no mass.
/// @throws Error Stopped when the watch ends the call.
[[nodiscard]] std::optional<MassProperties> mass_properties(std::span<const ConvexPart> parts,
                                                            const Watch& watch = {});

}  // namespace convexact
