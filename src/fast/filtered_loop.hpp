// SPDX-License-Identifier: MIT
// filtered_loop.hpp - the lazy greedy loop of the filtered engine, step by step.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "convexact/number.hpp"
#include "convexact/run.hpp"
#include "fast/cap.hpp"
#include "fast/checks.hpp"
#include "fast/engines.hpp"
#include "fast/keyed_queue.hpp"
#include "fast/mesh.hpp"
#include "fast/tie_set.hpp"
#include "fast/ties.hpp"
#include "number/double_double.hpp"

namespace convexact {

/// The growth that max_growth still allows: what the steps add to growth_measure() stays within
/// that share of its initial value. Enclosures decide it; where they overlap, the exact measures
/// do.
class GrowthBudget {
 public:
  /// @param options  Without max_growth everything is allowed, and no measure is computed.
  /// @throws Error   InvalidArgument if max_growth is negative.
  GrowthBudget(const FastDual& dual, const SimplifyOptions& options);

  /// Whether a step of this cost, in that measure and in units of 2^dual.cost_exponent() of it, may
  /// follow those that were added; none if the enclosures overlap, so that exact measures have to
  /// decide.
  [[nodiscard]] std::optional<bool> allows(const Interval<double>& cost) const;
  /// The same by the exact measure before the step and its exact cost.
  [[nodiscard]] bool allows_exactly(Cost before, const Cost& cost);
  /// If that was undecided: the bits of its enclosures; else 0.
  long undecided_bits() const { return undecided_bits_; }
  void add(const Interval<double>& cost) { grown_ = grown_with(cost); }

 private:
  Interval<double> grown_with(const Interval<double>& cost) const {
    return {next_below(grown_.lower + cost.lower), next_above(grown_.upper + cost.upper)};
  }

  const FastDual& dual_;
  const SimplifyOptions& options_;
  Interval<double> limit_{0, 0};  // max_growth times the initial measure
  Interval<double> grown_{0, 0};  // the costs so far
  long undecided_bits_ = 0;
  std::optional<Cost> exact_limit_;  // (1 + max_growth) times that measure
};

/// The queue holds, for every halfspace that is not to be kept and whose removal may be bounded, a
/// lower bound of its cost, in units of FilteredCap's bounds. When its ring changes, the entry is
/// *stale*, and evaluated again only when it comes near the top [Minoux1978]. That needs bounds
/// that stay true. A cost by volume never decreases, so its bound stays true. Costs by area and
/// mean width may fall; but those of their terms that do not name a removed plane do not fall, so
/// the bound of a stale entry is the sum of these terms.
class FilteredLoop {
 public:
  /// @param observer  Receives every sign and bound; null costs nothing.
  FilteredLoop(const FastDual& dual, const SimplifyOptions& options,
               CostObserver* observer = nullptr);

  /// @param steps  If not null, the full record of every step is appended.
  FastResult run(std::vector<Step>* steps = nullptr);

  /// Halfspaces that are left.
  std::size_t left() const { return left_; }
  /// The loop step by step, for callers that advance several loops, or choose the removals and the
  /// end in another way. First:
  void evaluate_all();
  /// The next removal with its bounds; none if no removal is bounded. Until it is made, cost() may
  /// be called for this removal only.
  std::optional<FastStep> next();
  /// The amount that next() adds to the measure whose growth is limited, in units of
  /// 2^dual.cost_exponent() of that measure; and exactly, in the caller's units.
  Interval<double> added_by(const FastStep& step);
  Cost exactly_added_by(const FastStep& step);
  /// A measure of the solid that is left, exactly.
  Cost measure(CostMeasure kind) const;
  /// Makes next(). @param steps  As for run().
  void make(const FastStep& step, std::vector<Step>* steps = nullptr);
  /// After the last step.
  FastResult finish(StopReason stop);

