// SPDX-License-Identifier: MIT
// part_volumes.hpp - the volumes of a surface's solid and of convex parts laid over it.
#pragma once
#include <vector>

#include "convexact/decompose.hpp"
#include "solid/stage_log.hpp"
#include "task/lazy.hpp"

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

/// How much larger the volumes of parts together may be than that of a closed surface's solid.
class VolumeLimit {
 public:
  /// Keeps a reference to the surface.
  /// @param share  Of the solid's volume, >= 0.
  /// @throws Error InvalidArgument if the solid has no volume; Stopped.
  VolumeLimit(const Surface& surface, Rational share, const Watch& watch);

  /// The volume that the parts may have, or a little less.
  Rational least() const { return solid_.low() * (1 + share_); }
  /// Decided exactly; what overlaps counts twice.
  DecompositionExcess excess_of(const std::vector<ConvexPart>& parts, const Watch& watch) const;

 private:
  const Rational& exact_solid(const Watch& watch) const;

  const Surface& surface_;
  Rational share_;
  Enclosure solid_;
  Lazy<Rational> exact_solid_;
};

}  // namespace convexact
