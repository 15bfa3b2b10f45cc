// SPDX-License-Identifier: MIT
// verify_order.hpp - is an order of removals greedy? Decided exactly, step by step.
#pragma once
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "convexact/cost.hpp"
#include "convexact/dual.hpp"
#include "convexact/error.hpp"
#include "convexact/geometry.hpp"
#include "convexact/run.hpp"
#include "convexact/verify.hpp"

namespace convexact {

/// An id at or beyond the end of RemovalOrder::facets names no facet.
inline constexpr HalfspaceId kNoFacet{std::numeric_limits<std::uint32_t>::max()};

/// A step as a file states it, and its place. The statements of the file beyond the removal are
/// claims: the cost, if there is one, and the tie, in any order, and `left`, if they are claimed.
struct OrderedStep {
  std::size_t row;   ///< Row of a text, step of a JSON trace; counted from 1.
  std::string text;  ///< The text at that place, for messages.
  Step step = {};    ///< Ids are positions in RemovalOrder::facets.
  bool claims_tie = false, claims_left = false;
};

/// The steps of a run as another program states them. Ids are positions in a list of planes. Where
/// a file spells out each plane, the list is what the file spells.
struct RemovalOrder {
  /// None for a row with normal 0: no facet has that plane. Any order, repeats allowed.
  std::vector<std::optional<Halfspace>> facets;
  /// Whether `facets` is a separate list, whose rows the ids count: not the input's facets, and not
  /// the planes removed.
  bool has_list = false;
  std::vector<OrderedStep> steps;
  /// Each removal is to add the least to this measure. Costs that steps state are of it.
  CostMeasure measure = CostMeasure::Volume;
  /// The stated reason of its end. Only that nothing could be removed is a claim to be judged.
  std::optional<StopReason> stop = {};
  /// The facets that it states to keep, in any order; none if it states nothing.
  std::optional<std::vector<HalfspaceId>> kept = {};
  /// Exchanges after the steps, by positions in `facets`; a measure is a claim.
  std::vector<Move> moves = {};
};

/// The share by which one cost exceeds another: of volumes the number itself, of areas and mean
/// widths the number itself where it is 0, otherwise an interval.
class Regret {
 public:
  Regret(Rational exact) : value_(std::move(exact)) {}  // NOLINT: a rational is a share
  explicit Regret(Enclosure bounds) : value_(std::move(bounds)) {}

  /// The number itself; null if only an interval is known.
  const Rational* exact() const { return std::get_if<Rational>(&value_); }
  /// The same. @throws Error InvalidArgument if only an interval is known.
  const Rational& rational() const;
  /// An interval around it: of 128 bits around a rational.
  Enclosure bounds() const;
  double near_double() const;  ///< The nearest double of a rational, else one within the interval.
  double high_double() const;  ///< A double that is not below it.
  /// Whether it is known to be more than 0.
  bool is_positive() const { return exact() != nullptr ? *exact() > 0 : bounds().low() > 0; }
  /// Whether it is known to be more than another one: intervals that overlap say no.
  bool is_above(const Regret& other) const;

  friend bool operator==(const Regret& a, const Rational& b) {
    return a.exact() != nullptr && *a.exact() == b;
  }

 private:
  std::variant<Rational, Enclosure> value_;
};

/// How much dearer than the cheapest: (cost - minimum) / minimum, for costs >= 0. None, infinite,
/// for cost > 0 against a minimum of 0; 0 if both are 0. (No halfspace of a solid without redundant
/// ones is free, so in a trace only an unbounded removal has infinite regret.)
///
/// Of costs that are proven to be equal it is exactly 0, and of areas and mean widths that are
/// proven to differ an interval of at least 128 bits. Of mean widths that `limits` leave undecided
/// it is an interval of limits.bits around 0.
/// @throws Error InvalidArgument for costs of different measures; Stopped when the watch ends the
///         call.
[[nodiscard]] std::optional<Regret> relative_regret(const Cost& cost, const Cost& minimum,
                                                    const CompareLimits& limits = {},
                                                    const Watch& watch = {});

/// One removal, in the state that the removals before it left.
struct JudgedStep {
  std::size_t row;  ///< Of the order.
  HalfspaceId removed;
  std::optional<Cost> cost = {};     ///< Exact; none if the removal is unbounded.
  std::optional<Cost> minimum = {};  ///< Of all removals; none if every one is unbounded.
  /// All of that cost, in canonical order. Where the evidence is Undecided, all that are not proven
  /// to cost more.
  std::vector<HalfspaceId> tie = {};
  std::optional<Regret> regret = {};  ///< relative_regret(); none, infinite, if cost is none.
  /// Whether the regret is within the limit; none if comparisons of mean widths leave it undecided.
  std::optional<bool> is_within = false;
  TieEvidence tie_evidence = {};  ///< Why the costs of the tie count as equal.

