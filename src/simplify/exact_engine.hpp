// SPDX-License-Identifier: MIT
// exact_engine.hpp - the greedy simplification in exact arithmetic: the reference engine.
#pragma once
#include <memory>

#include "convexact/dual.hpp"
#include "convexact/run.hpp"
#include "simplify/dual_surface.hpp"
#include "simplify/step_verification.hpp"

namespace convexact {

/// Sees the greedy loop, for lessons. Calls about the triangulation of a ring belong to the
/// evaluation reported next; calls about checks belong to the step chosen last.
class RunObserver : public RingObserver, public CheckObserver {
 public:
  /// @param step  Removals made before.
  virtual void evaluated(std::size_t step, const Removal& removal) = 0;
  /// A step that is about to be verified and made.
  virtual void chosen(const Step& step) = 0;
};

/// Removes one halfspace after another, each time the one whose removal adds the least to the
/// measure of the options; of equal ones the first in canonical order. Every sign and every cost is
/// exact. Mean widths whose comparison is undecided count as equal, and the step says so.
/// @param dual    The dual hull of the input.
/// @param center  Strictly inside the solid. Costs and ties do not depend on it.
/// @throws Error  InvalidArgument if options.faces < 4, options.max_growth < 0, or the center is
///                not strictly inside; Stopped if the watch ends it; Internal if a verification
///                fails.
/// @par Cost      Expected O(k) exact operations per evaluated cap of a ring of k; each step
///                evaluates the caps of one ring.
/// @par Source    [Jacobson2026]
[[nodiscard]] Run simplify_exact(const DualHull& dual, const RationalPoint& center,
                                 const SimplifyOptions& options = {});

/// The same run, watched. @param observer  Sees each evaluation, each step and its checks; null for
///                                         none.
[[nodiscard]] Run simplify_exact(const DualHull& dual, const RationalPoint& center,
                                 const SimplifyOptions& options, RunObserver* observer);

/// The run of simplify_exact(), step by step, for a loop that advances several of them and decides
/// when they end.
class ExactRun {
 public:
  /// As simplify_exact(). The arguments must outlive the object.
  ExactRun(const DualHull& dual, const RationalPoint& center, const SimplifyOptions& options,
           RunObserver* observer = nullptr);
  ExactRun(const ExactRun&) = delete;
  ExactRun& operator=(const ExactRun&) = delete;
  ~ExactRun();

  /// Halfspaces that are left.
  std::size_t left() const;
  /// The next removal, found at the first call after each make(); null if there is no bounded one.
  const Step* next();
  /// The amount that it adds to any measure. Precondition, as for make(): next() is not null.
  Cost added(CostMeasure measure);
  void make();
  /// A measure of the solid that is left.
  Cost measure(CostMeasure kind) const;
  /// The record, with the reason why the loop ends.
  Run finish(StopReason stop);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace convexact
