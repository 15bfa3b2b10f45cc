// SPDX-License-Identifier: MIT
// run.hpp - the record of a run: which halfspaces were removed, in which order, at what cost.
#pragma once
#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "convexact/cost.hpp"
#include "convexact/halfspace.hpp"
#include "convexact/number.hpp"
#include "convexact/point_set.hpp"

namespace convexact {

/// How an answer is computed.
enum class Engine {
  Exact,     ///< Rationals and integers everywhere: the reference.
  Filtered,  ///< The same answer; exact numbers only where doubles cannot decide.
  Float,     ///< Doubles decide which removals are made. All statements about the result are still
             ///< proven.
};

/// The evidence that several removals cost the same: the least certain one of their proofs, in the
/// order of TieProof, with the most bits that any comparison of them took.
struct TieEvidence {
  std::optional<TieProof> proof = {};  ///< None if there is no tie.
  long bits = 0;                       ///< Of enclosures, if the proof is Undecided.

  void add(const TieEvidence& other) {
    if (other.proof && (!proof || *proof < *other.proof)) proof = other.proof;
    bits = std::max(bits, other.bits);
  }
};

/// How the ties of a run were proven.
struct TieTally {
  std::array<std::size_t, 6> steps{};  ///< Steps with a tie, by their TieProof.
  long bits = 0;                       ///< Of the finest enclosures that still overlapped.

  void add(const TieEvidence& evidence) {
    if (evidence.proof) ++steps[static_cast<std::size_t>(*evidence.proof)];
    if (evidence.proof == TieProof::Undecided) bits = std::max(bits, evidence.bits);
  }
};

/// One removal. Parts that were not requested are empty.
struct Step {
  HalfspaceId removed;
  std::optional<Cost> cost = {};       ///< Exact. None if it is not known, or not bounded.
  std::vector<HalfspaceId> tie = {};   ///< All of equal cost, `removed` first (the lowest id).
  std::vector<HalfspaceId> ring = {};  ///< One-ring of `removed` before the step.
  std::vector<DualTriangle> triangles = {};  ///< T_i: the ring's new triangulation.
  std::size_t left = 0;                      ///< Halfspaces after the step.
  TieEvidence tie_evidence = {};             ///< Why the costs of `tie` count as equal.
};

/// Halfspaces left by a run, exchanged for removed ones so that the measure falls.
struct Move {
  std::vector<HalfspaceId> removed, inserted;  ///< Ascending, equally many.
  std::optional<Cost> measure = {};  ///< Of the solid after it, exactly; if it was asked for.
};

/// Why a run ended.
enum class StopReason {
  Reached,             ///< The wanted number of halfspaces, or it was already met.
  GrowthLimit,         ///< The next step would exceed the wanted growth of the measure.
  AllUnbounded,        ///< Every further removal is unbounded.
  AllKeptOrUnbounded,  ///< The same of all that are not to be kept, in a run that keeps some.
};

/// A cap that an engine evaluated, and when. A volume never decreases, and those terms of an area
/// that do not name a removed plane do not either, so an evaluation shows a lower bound for later
/// steps; with every evaluation that an engine made, each of its choices can be proven.
struct Evaluation {
  std::size_t step;  ///< Removals made before it.
  HalfspaceId halfspace;
  std::vector<HalfspaceId> ring;        ///< One-ring of `halfspace` at that time.
  std::vector<DualTriangle> triangles;  ///< T_i, which would fill the ring.
};

/// The record of a progressive simplification: any prefix of `steps` is a valid result. Engines
/// make it, a trace or a proof is its written form, and replay() and the judges read it.
struct Run {
  std::vector<Halfspace> halfspaces;  ///< In canonical order, no redundant ones; ids are positions.
  std::vector<HalfspaceId> kept = {};  ///< Never removed, and no removal is compared with theirs.
  std::vector<Step> steps;
  StopReason stop = StopReason::Reached;
  /// The bits of the enclosures if neither they nor a proof could tell whether the next step stays
  /// within the growth limit, so that it was not made. 0 if that was decided.
  long growth_bits = 0;
  CostMeasure measure = CostMeasure::Volume;  ///< Of the costs.
  /// Whether each removal is claimed to be the cheapest of its time; then each has its tie list.
  bool is_greedy = true;
  /// The dual hull of the halfspaces that are left, for to_polytope(); empty if it is not known.
  std::vector<DualTriangle> triangles = {};
  /// Every evaluation in the order in which it was made; empty unless it was asked for.
  std::vector<Evaluation> evaluations = {};
  /// Made after the steps; `triangles` and the functions below are about the steps.
  std::vector<Move> moves = {};
  /// Whether the volume after the moves is proven to be the least of as many halfspaces.
  bool is_least = false;
};

/// The halfspaces that the first `count` steps of a run removed, in the order of removal.
[[nodiscard]] std::vector<HalfspaceId> removed_in(const Run& run, std::size_t count);
[[nodiscard]] inline std::vector<HalfspaceId> removed_in(const Run& run) {
  return removed_in(run, run.steps.size());
}

/// Ids that are left after the first `count` steps, ascending.
[[nodiscard]] std::vector<HalfspaceId> survivors(const Run& run, std::size_t count);
[[nodiscard]] inline std::vector<HalfspaceId> survivors(const Run& run) {
  return survivors(run, run.steps.size());
}

/// The halfspaces, in their order, without those that are removed. @param removed  Positions.
[[nodiscard]] std::vector<Halfspace> left_after(std::span<const Halfspace> halfspaces,
                                                std::span<const HalfspaceId> removed);
/// The halfspaces that are left after the first `count` steps, in canonical order.
[[nodiscard]] std::vector<Halfspace> left_after(const Run& run, std::size_t count);

/// How much of each step is proven again; see docs/verification.md.
enum class VerifyLevel {
  None,   ///< Nothing; for experiments only.
  Local,  ///< The step itself: its disk, its signs, its cap, its witnesses.
  Full,   ///< In addition the whole dual, every hull vertex, and the volume.
};

struct SimplifyOptions {
  /// Stop at this many halfspaces; at least 4. At or above the input's number the run has no steps.
  std::size_t faces = 4;
  /// Halfspaces that are not removed, whatever they cost; they are in no queue and in no tie.
  std::vector<HalfspaceId> keep = {};
  /// The measure to which each removal is to add the least.
  CostMeasure cost = CostMeasure::Volume;
  /// For comparisons of mean widths.
  CompareLimits compare = {};
  /// Stop before the measure growth_measure() exceeds (1 + max_growth) times the input's; >= 0.
  /// Where a comparison of mean widths is undecided, it counts as exceeding.
  std::optional<Rational> max_growth = {};
  /// The measure that max_growth limits; unset: `cost`. The float engine accepts no other measure
  /// than `cost`.
  std::optional<CostMeasure> growth_of = {};
  /// For the random choices; the removals and their costs do not depend on it.
  std::uint64_t seed = 1;
  VerifyLevel verify = VerifyLevel::Local;
  /// Keep the evaluations of every removal; docs/proof-format.md has their use.
  bool keep_evaluations = false;
  /// Called after every step with the number of halfspaces left.
  std::function<void(std::size_t left)> progress = {};
  /// When it becomes true, the run ends with Error(Stopped). May be set by a signal handler.
  const std::atomic<bool>* stop = nullptr;

