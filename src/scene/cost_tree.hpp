// SPDX-License-Identifier: MIT
// cost_tree.hpp - why no other halfspaces of a hull, as many, bound less volume: a tree of
// removals.
#pragma once
#include <vector>

#include "convexact/watch.hpp"
#include "simplify/dual_surface.hpp"

namespace convexact {

/// Is told the tree as it is walked.
class CostTreeObserver {
 public:
  virtual ~CostTreeObserver() = default;
  /// In the state at hand: what the removal costs, or that it is unbounded.
  virtual void evaluated(const Removal& removal) = 0;
  /// The choices with this removal follow; the state is the one after it. In what follows after
  /// that, in the state at hand now, its halfspace stays.
  virtual void branches(const Removal& removal) = 0;
  /// No choice that is left in this state ends below the least volume. The state before its branch
  /// is at hand again.
  virtual void closes() = 0;
};

/// Costs of removals by volume never fall, so the least of them in a state, as many as are to go,
/// are a lower bound for all choices. The tree branches on the dearest removal until the bound is
/// reached everywhere.
/// @param surface  All halfspaces. It ends as it was.
/// @param free     Those that may be removed, ascending.
/// @param to_go    How many are to be.
/// @param least    The least volume that as many removals add.
/// @throws Error   Internal if some choice adds less; Stopped.
/// @par Cost       Exponential in the worst case: some evaluations for each state.
void walk_cost_tree(DualSurface& surface, std::vector<HalfspaceId> free, std::size_t to_go,
                    const Rational& least, CostTreeObserver& observer, const Watch& watch = {});

}  // namespace convexact