  /// The cheapest, first in canonical order; none if every removal is unbounded.
  std::optional<HalfspaceId> choose();
  /// After choose(): all that cost as little, in canonical order.
  std::vector<HalfspaceId> tie() const { return tie_.list(); }
  /// After choose(): why these count as equal; empty for a single one.
  const TieEvidence& tie_evidence() const { return evidence_; }
  /// Whether the removal of i, which is still there and not to be kept, is bounded.
  bool is_bounded(HalfspaceId i);
  /// Precondition: is_bounded(i).
  const Cost& cost(HalfspaceId i) { return ties_.exact_cost(i); }
  /// Precondition: is_bounded(i).
  void remove(HalfspaceId i);

 private:
  // What the first look at all caps finds about one; found by id.
  struct FirstBounds {
    CostBounds<double> bounds;
    std::vector<LastingTerm> terms;
  };
  void look_at_some(FilteredCap& cap, std::span<const HalfspaceId> some,
                    std::vector<FirstBounds>& found) const;
  std::vector<FirstBounds> look_at_all(std::span<const HalfspaceId> all);
  void evaluate(HalfspaceId i);
  void refine(HalfspaceId i);
  void set_bounds(HalfspaceId i, const DoubleDouble& lower, const DoubleDouble& upper);
  Interval<double> bounds_in_doubles(HalfspaceId i) const;
  void drop(HalfspaceId i);

  bool are_bounds_close(HalfspaceId i) const;
  bool tighten_top();
  bool collect_candidates();
  bool refresh_candidates();
  bool refine_candidates();
  void keep_lowest_bounds();
  void keep_cheapest();
  std::optional<HalfspaceId> choose_from_queue();
  void remember_tie();
  bool is_tie_left();

  FastStep describe(HalfspaceId i) const;
  Step record(HalfspaceId i);
  bool is_within(GrowthBudget& growth, const FastStep& step);
  void verify(HalfspaceId i);
  void list_new_triangles();

  const FastDual& dual_;
  const SimplifyOptions& options_;
  HalfEdgeMesh mesh_;
  FastCounts counts_;
  FilteredCap cap_;
  std::optional<FilteredCap> limited_cap_;  // if the growth of another measure is limited
  TieBreaker ties_;
  KeyedQueue<DoubleDouble> queue_;  // mirror images and facets of cylinders agree in doubles
  std::vector<DoubleDouble> upper_;
  std::vector<bool> stale_;
  std::vector<std::vector<LastingTerm>> terms_;     // empty if the measure is the volume
  std::vector<HalfspaceId> candidates_, compared_;  // while the cheapest is sought
  std::vector<TieSet::Class> classes_;              // likewise
  TieSet tie_;                                      // after choose()
  TieEvidence evidence_;                            // of the tie
  std::vector<HalfspaceId> changed_;                // rings of removals since the last choice
  StepCheck check_;
  std::vector<HalfspaceId> across_;
  std::vector<DualTriangle> new_triangles_;
  std::size_t left_;
  bool is_observed_;
  SignCounts other_signs_;  // decided by other caps than cap_
  FastResult result_;
};

/// The loop with the full record of every step, from a separate dual.
class RecordedLoop {
 public:
  /// @param dual_hull, options  Must outlive the object.
  RecordedLoop(const DualHull& dual_hull, const RationalPoint& center,
               const SimplifyOptions& options);

  const FastDual& dual() const { return dual_; }
  FilteredLoop& loop() { return loop_; }
  /// Where the loop is to record its steps.
  std::vector<Step>* steps() { return &run_.steps; }
  /// The record. @param result  What the loop returned.
  Run finish(FastResult result);

 private:
  // Records the caps that the loop evaluates. Bounds in DoubleDouble are for the same caps again.
  class Recorder : public CostObserver {
   public:
    /// @param run  Its steps are as many as were made so far.
    explicit Recorder(Run& run) : run_(run) {}
    void in_doubles(HalfspaceId i, const OneRing& ring, const std::vector<RingTriangle>& triangles,
                    const CostBounds<double>&) override;

   private:
    Run& run_;
  };

  FastDual dual_;
  Run run_;
  Recorder recorder_;
  FilteredLoop loop_;
};

}  // namespace convexact