  CostMeasure growth_measure() const { return growth_of.value_or(cost); }
  /// Why a run ends when it finds no bounded removal.
  StopReason when_stuck() const {
    return keep.empty() ? StopReason::AllUnbounded : StopReason::AllKeptOrUnbounded;
  }
};

/// How far a run of the float engine can be from one in exact numbers. Proven, except for
/// `doubtful` steps, of which it is only known that they lead to a bounded solid around the input.
struct FloatBound {
  /// A step counts as doubtful if one of its bounds is not proven to be at most this: a thousandth.
  static constexpr double kMost = 0x1p-10;

  double cost = 0;            ///< Each reported cost is within this share of the true one.
  double regret = 0;          ///< Each removal costs at most (1 + regret) times the cheapest one
                              ///< that was possible then.
  std::size_t doubtful = 0;   ///< Steps of which these two are not proven.
  double least_next = 0;      ///< A lower bound of the cost of any further removal, as the steps'
                              ///< costs; infinite if all are proven to be unbounded.
  std::size_t ties = 0;       ///< Steps in which doubles could not tell which removal is the
                              ///< cheapest, so that the canonical order decided.
  bool is_end_proven = true;  ///< Whether exact numbers, too, would have ended the run there.

  /// Whether everything is proven. If not, the filtered engine gives a proven answer.
  [[nodiscard]] bool is_vouched() const { return doubtful == 0 && is_end_proven; }
};

}  // namespace convexact
