// SPDX-License-Identifier: MIT
// divergence.hpp - where a greedy run differs from another run, or from the cheapest removal, and
// which one was right.
#pragma once
#include <optional>
#include <vector>

#include "convexact/dual.hpp"
#include "convexact/error.hpp"
#include "convexact/run.hpp"
#include "convexact/simplify.hpp"
#include "io/names.hpp"
#include "oracle/order/removal_cost.hpp"

namespace convexact {

/// The kind of a difference between two runs, judged by exact costs from the definition.
enum class DivergenceKind {
  Tie,               ///< Equal costs, or mean widths that are not decided to differ; the canonical
                     ///< order should have decided.
  BelowRounding,     ///< Costs so close that planes rounded to doubles cannot tell them apart; or
                     ///< the end where such planes may not bound the cheapest cap.
  WrongTopology,     ///< Costs further apart: its cost cannot come from the right cap.
  WrongBoundedness,  ///< An unbounded removal, or the end although a bounded one existed.
  WrongRecord,       ///< The same removal, but another cost, tie list or reason to end.
};

inline constexpr auto kDivergenceKindNames =
    name_table<DivergenceKind>({{DivergenceKind::Tie, "tie"},
                                {DivergenceKind::BelowRounding, "gap-below-rounding"},
                                {DivergenceKind::WrongTopology, "wrong-topology"},
                                {DivergenceKind::WrongBoundedness, "wrong-boundedness"},
                                {DivergenceKind::WrongRecord, "wrong-record"}});
inline const char* name_of(DivergenceKind kind) { return name_in(kDivergenceKindNames, kind); }

/// The choice of one run at the step where they differ.
struct Choice {
  std::optional<HalfspaceId> removed;  ///< None: it ended here.
  std::optional<Cost> cost;            ///< Exact; none if unbounded or it ended.
};

struct Divergence {
  std::size_t step;  ///< Removals in common, so also the 0-based number of the step.
  std::size_t left;  ///< Halfspaces left before it.
  DivergenceKind kind;
  Choice reference, other;
  /// If false, `other` is at fault. The fault is a higher cost or, in a tie, a higher id.
  bool reference_at_fault = false;
  /// (higher cost - lower cost) / lower cost. None where it is infinite or a cost is missing.
  std::optional<Regret> regret = {};
  /// How large a regret rounding explains: RemovalCost::rounding of both, over the lower cost. None
  /// as for the regret, or if every regret is explained.
  std::optional<Rational> rounding = {};
  bool is_undecided = false;  ///< Of a tie: its costs are not proven to be equal.
};

/// How runs are judged.
struct DivergenceOptions {
  CompareLimits compare = {};  ///< Of mean widths.
  Watch watch = {};            ///< Ends it: Error Stopped.
};

/// Judges, by the definition, two different choices in the state after the first `step` removals of
/// `run`. At least one of them is a removal.
/// @param run     With the halfspaces of the solid; costs are of its measure.
/// @param center  Strictly inside.
/// @throws Error  InvalidArgument if what they leave is unbounded; Stopped when the flag of the
///         options becomes true.
/// @par Cost      Three intersections of the remaining halfspaces, from scratch: expected O(n log
///                n).
[[nodiscard]] Divergence judge_choices(const Run& run, const RationalPoint& center,
                                       std::size_t step, std::optional<HalfspaceId> reference,
                                       std::optional<HalfspaceId> other,
                                       const DivergenceOptions& options = {});

/// The first step where two runs differ; none if they made the same removals, ended for the same
/// reason and, where both kept them, recorded the same costs and ties.
/// @throws Error  InvalidArgument if the runs agree on a prefix that leaves an unbounded solid, or
/// are of different measures. Otherwise as judge_choices().
[[nodiscard]] std::optional<Divergence> find_divergence(const RationalPoint& center,
                                                        const Run& reference, const Run& other,
                                                        const DivergenceOptions& options = {});

/// Whether both runs kept costs and tie lists, so that these were compared too.
[[nodiscard]] bool have_records(const Run& a, const Run& b);

/// The worst one of a non-empty list: by kind, in the order of DivergenceKind, then by regret; the
/// first of equals. A missing regret counts as larger than any.
[[nodiscard]] const Divergence& worst_of(std::span<const Divergence> divergences);

/// Whether the engine at fault may differ like this: only the float engine may, and only where
/// costs are equal or too close for doubles.
[[nodiscard]] bool is_explained(const Divergence& divergence, Engine reference, Engine other);

/// Follows a run to its end and finds every step where the filtered engine, in the state that *the
/// run* had reached, would have removed another halfspace. So runs that differ for good after a tie
/// are still judged: each choice of a run is compared with the choices that it had.
///
/// In each divergence `reference` is the filtered engine's choice and `other` the run's. The set of
/// the cheapest comes from the filtered engine, and with it the costs of ties; every other
/// divergence is judged by the definition (judge_choices()). A removal that leaves an unbounded
/// solid is the last one to be judged.
/// @param dual    The dual from which the run started.
/// @param center  Strictly inside.
/// @throws Error  Stopped when the flag of the options becomes true.
/// @par Cost      A run of the filtered engine; for each tie a cap as a rational, for other
///                divergences the cost of judge_choices().
[[nodiscard]] std::vector<Divergence> check_greedy(const DualHull& dual,
                                                   const RationalPoint& center, const Run& run,
                                                   const DivergenceOptions& options = {});

/// The first of these divergences that is no tie; none if every removal was one of the cheapest.
/// @par Cost      As check_greedy() up to that step, with at most one judge_choices().
[[nodiscard]] std::optional<Divergence> first_wrong_step(const DualHull& dual,
                                                         const RationalPoint& center,
                                                         const Run& run,
                                                         const DivergenceOptions& options = {});

}  // namespace convexact
