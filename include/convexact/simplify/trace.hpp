// SPDX-License-Identifier: MIT
// trace.hpp - the record of a greedy run: which halfspace went, at what cost, tied with which.
#pragma once
#include <vector>

#include "convexact/geometry/halfspace.hpp"
#include "convexact/geometry/ids.hpp"
#include "convexact/number/rational.hpp"
#include "convexact/simplify/evaluation.hpp"

namespace convexact {

/// One removal.
struct Step {
  HalfspaceId removed;
  Rational cost;                  ///< Exact volume of the cap, in cubed length units.
  std::vector<HalfspaceId> tie;   ///< All of equal exact cost, `removed` first (the lowest id).
  std::vector<HalfspaceId> ring;  ///< One-ring of `removed` before the step.
  std::vector<DualTriangle> triangles;  ///< T_i: the ring's new triangulation.
  std::size_t left;                     ///< Halfspaces after the step.
};

/// Why a run ended.
enum class StopReason {
  Reached,       ///< The wanted number of halfspaces, or it was already met.
  GrowthLimit,   ///< The next step would exceed the wanted growth of volume.
  AllUnbounded,  ///< Every further removal is unbounded.
};

/// A progressive simplification: any prefix of `steps` is a valid result.
struct Trace {
  std::vector<Halfspace> halfspaces;  ///< In canonical order, no redundant ones; ids are positions.
  std::vector<Step> steps;
  StopReason stop = StopReason::Reached;

  /// Ids that are left after the first `count` steps, ascending.
  std::vector<HalfspaceId> survivors(std::size_t count) const;
  std::vector<HalfspaceId> survivors() const { return survivors(steps.size()); }
};

/// A trace and where it led.
struct Simplification {
  Trace trace;
  /// The dual hull of the halfspaces that are left, for to_polytope().
  std::vector<DualTriangle> triangles;
  /// Every evaluation in the order in which it was made; empty unless it was asked for.
  std::vector<Evaluation> evaluations = {};
};

}  // namespace convexact
