// SPDX-License-Identifier: MIT
// float_bound.hpp - what the float engine proves of its own errors while it runs.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "convexact/run.hpp"
#include "fast/lazy_queue.hpp"
#include "fast/outward.hpp"

namespace convexact {

/// Keeps FloatBound during a run. All costs are times six, in units of the dual.
///
/// A removal is judged by the upper end of its cost and by the least of all others' lower ends. The
/// latter stay true when rings change, since costs never decrease; so each halfspace keeps the best
/// lower end that was ever proven for it, 0 at first.
class FloatWatch {
 public:
  explicit FloatWatch(std::size_t halfspaces)
      : lower_(halfspaces), upper_(halfspaces, std::numeric_limits<double>::infinity()) {
    for (std::size_t i = 0; i < halfspaces; ++i) lower_.append(HalfspaceId(i), 0);
  }

  /// The cap of i has been looked at: its cost is enclosed. Unbounded caps are (inf, inf), caps of
  /// which nothing is proven (0, inf).
  void note(HalfspaceId i, double lower, double upper) {
    upper_[i.index()] = upper;
    if (lower > lower_.key(i)) lower_.update(i, lower);
  }
  /// The canonical order decides a step.
  void note_tie() { ++bound_.ties; }
  /// i goes, at what is reported as its cost.
  void remove(HalfspaceId i, double cost) {
    const double upper = upper_[i.index()], lower = lower_.key(i);
    lower_.erase(i);
    // Off by the ends of the enclosure, and by the division by six.
    const double error =
        next_above(next_above(std::max(upper - cost, cost - lower)) / lower) + 0x1p-52;
    const double regret =
        lower_.empty() ? 0 : next_above(next_above(upper / lower_.key(lower_.top())) - 1);
    if (!(error <= FloatBound::kMost && regret <= FloatBound::kMost)) {
      ++bound_.doubtful;
      return;
    }
    bound_.cost = std::max(bound_.cost, error);
    bound_.regret = std::max(bound_.regret, regret);
  }
  /// After the last step. @param is_stuck  Whether it was the last for want of bounded removals.
  FloatBound finish(bool is_stuck) const {
    FloatBound bound = bound_;
    const double least = lower_.key(lower_.top());
    bound.least_next = std::isinf(least) ? least : next_below(least / 6);
    bound.is_end_proven = !is_stuck || std::isinf(least);
    return bound;
  }

 private:
  KeyedQueue<double> lower_;
  std::vector<double> upper_;
  FloatBound bound_;
};

}  // namespace convexact