  /// Whether the removal is proven to be one of the cheapest.
  bool is_greedy() const { return regret && *regret == 0; }
  /// Whether another one is proven to be cheaper, or the removal is unbounded.
  bool is_dearer() const { return !regret || regret->is_positive(); }
  /// Greedy, but not the first of the tie, which our engines remove.
  bool is_other_tie() const { return is_greedy() && removed != tie.front(); }
};

/// The rating of an order in one word. Steps are counted from 0.
enum class TraceRating {
  Greedy,       ///< Every removal is one of the cheapest.
  UpToRegret,   ///< No regret is above the limit, but some are, or may be, above 0.
  Undecided,    ///< No regret is shown to be above the limit, but for step `at` it is not decided.
  NotGreedy,    ///< From step `at` on: the first regret above the limit.
  Unbounded,    ///< At step `at`: the remaining solid is unbounded.
  Meaningless,  ///< At step `at`, or from the start: the order cannot be followed.
};

/// Where a claim fails first.
struct TraceWitness {
  std::optional<std::size_t> step;  ///< Counted from 0; none if it is about the file.
  std::optional<std::size_t> row;   ///< Of the order.
  std::string found, expected;      ///< Exact numbers, ids in canonical order.
};

/// The claims about an order; docs/verdicts.md has a section for each.
enum class TraceCode {
  Readable,      ///< The file spells an order.
  PlaneUnknown,  ///< Each plane removed is a facet plane of the solid.
  IdOutOfRange,  ///< Each id is a position in the list.
  RemovedTwice,  ///< No facet is removed that is gone.
  Bounded,       ///< Each removal leaves a bounded solid.
  Greedy,        ///< Each removal is one of the cheapest, up to the regret that is allowed.
  // Of orders that state it; of others it is not asked.
  Cost,   ///< Each cost is the removal's.
  Ties,   ///< Each tie is the set of all removals of the least cost.
  Left,   ///< Each number of facets left is right.
  Kept,   ///< Those to be kept are kept, and listed as such.
  Stop,   ///< No other removal is bounded, if that is the reason of the end.
  Moves,  ///< Each move after the removals is possible and makes the measure smaller.
};
[[nodiscard]] constexpr bool is_of_every_order(TraceCode code) { return code < TraceCode::Cost; }

/// "trace-greedy" and the like: stable, in messages, in JSON and as headings of docs/verdicts.md.
[[nodiscard]] const char* name_of(TraceCode code);

struct TraceClaim {
  TraceCode code;
  Status status = Status::Holds;
  std::optional<TraceWitness> witness = {};  ///< If violated.
};

/// The rating of an order, and two steps of it. Steps are counted from 0.
struct OrderRating {
  TraceRating rating = TraceRating::Greedy;
  std::optional<std::size_t> at;       ///< The step that decides a rating below UpToRegret.
  std::optional<std::size_t> worst;    ///< The step of the largest regret above 0; of regrets that
                                       ///< their intervals do not tell apart the first one.
  std::optional<Regret> worst_regret;  ///< Its regret.
};

/// Facets that an order never removes, each at some step cheaper than what it removes there by more
/// than the limit: left out on purpose, or never listed. Also the rating of the order on the solid
/// without them, as if they had been removed first.
struct LeftOut : OrderRating {
  std::vector<HalfspaceId> facets;  ///< In canonical order; at least one.
  std::size_t unlisted = 0;         ///< How many of them the order's own list does not have.
  std::size_t steps = 0;            ///< Steps that are too dear while one of these facets is the
                                    ///< cheapest.
};

/// Planes of an order's list that are facet planes only up to rounding, or not at all.
struct ListedPlanes {
  std::size_t rounded = 0;        ///< Taken for the nearest facet: rounding explains the distance.
  Rational squared_distance = 0;  ///< The largest of these, from the plane to the facet's corners.
  std::size_t unknown = 0;        ///< No facet, and none that rounding explains.
};

struct TraceVerdict : OrderRating {
  std::vector<Halfspace> halfspaces;  ///< Of the input, in canonical order; ids are positions.
  std::size_t removals = 0;           ///< In the order; those after an end are not judged.
  std::vector<JudgedStep> steps;      ///< Up to the end, or to the first that is unbounded.
  std::size_t other_ties = 0;         ///< Steps that are is_other_tie().
  CostMeasure measure = CostMeasure::Volume;  ///< Of all costs.
  std::size_t undecided = 0;                  ///< Steps of which is_within is not decided.
  long tie_bits = 0;               ///< Of the finest enclosures of mean widths that may be equal.
  Rational max_regret;             ///< The limit.
  std::vector<TraceClaim> claims;  ///< One per code, in a fixed order.
  std::vector<HalfspaceId> left_out;  ///< As requested: removed before the first step.
  std::vector<HalfspaceId> kept;      ///< As requested.
  std::optional<LeftOut>
      never_removed;  ///< If trace-greedy or trace-bounded fails because of some.
  ListedPlanes listed;
  std::vector<Stage> stages;  ///< Of verify_order(), each with its time.

