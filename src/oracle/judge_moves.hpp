// SPDX-License-Identifier: MIT
// judge_moves.hpp - judges whether the exchanges after the removals of an order are as the order
// states.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "oracle/facet_match.hpp"

namespace convexact {

/// The first move that is not as stated, or for which this is undecided.
struct MoveFault {
  std::size_t row;  ///< Of the move; counted from 1.
  std::string found, expected;
  bool is_open = false;  ///< Undecided, by comparisons of mean widths only.
};

/// Follows the moves. Each must remove facets that are there and not to be kept, insert as many
/// facets that are not there, leave a bounded solid, and make the measure smaller; a measure that
/// it states must be that of its solid. Every solid is intersected from scratch.
/// @param is_there  Of each facet of the input: whether it is left before the first move.
/// @param center    Strictly inside the input.
/// @throws Error    Stopped.
/// @par Cost        An intersection and an exact measure for each move.
[[nodiscard]] std::optional<MoveFault> find_move_fault(
    const RemovalOrder& order, const NamedFacets& facets, std::span<const Halfspace> halfspaces,
    std::vector<bool> is_there, const RationalPoint& center, const JudgeOptions& options);

}  // namespace convexact
