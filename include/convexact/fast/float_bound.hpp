// SPDX-License-Identifier: MIT
// float_bound.hpp - what the float engine proves of its own errors while it runs.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "convexact/fast/lazy_queue.hpp"
#include "convexact/fast/outward.hpp"

namespace convexact {

/// How far a run of the float engine can be from one in exact numbers. Proven, but for `doubtful`
/// steps, of which nothing is known but that they lead to a bounded solid around the input.
struct FloatBound {
  /// A step of which no more than this can be proven counts as doubtful: a thousandth.
  static constexpr double kMost = 0x1p-10;

  double cost = 0;           ///< Each reported cost is within this share of the true one.
  double regret = 0;         ///< Each removal costs at most (1 + regret) times the cheapest one
                             ///< that was possible then.
  std::size_t doubtful = 0;  ///< Steps of which these two are not proven.
  double least_next = 0;     ///< What any further removal would cost at least, as the steps' costs;
                             ///< infinite if all are proven to be unbounded.
  std::size_t ties = 0;      ///< Steps in which doubles could not tell the cheapest, so that the
                             ///< canonical order decided.
  bool is_end_proven = true;  ///< Whether exact numbers, too, would have ended the run there.

  /// Whether everything is proven. If not, the filtered engine knows.
  [[nodiscard]] bool is_vouched() const { return doubtful == 0 && is_end_proven; }
};

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
