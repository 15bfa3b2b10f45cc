// SPDX-License-Identifier: MIT
// run.hpp - the record of a run, what it is asked for, and the facets that it keeps.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "convexact/cost.hpp"
#include "convexact/error.hpp"
#include "convexact/geometry.hpp"
#include "convexact/hull.hpp"
#include "convexact/number.hpp"

namespace convexact {

// ---- The facets of a solid that a run must not remove: by id, plane, normal or face.

/// Facets by their positions in canonical order.
struct KeepIds {
  std::vector<HalfspaceId> ids;
};

/// The facet in the plane n.x + d = 0, n outward, up to a positive factor.
struct KeepPlane {
  RationalVector3 normal;
  Rational offset;
};

/// The facets whose outward normal is at most so many degrees away from a direction; without an
/// angle those nearest to it, all of them if several are equally near.
///
/// 0 degrees is the direction itself, exactly. The cosine of any other angle is rounded down to a
/// double, and every facet is decided exactly with that number: a facet at exactly this angle is
/// selected.
struct KeepNormal {
  RationalVector3 direction;      ///< Not zero, of any length.
  std::optional<double> degrees;  ///< 0 to 180.
};

/// The facets whose planes hold all corners of one of these faces of the input.
struct KeepFaces {
  std::vector<std::vector<std::uint32_t>> polygons;  ///< Of point input: positions of points.
};

struct KeepSelector {
  std::variant<KeepIds, KeepPlane, KeepNormal, KeepFaces> facets;
  std::string text;  ///< Its name in messages.
};

/// The facets that the selectors select together.
/// @param halfspaces  Of the facets, in canonical order.
/// @param points      The points that the faces refer to; empty if the input is halfspaces.
/// @param most        How many may be selected; unset: any number.
/// @return            Ascending, each once.
/// @throws Error      InvalidArgument, with its text, for a selector that selects nothing or refers
///                    to a facet or point that does not exist, for a direction or normal of length
///                    0 and for an angle outside of 0 to 180 degrees; if more are selected than
///                    may be.
/// @par Cost          A sign per facet and direction; for faces one per facet and corner.
[[nodiscard]] std::vector<HalfspaceId> select_facets(std::span<const Halfspace> halfspaces,
                                                     const PointSet& points,
                                                     std::span<const KeepSelector> selectors,
                                                     std::optional<std::size_t> most = {});

// ---- The record of a run: which halfspaces were removed, in which order, at what cost.

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

/// Ids below `size` that are not removed, ascending.
[[nodiscard]] std::vector<HalfspaceId> all_but(std::span<const HalfspaceId> removed,
                                               std::size_t size);

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

/// Ids that moves make of those that are left, ascending as these.
[[nodiscard]] std::vector<HalfspaceId> after_moves(std::vector<HalfspaceId> left,
                                                   std::span<const Move> moves);

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
  /// Threads for the first look at all halfspaces, 1 to 256; nothing depends on it. Of the
  /// filtered engine.
  std::size_t jobs = 1;
  /// Told after each removal of those made and of those that lead to `faces`; ends the run with
  /// Error Stopped.
  Watch watch = {};

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
  std::size_t ties = 0;       ///< Steps in which the least estimates are equal, or of facets that a
                              ///< symmetry relates, so that the canonical order decided.
  bool is_end_proven = true;  ///< Whether exact numbers, too, would have ended the run there.

  /// Whether everything is proven. If not, the filtered engine gives a proven answer.
  [[nodiscard]] bool is_vouched() const { return doubtful == 0 && is_end_proven; }
};

// ---- The record of an inner run: which vertices of a hull were removed, in which order and at
// what loss of volume.  An inner run works in the opposite direction to simplify(): it removes
// vertices, so the solid shrinks and lies inside the hull of the input. docs/design/inner.md has
// the reasons.

/// Position in VertexHull::points. Polarity makes a halfspace of each vertex, and the hull without
/// a vertex is the polar of the solid without that halfspace; so both kinds of run share their ids
/// and the data structures that hold them.
using VertexId = HalfspaceId;
/// Three vertices, counter-clockwise seen from outside.
using VertexTriangle = DualTriangle;

/// The hull of points as an inner run starts with it.
struct VertexHull {
  /// The extreme points in canonical order: by x, then y, then z, compared exactly. Ties are broken
  /// by this order, so no result depends on the order of the input.
  PointSet points;
  std::vector<PointId> ids;               ///< Of `points` in the input; of equal ones the lowest.
  std::vector<VertexTriangle> triangles;  ///< The facets, cut into 2 points.size() - 4 triangles.
};

/// The facets are cut in a zigzag, so that no vertex gets more than two diagonals of a facet.
/// @param hull  Of `points`. @par Cost  O(n log n) comparisons.
[[nodiscard]] VertexHull vertex_hull(const Hull& hull, const PointSet& points);

enum class InnerStop {
  Reached,    ///< The wanted number of vertices, or it was already met.
  LossLimit,  ///< The next step would exceed the loss allowed.
};

/// Any prefix of `steps` is a valid result. Their ids are of vertices. The cost of a step is the
/// volume that the solid loses, none until with_costs(); the removed vertex lies on or beyond the
/// triangles that close its ring; `left` counts vertices, and ties have no evidence, because all
/// volumes are compared exactly.
struct InnerRun {
  std::vector<Step> steps;
  InnerStop stop = InnerStop::Reached;
  std::vector<VertexTriangle> triangles;  ///< The hull of what is left.
};

struct InnerOptions {
  std::size_t vertices = 4;  ///< To keep, at least 4.
  /// Stop before the volume falls below (1 - max_loss) times that of the hull; >= 0.
  std::optional<Rational> max_loss = {};
  std::uint64_t seed = 1;  ///< Of random orders; removals, costs and ties do not depend on it.
  /// Told after each removal of those made and of those that lead to `vertices`; ends the run with
  /// Error Stopped.
  Watch watch = {};
};

/// Vertices that are left after all steps, ascending. @param count  Vertices at the start.
[[nodiscard]] std::vector<VertexId> vertices_left(const InnerRun& run, std::size_t count);

/// The run with the cost of each step that has none, from its triangles, in integers.
[[nodiscard]] InnerRun with_costs(const VertexHull& hull, InnerRun run);

/// Proves each step again, from the lists in the run alone; docs/design/inner.md has the claims.
/// @param level  Full: in addition the whole surface after each step, and the volume before, less
///               the cost, is the volume after, as rationals. It needs the costs.
/// @throws Error Internal, naming the step and the claim, if one fails.
void verify_inner_run(const VertexHull& hull, const InnerRun& run, VerifyLevel level,
                      const Watch& watch = {});

}  // namespace convexact
