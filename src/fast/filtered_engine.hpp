// SPDX-License-Identifier: MIT
// filtered_engine.hpp - the greedy simplification at float speed, with the exact engine's answer.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "convexact/run.hpp"
#include "fast/dual.hpp"
#include "fast/signs.hpp"

namespace convexact {

/// One removal of a run that keeps no record. A Step with its lists and its exact cost would take
/// several times as long to make as the removal itself, and ten times the memory; run_of() makes
/// Steps of these where a Run is wanted.
struct FastStep {
  HalfspaceId removed;
  /// How many halfspaces have this exact cost, `removed` included; in the float engine, how many
  /// have costs that doubles cannot distinguish, or 1 if they are more than it compares.
  std::uint32_t tied;
  /// The cost, enclosed by the filtered engine and estimated by the float engine (then both are
  /// equal), in units of 2^FastDual::volume_exponent() cubed length units. Where it is beyond the
  /// largest double the upper end is infinite.
  double cost_lower, cost_upper;
};

/// How often each arithmetic was needed.
struct FastCounts {
  SignCounts signs;               ///< Of the loop, not of the verification.
  std::uint64_t evaluations = 0;  ///< Caps enclosed by doubles.
  std::uint64_t doubtful = 0;     ///< Of these, caps that doubles could not enclose.
  std::uint64_t extended = 0;     ///< Caps enclosed again by DoubleDouble.
  std::uint64_t congruent = 0;    ///< Caps found to be congruent to one that they may tie with.
  std::uint64_t exact = 0;        ///< Caps computed as rationals.
};

struct FastResult {
  std::vector<FastStep> steps;
  std::vector<HalfspaceId> survivors;   ///< Ascending.
  std::vector<DualTriangle> triangles;  ///< Their dual hull.
  StopReason stop = StopReason::Reached;
  long growth_bits = 0;  ///< As in Run.
  FastCounts counts;
  TieTally ties;
  std::optional<FloatBound> bound;  ///< Of the float engine.
};

/// Removes one halfspace after another, each time the one whose removal adds the least volume; of
/// equal ones the first in canonical order. The removals are those of simplify_exact(), found by
/// other means: see docs/design/filtered.md.
/// @param options  As for simplify_exact(). VerifyLevel::Full counts as Local here.
/// @throws Error   As simplify_exact().
/// @par Cost       About k^2 flops per evaluated cap of a ring of k <= 16, O(k) above; per removal
///                 two to three caps are evaluated and a heap is sifted as often.
/// @par Source     [Jacobson2026], [Minoux1978]
[[nodiscard]] FastResult simplify_filtered(const FastDual& dual,
                                           const SimplifyOptions& options = {});

/// The same with the full record of every step: exact costs, ties, rings and triangles. Equals
/// simplify_exact() except for the choice among triangulations, and so among rings, where planes
/// share a point.
/// @param center  Strictly inside the solid.
[[nodiscard]] Run simplify_filtered(const DualHull& dual, const RationalPoint& center,
                                    const SimplifyOptions& options = {});

/// The removals of a run as a record of the kind that all engines share: without costs, ties, rings
/// and triangles. @param halfspaces  The list in which the run's ids are positions.
[[nodiscard]] Run run_of(const FastResult& result, std::vector<Halfspace> halfspaces);

}  // namespace convexact
