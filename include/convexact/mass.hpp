// SPDX-License-Identifier: MIT
// mass.hpp - volume, center of mass and moments of inertia of solids, exactly.
#pragma once
#include <array>
#include <optional>
#include <span>

#include "convexact/overlay.hpp"

namespace convexact {

/// Of a solid of density 1.
struct MassProperties {
  Rational volume;       ///< In cubed length units; > 0.
  RationalPoint center;  ///< Of mass.
  /// The integral of (x - center) (x - center)^T: its entries xx, yy, zz, xy, xz, yz.
  std::array<Rational, 6> moments;

  /// The tensor of inertia about the center: xx, yy, zz, xy, xz, yz, such as the integral of
  /// y^2 + z^2, and the negative one of x y.
  std::array<Rational, 6> inertia() const;
};

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
