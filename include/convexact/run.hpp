// SPDX-License-Identifier: MIT
// run.hpp - the record of a run: which halfspaces were removed, in which order, at what cost.
#pragma once
#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "convexact/halfspace.hpp"
#include "convexact/number.hpp"
#include "convexact/point_set.hpp"

namespace convexact {

/// Which cap an engine looked at, and when. Costs never decrease, so what an evaluation shows stays
/// a lower bound; with every evaluation that an engine made, each of its choices can be proven.
struct Evaluation {
  std::size_t step;  ///< Removals made before it.
  HalfspaceId halfspace;
  std::vector<HalfspaceId> ring;        ///< One-ring of `halfspace` at that time.
  std::vector<DualTriangle> triangles;  ///< T_i: what would fill the ring.
};

/// One removal.
struct Step {
  HalfspaceId removed;
  Rational cost;                  ///< Exact volume of the cap, in cubed length units.
  std::vector<HalfspaceId> tie;   ///< All of equal exact cost, `removed` first (the lowest id).
  std::vector<HalfspaceId> ring;  ///< One-ring of `removed` before the step.
  std::vector<DualTriangle> triangles;  ///< T_i: the ring's new triangulation.
  std::size_t left;                     ///< Halfspaces after the step.
};

/// Why a run ended.
enum class StopReason {
  Reached,       ///< The wanted number of halfspaces, or it was already met.
  GrowthLimit,   ///< The next step would exceed the wanted growth of volume.
  AllUnbounded,  ///< Every further removal is unbounded.
};

/// A progressive simplification: any prefix of `steps` is a valid result.
struct Trace {
  std::vector<Halfspace> halfspaces;  ///< In canonical order, no redundant ones; ids are positions.
  std::vector<Step> steps;
  StopReason stop = StopReason::Reached;

  /// Ids that are left after the first `count` steps, ascending.
  std::vector<HalfspaceId> survivors(std::size_t count) const;
  std::vector<HalfspaceId> survivors() const { return survivors(steps.size()); }
};

/// A trace and where it led.
struct Simplification {
  Trace trace;
  /// The dual hull of the halfspaces that are left, for to_polytope().
  std::vector<DualTriangle> triangles;
  /// Every evaluation in the order in which it was made; empty unless it was asked for.
  std::vector<Evaluation> evaluations = {};
};

/// How much of each step is proven again; see docs/verification.md.
enum class VerifyLevel {
  None,   ///< Nothing; for experiments only.
  Local,  ///< The step itself: its disk, its signs, its cap, its witnesses.
  Full,   ///< In addition the whole dual, every hull vertex, and the volume.
};

struct SimplifyOptions {
  /// Stop at this many halfspaces; at least 4. At or above the input's number: nothing happens.
  std::size_t faces = 4;
  /// Stop before the volume exceeds (1 + max_growth) times the input's; >= 0.
  std::optional<Rational> max_growth = {};
  /// Of the random choices; the removals and their costs do not depend on it.
  std::uint64_t seed = 1;
  VerifyLevel verify = VerifyLevel::Local;
  /// Keep the evaluations of every removal; docs/proof-format.md has their use.
  bool keep_evaluations = false;
  /// Called after every step with the number of halfspaces left.
  std::function<void(std::size_t left)> progress = {};
  /// When it becomes true, the run ends with Error(Stopped). May be set by a signal handler.
  const std::atomic<bool>* stop = nullptr;
};

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

}  // namespace convexact
