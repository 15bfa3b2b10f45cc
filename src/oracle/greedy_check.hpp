// SPDX-License-Identifier: MIT
// greedy_check.hpp - whether every removal of a run was the cheapest where it was made.
#pragma once
#include <atomic>
#include <optional>
#include <vector>

#include "convexact/dual.hpp"
#include "oracle/divergence.hpp"

namespace convexact {

/// Follows a run to its end and finds every step where the filtered engine, in the state that *the
/// run* had reached, would have removed another halfspace. So runs that parted for good over a
/// tie are still judged, each choice of the one by what it could choose from.
///
/// In each divergence `reference` is the filtered engine's choice and `other` the run's. The set of
/// the cheapest comes from the filtered engine, and with it the costs of ties; every other
/// divergence is judged by the definition (judge_choices()). A removal that leaves an unbounded
/// solid is the last one to be judged.
/// @param dual    What the run started from.
/// @param center  Strictly inside.
/// @param stop    When it becomes true: Error Stopped.
/// @par Cost      A run of the filtered engine; for each tie a cap as a rational, for other
///                divergences the cost of judge_choices().
[[nodiscard]] std::vector<Divergence> check_greedy(const DualHull& dual,
                                                   const RationalPoint& center, const Run& run,
                                                   const std::atomic<bool>* stop = nullptr);

/// The first of these divergences that is no tie; none if every removal was one of the cheapest.
/// @par Cost      As check_greedy() up to that step, with at most one judge_choices().
[[nodiscard]] std::optional<Divergence> first_wrong_step(const DualHull& dual,
                                                         const RationalPoint& center,
                                                         const Run& run,
                                                         const std::atomic<bool>* stop = nullptr);

}  // namespace convexact