  /// Whether no claim is violated.
  bool holds() const;
};

struct JudgeOptions {
  Rational max_regret = 0;     ///< >= 0.
  CompareLimits compare = {};  ///< Of mean widths.
  /// Facets that are left out on purpose: the order is judged on the solid without them.
  std::vector<HalfspaceId> left_out = {};
  /// Facets that are to be kept, ascending: the order must not remove them, and its removals are
  /// compared with the others. An order that states other ones violates a claim.
  std::vector<HalfspaceId> kept = {};
  /// Unit roundoff of the numbers in which the order's planes are written: 2^-53 or 2^-24.
  double unit = 0x1p-53;
  /// Whether costs are confirmed from their definition, by some ten intersections from scratch.
  bool confirm = true;
  /// Told of the judged steps and of those that leave four facets; ends it with Error Stopped.
  Watch watch = {};
};

/// Follows an order to its end, to its first unbounded removal, or to the first row that names no
/// facet of the solid or one that is gone.
///
/// Costs, minima and ties are the filtered engine's, certified by enclosures and exact where it
/// matters, in the state that *the order* has reached. They are checked: the total cost of all
/// removals is computed again from the measures of the solid before and after, intersected from
/// scratch, and compared, volumes modulo two random primes, areas and mean widths by enclosures of
/// 256 bits. At the step that decides (the worst, the unbounded one, else the last) both costs are
/// also computed from their definition. A regret against the limit is decided by the order of two
/// costs, exact for volumes and areas. For mean widths options.compare limits the comparison; a
/// regret that stays undecided violates no claim, and the claim that it is about does not hold but
/// is Status::Undecided. A plane that is no facet plane is the nearest facet's if rounding explains
/// the difference; the verdict counts these. Moves after the last step are judged, if that is
/// reached, by the measures of their solids, each intersected from scratch.
/// @param center  Strictly inside the solid.
/// @throws Error  InvalidArgument for a negative limit, for a facet that is to be left out and does
///                not exist, is removed, or bounds the rest, or for one to be kept that does not
///                exist or is to be left out, or if options.compare.bits < 1;
///                Stopped; Internal if these do not agree.
/// @par Cost      A run of the filtered engine and one or two caps as rationals per step, again if
///                a facet that is never removed is to blame; five intersections from scratch,
///                expected O(n log n) each. For a plane that is no facet plane linear.
[[nodiscard]] TraceVerdict judge_trace(const DualHull& dual, const RationalPoint& center,
                                       const RemovalOrder& order, const JudgeOptions& options = {});

/// An order as another program wrote it: a trace, the planes removed as rows, or ids as rows.
/// docs/formats.md describes them.
struct OrderText {
  std::string bytes;
  /// The facets that its ids refer to, counted from 0, as halfspaces in any of their formats; none:
  /// the input's facets in canonical order.
  std::optional<std::string> facets = {};
  std::string facets_path = {};        ///< Its extension names the format of `facets`.
  Decimal decimal = Decimal::Nearest;  ///< The meaning of decimals in both.
  /// By which it is to be judged; none: the measure that the order states, or the volume.
  std::optional<CostMeasure> cost = {};
};

struct VerifyOrderRequest {
  JudgeOptions judge = {};              ///< `kept` and `watch` are set by the call.
  std::vector<KeepSelector> keep = {};  ///< Facets that the order is to keep.
  std::uint64_t seed = 1;  ///< Of every random order. The verdict does not depend on it.
  StageWatch watch = {};
};

/// Reads an order and judges it, as judge_trace(). Any fault of its text is a violated claim.
/// @return NotSolid if the *input* encloses no volume.
/// @throws Error As judge_trace(); as select_facets(); InvalidArgument if facets are given to an
///               order that spells out its planes, or if it states another measure; Malformed or
///               NotFinite, with the file, for faults of the list of facets.
[[nodiscard]] std::variant<TraceVerdict, NotSolid> verify_order(
    const Shape& input, const OrderText& order, const VerifyOrderRequest& request = {});

/// The verdict on a file from which no order could be read: all other claims are not asked.
/// @param line  The line that cannot be understood, if known.
[[nodiscard]] TraceVerdict unreadable_trace(const DualHull& dual, const std::string& what,
                                            std::optional<std::size_t> line);

}  // namespace convexact
