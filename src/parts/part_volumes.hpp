// SPDX-License-Identifier: MIT
// part_volumes.hpp - the volumes of a surface's solid and of convex parts laid over it.
#pragma once
#include <vector>

#include "convexact/decompose.hpp"
#include "solid/stage_log.hpp"
#include "task/lazy.hpp"

namespace convexact {

/// What is asked about volumes, and what is known before.
struct VolumesAsked {
  PartMeasures wanted;      ///< Not None.
  bool exact = false;       ///< Fractions, too.
  bool hold_solid = false;  ///< The parts are proven to hold the solid: nothing of it is uncovered.
  bool with_solid = true;   ///< If not, and the parts hold the solid, its volume only for All.
  std::size_t jobs = 1;     ///< Threads, at least 1, on which no number depends.
};

/// Solid, uncovered and excess volume only of a closed surface.
[[nodiscard]] DecompositionMeasures measure_volumes(const Surface& surface,
                                                    const std::vector<ConvexPart>& parts,
                                                    const VolumesAsked& asked, StageLog& log);

/// The volume of the union of parts outside of a closed surface's solid, exactly, if each part has
/// a volume. If it is 0 no point of the union is outside, as each is the limit of interior points.
[[nodiscard]] std::optional<Rational> exact_excess(const Surface& surface,
                                                   const std::vector<ConvexPart>& parts,
                                                   const StageWatch& watch, std::size_t jobs);

/// How much larger the volumes of parts together may be than that of a closed surface's solid.
class VolumeLimit {
 public:
  /// Keeps a reference to the surface.
  /// @param share  Of the solid's volume, >= 0.
  /// @throws Error InvalidArgument if the solid has no volume; Stopped.
  VolumeLimit(const Surface& surface, Rational share, const Watch& watch, std::size_t jobs);

  /// The volume that the parts may have, or a little less.
  Rational least() const { return solid_.low() * (1 + share_); }
  /// Decided exactly; what overlaps counts twice.
  DecompositionExcess excess_of(const std::vector<ConvexPart>& parts, const Watch& watch) const;

 private:
  const Rational& exact_solid(const Watch& watch) const;

  const Surface& surface_;
  Rational share_;
  std::size_t jobs_;
  Enclosure solid_;
  Lazy<Rational> exact_solid_;
};

}  // namespace convexact
