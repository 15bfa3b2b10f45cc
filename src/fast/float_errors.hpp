// SPDX-License-Identifier: MIT
// float_errors.hpp - how far a run of the float engine can be from one in exact numbers, proven
// while it runs.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "convexact/run.hpp"
#include "fast/cap.hpp"
#include "fast/keyed_queue.hpp"
#include "number/roundoff.hpp"

namespace convexact {

/// Keeps the FloatBound of a run. All costs are cost_multiple() times as large, in units of the
/// dual.
///
/// A removal is judged by the upper bound of its cost and by the least of all others' lower bounds.
/// Each halfspace keeps the best lower bound that is proven for it, 0 at first. Those of volumes
/// stay true when rings change, since costs never decrease; others are lowered to what lasts.
class FloatErrors {
 public:
  explicit FloatErrors(std::size_t halfspaces, CostMeasure measure = CostMeasure::Volume);

  /// The cap of i has been evaluated: its cost is enclosed. Unbounded caps are (inf, inf), caps
  /// without a proven bound (0, inf).
  void enclose(HalfspaceId i, double lower, double upper) {
    upper_[i.index()] = upper;
    if (lower > lower_.key(i)) lower_.update(i, lower);
  }
  /// A halfspace of the ring of i was removed: of the bounds proven before, `lasting` is left. Caps
  /// that are unbounded stay so.
  void lower(HalfspaceId i, double lasting) {
    const double key = lower_.key(i);
    if (lasting < key && !std::isinf(key)) lower_.update(i, lasting);
  }
  /// The canonical order decides a step.
  void count_tie() { ++bound_.ties; }
  /// i is removed, at what is reported as its cost.
  void remove(HalfspaceId i, double cost);
  /// After the last step. @param is_stuck  Whether it was the last for want of bounded removals.
  FloatBound bound(bool is_stuck) const;

 private:
  KeyedQueue<double> lower_;
  std::vector<double> upper_;
  Interval<double> multiple_;
  FloatBound bound_;
};

inline FloatErrors::FloatErrors(std::size_t halfspaces, CostMeasure measure)
    : lower_(halfspaces),
      upper_(halfspaces, std::numeric_limits<double>::infinity()),
      multiple_(cost_multiple(measure)) {
  for (std::size_t i = 0; i < halfspaces; ++i) lower_.append(HalfspaceId(i), 0);
}

inline void FloatErrors::remove(HalfspaceId i, double cost) {
  const double upper = upper_[i.index()], lower = lower_.key(i);
  lower_.erase(i);
  // Off by the bounds of the enclosure, and by the division by the multiple, which may be rounded.
  const double of_quotient =
      2 * kUnitRoundoff + (multiple_.upper - multiple_.lower) / multiple_.lower;
  const double error =
      next_above(next_above(std::max(upper - cost, cost - lower)) / lower) + of_quotient;
  const double regret =
      lower_.empty() ? 0 : next_above(next_above(upper / lower_.key(lower_.top())) - 1);
  if (!(error <= FloatBound::kMost && regret <= FloatBound::kMost)) {
    ++bound_.doubtful;
    return;
  }
  bound_.cost = std::max(bound_.cost, error);
  bound_.regret = std::max(bound_.regret, regret);
}

inline FloatBound FloatErrors::bound(bool is_stuck) const {
  FloatBound bound = bound_;
  const double least = lower_.key(lower_.top());
  bound.least_next = std::isinf(least) ? least : next_below(least / multiple_.upper);
  bound.is_end_proven = !is_stuck || std::isinf(least);
  return bound;
}

}  // namespace convexact
