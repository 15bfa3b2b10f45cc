// SPDX-License-Identifier: MIT
// cost_tree.hpp - a tree of removals that shows why no equal number of halfspaces of a hull bounds
// less volume.
#pragma once
#include <span>

#include "convexact/error.hpp"
#include "simplify/dual_surface.hpp"

namespace convexact {

/// Receives the tree as it is walked.
class CostTreeObserver {
 public:
  virtual ~CostTreeObserver() = default;
  /// In the state at hand: what the removal costs, or that it is unbounded.
  virtual void evaluated(const Removal& removal) = 0;
  /// The choices with this removal follow, in the state after it. The choices after those keep its
  /// halfspace, in the present state.
  virtual void branches(const Removal& removal) = 0;
  /// No remaining choice in this state ends below the least volume. The walk returns to the state
  /// before its branch.
  virtual void closes() = 0;
};

/// Costs of removals by volume never fall, so in each state the sum of the least ones, as many as
/// there are removals to go, is a lower bound for all choices. The tree branches on the dearest
/// removal until the bound is reached everywhere.
/// @param surface  With all halfspaces. It is the same afterwards.
/// @param free     Those that may be removed, ascending.
/// @param to_go    How many are to be removed.
/// @param least    The least volume that as many removals add.
/// @throws Error   Internal if some choice adds less; Stopped.
/// @par Cost       Exponential in the worst case: some evaluations for each state.
void walk_cost_tree(DualSurface& surface, std::span<const HalfspaceId> free, std::size_t to_go,
                    const Rational& least, CostTreeObserver& observer, const Watch& watch = {});

}  // namespace convexact
