// SPDX-License-Identifier: MIT
// removal_order.hpp - somebody's removals, in order, as they stand in a file: not yet known to make
// sense.
#pragma once
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "convexact/geometry/halfspace.hpp"
#include "convexact/simplify/trace.hpp"

namespace convexact {

/// Position in RemovalOrder::facets; anything at or beyond its end names no facet.
using ListedFacet = std::uint64_t;
inline constexpr ListedFacet kNoListedFacet = std::numeric_limits<ListedFacet>::max();

/// What an order says about one of its steps, as far as it does.
struct StepClaim {
  std::optional<Rational> cost;                 ///< Exact, in cubed length units.
  std::optional<std::vector<ListedFacet>> tie;  ///< All of the least cost, in any order.
  std::optional<std::uint64_t> left;            ///< Halfspaces after the step.
};

struct OrderedRemoval {
  std::size_t row;    ///< Row of a text, step of a JSON trace; counted from 1.
  std::string text;   ///< What stands there, for messages.
  ListedFacet facet;  ///< What is removed.
  StepClaim claim = {};
};

/// Removals name planes by their positions in a list. Where a file spells out each plane, the list
/// is what the file spells.
struct RemovalOrder {
  /// None for a row with normal 0: no facet has that plane. Any order, repeats allowed.
  std::vector<std::optional<Halfspace>> facets;
  /// Whether `facets` is a list of its own, whose rows the ids count: not the input's
  /// facets, and not the planes removed.
  bool has_list = false;
  std::vector<OrderedRemoval> removals;
  /// Why it says that it ends. Only AllUnbounded is a claim that can be judged.
  std::optional<StopReason> stop = {};
};

}  // namespace convexact
