// SPDX-License-Identifier: MIT
// tied_removals.hpp - whether another choice among removals of the same cost leads to a solid.
#pragma once
#include <cstddef>
#include <span>

#include "convexact/geometry.hpp"
#include "solid/solid.hpp"

namespace convexact::oracle {

enum class ByTies { Lead, DoNotLead, Undecided };

/// Whether some order of removals leaves just these facets of the solid, where each removal is
/// proven to be one of those that add the least volume. Orders that lead to the same solid count
/// once.
/// @param most_states  Undecided beyond so many solids on the way.
/// @throws Error Stopped if the watch ends it.
/// @par Cost  A filtered run for each branch.
[[nodiscard]] ByTies do_ties_lead(const Solid& solid, std::span<const Halfspace> to,
                                  std::size_t most_states, const Watch& watch);

}  // namespace convexact::oracle
