// SPDX-License-Identifier: MIT
// simplify.hpp - the main job: enclose a shape in few halfspaces and prove that they hold it.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "convexact/dual.hpp"
#include "convexact/error.hpp"
#include "convexact/hull.hpp"
#include "convexact/measure.hpp"
#include "convexact/run.hpp"
#include "convexact/scene.hpp"
#include "convexact/search.hpp"

namespace convexact {

/// The start of a run with its proofs, which a proof of the run needs beside the run.
struct RunStart {
  std::vector<Halfspace> input_halfspaces;  ///< If the input is halfspaces: all of them.
  DualHull dual;                            ///< Of the solid.
  RationalPoint interior;                   ///< Strictly inside the solid.
  std::vector<InsideProof> inside;          ///< As in HullCertificate.
  std::vector<PointId> extreme;             ///< The points that are the solid's vertices.
};

/// A request. At least one of `faces` and `max_growth` must be given.
struct SimplifyRequest {
  std::optional<std::size_t> faces;  ///< Halfspaces to keep, >= 4.
  /// Facets of the input that stay. The result has at least as many halfspaces as there are of
  /// these.
  std::vector<KeepSelector> keep = {};
  /// The measure `growth_of` may grow to (1 + max_growth) times; >= 0.
  std::optional<Rational> max_growth;
  /// Unset: `cost`. Only with max_growth; for the float engine, only `cost`.
  std::optional<CostMeasure> growth_of;
  /// The measure that is kept small.
  CostMeasure cost = CostMeasure::Volume;
  CompareLimits compare = {};  ///< Of mean widths.
  Engine engine = Engine::Filtered;
  /// Makes the result smaller after the removals. With `faces` only, and neither for the float
  /// engine nor with `record`.
  SearchRequest search = {};
  bool trace = false;  ///< Keep the full record of every step. Not for the float engine.
  /// Keep the data for a proof of the run. For every engine and measure. By volume and by area the
  /// proof shows that each removal was the cheapest; for mean widths, and for the float engine's
  /// choices, it claims less (docs/proof-format.md).
  bool record = false;
  /// How much of each step is proven again. The float engine proves no steps, only the result; Full
  /// makes the filtered engine keep the record that it needs.
  VerifyLevel verify = VerifyLevel::Local;
  std::optional<RationalPoint> center;  ///< Unset: the Chebyshev center. The answer is the same.
  std::uint64_t seed = 1;               ///< Of every random order. The answer does not depend on
                                        ///< it.
  StoreRequest store;
  bool exact_volumes = false;  ///< As rationals too, not only their certain digits.
  /// Threads, 1 to 256; as many as the machine has cores if it is not given. Nothing depends on it.
  std::optional<std::size_t> jobs = {};
  StageWatch watch = {};  ///< Reports removals as the progress of stage::kSimplify.
};

/// A facet that a run was asked to keep.
struct KeptFacet {
  HalfspaceId id;     ///< Among the facets of the input, in canonical order.
  std::size_t plane;  ///< Its place in the planes of the result.
};

/// The result of a search. Measures are those that the run keeps small.
struct SearchResult {
  /// The move by which the measure fell most; of those that seem to be equal, the first.
  struct Best {
    std::size_t move;  ///< Its place in `moves`.
    Enclosure before, after;
  };

  SearchRequest request;
  std::size_t tried = 0;          ///< Exchanges whose measures were compared.
  std::vector<Move> moves;        ///< Those made, with ids among the facets of the input.
  Enclosure greedy, now;          ///< Of the solid that the removals left, and of the result.
  std::optional<Best> best = {};  ///< None without moves.
  std::optional<Optimality> optimality = {};  ///< Of SearchKind::Optimal.
};

struct SimplifyResult {
  std::size_t input_points = 0;  ///< 0 where the input is halfspaces.
  std::size_t hull_vertices = 0;
  std::vector<std::size_t> redundant;  ///< Of halfspace input.
  std::size_t input_halfspaces = 0;    ///< Of the hull, redundant ones not counted.
  std::size_t steps = 0;               ///< Halfspaces removed.
  StopReason stop = StopReason::Reached;
  std::vector<KeptFacet> kept;  ///< The facets that the request's selectors selected, ascending.
  /// Set if its trace or record was asked for, and by the exact engine. The float engine's run is
  /// made again in exact numbers.
  std::optional<Run> run;
  std::optional<RunStart> start;  ///< If the record was requested.
  Stored solid;                   ///< The solid that encloses the input.
  Measured input_volume;          ///< Of the input's hull, in cubed length units.
  Measured output_volume;
  CostMeasure cost = CostMeasure::Volume;
  /// By area or mean width: the measure of the input's hull and of the result.
  std::optional<std::array<Enclosure, 2>> measure;
  /// The measure whose growth was limited, if it was; and, unless it is the volume or `cost`, that
  /// measure of the input's hull and of the result.
  std::optional<CostMeasure> growth_of;
  std::optional<std::array<Enclosure, 2>> limited;
  long growth_bits = 0;           ///< As in Run.
  TieTally ties;                  ///< Of the exact and the filtered engine.
  std::size_t tested_points = 0;  ///< Points tested directly against every survivor.
  Engine engine = Engine::Filtered;
  VerifyLevel verified = VerifyLevel::Local;
  std::optional<SearchResult> search;     ///< If one was asked for.
  std::optional<FloatBound> float_bound;  ///< Of the float engine: the proven bounds on its errors.
  std::vector<Stage> stages;  ///< Each with its time, or the reason why it was left out.

  /// The halfspaces n1 x + n2 y + n3 z + d <= 0 in doubles, proven to hold every input point; the
  /// exact ones are solid.exact.planes, in the same order.
  /// @throws Error as Stored::planes_in_doubles().
  [[nodiscard]] std::vector<std::array<double, 4>> planes() const {
    return solid.planes_in_doubles();
  }
};

using SimplifyOutcome = std::variant<SimplifyResult, NotSolid>;

/// Runs the stages that the request and the shape need.
/// @throws Error InvalidArgument for an invalid request or a center that is not strictly inside;
///               Unrepresentable if a stored format cannot hold the result; Stopped; Internal if
///               a verification fails.
[[nodiscard]] SimplifyOutcome simplify(const Shape& shape, const SimplifyRequest& request);

struct HullRequest {
  bool volume = true, area = true, mean_width = true;  ///< The measures to compute.
  bool inertia = false;       ///< Volume, center of mass and inertia, as fractions.
  int digits = 10;            ///< Certain decimal digits of each measure, 1 to 10000.
  bool exact_volume = false;  ///< The volume as a rational too.
  std::uint64_t seed = 1;     ///< Of every random order. The answer does not depend on it.
  StoreRequest store;
  /// Threads, 1 to 256; as many as the machine has cores if it is not given. Nothing depends on it.
  std::optional<std::size_t> jobs = {};
  StageWatch watch = {};  ///< Reports facets or edges as the progress of each measure.
};

struct HullResult {
  std::size_t input_points = 0;        ///< 0 where the input is halfspaces.
  std::vector<std::size_t> redundant;  ///< Of halfspace input.
  Stored solid;
  std::size_t edges = 0;
  BoundingBox box;    ///< Of the hull.
  Measured diameter;  ///< Diagonal of the box, in length units.
  // In cubed, squared and plain length units; each if asked for.
  std::optional<Measured> volume, area, mean_width;
  std::optional<MassProperties> mass = {};
  std::vector<Stage> stages;  ///< Each with its time, or the reason why it was left out.
};

using HullReport = std::variant<HullResult, NotSolid>;

/// The hull of points, or the solid that halfspaces bound, measured. @throws Error as simplify().
[[nodiscard]] HullReport measure_hull(const Shape& shape, const HullRequest& request = {});

// ---- Several parts, each enclosed separately, with one budget of halfspaces; and the gaps that
// solids leave between the parts.

/// A request for all parts together.
struct SceneRequest {
  /// As for one part. `faces` and `center` stay unset, since no single number or point suits every
  /// part; `keep` stays unset, too. `max_growth` limits the sum over all parts.
  SimplifyRequest each;
  /// Halfspaces to keep in all parts together: at least 4 for each part.
  std::size_t total_faces = 0;
  /// By part: its facets that stay. Empty if no part has any; else as long as there are parts.
  std::vector<std::vector<KeepSelector>> keep = {};
};

/// The results for all parts together. Measures are sums over the parts.
struct SceneTotals {
  std::size_t steps = 0;  ///< Halfspaces removed.
  /// The last removals, in their order, each by its part, counted from 0. The other parts keep at
  /// least 4 halfspaces each, so that a part cannot end with more than `total_faces` less these;
  /// by volume and unless growth is limited, each part is first simplified down to that number by
  /// itself. Otherwise these are all removals.
  std::vector<std::uint32_t> order;
  StopReason stop = StopReason::Reached;
  std::size_t input_halfspaces = 0, output_halfspaces = 0;
  Measured input_volume{Enclosure(1), {}}, output_volume{Enclosure(1), {}};
  /// As in SimplifyResult.
  CostMeasure cost = CostMeasure::Volume;
  std::optional<std::array<Enclosure, 2>> measure;
  std::optional<CostMeasure> growth_of;
  std::optional<std::array<Enclosure, 2>> limited;
  long growth_bits = 0;
  /// Of the exact and the filtered engine: the steps of `order` in which the cheapest removals of
  /// several parts cost the same, so that the first of these parts went on.
  TieTally ties;
  Engine engine = Engine::Filtered;
  /// Of the float engine: whether exact numbers, too, would have ended every part's run there.
  bool is_end_proven = true;
  std::vector<Stage> stages;  ///< Of all parts at once; others are in the results of the parts.
};

struct SceneResult : SceneTotals {
  std::vector<SimplifyResult> parts;  ///< As the parts were given; `stop` is that of the scene.
};

/// The first part that has no volume.
struct NotSolidPart {
  std::size_t part;
  NotSolid reason;
};

using SceneOutcome = std::variant<SceneResult, NotSolidPart>;

/// Removes one halfspace after another, each time the one of all parts whose removal adds the least
/// to the measure of the request, until `total_faces` are left. On a tie the first part is chosen,
/// and within a part the first halfspace in canonical order. A part whose removals are all
/// unbounded, as with 4 halfspaces, drops out; if all parts have dropped out, the run ends above
/// `total_faces`.
///
/// Parts do not interact, so the removals in each part are the first ones of the part's separate
/// run. Costs by volume never fall during a run, so no other choice of prefixes of these runs keeps
/// as few halfspaces and has a smaller sum of volumes. Costs by area and mean width may fall, so
/// there this is a greedy choice without that property.
///
/// The exact and the filtered engine compare the parts' costs exactly where their bounds overlap;
/// mean widths that cannot be told apart count as equal. The float engine compares its estimates.
/// @throws Error InvalidArgument for no part, a budget below 4 halfspaces for each part, or what
///               simplify() refuses; otherwise as simplify().
/// @par Cost     As the parts' separate runs, and for each removal the logarithm of the number of
///               parts.
[[nodiscard]] SceneOutcome simplify_scene(std::span<const Shape> parts,
                                          const SceneRequest& request);

/// A face of one part of an input, both counted from 0.
struct PartFace {
  std::size_t part;
  std::size_t face;
  friend bool operator==(const PartFace&, const PartFace&) = default;
};

/// Which faces of the parts of an input the solids of the parts leave bare.
struct Gaps {
  std::size_t faces = 0;             ///< Of all parts.
  std::vector<PartFace> out_of_own;  ///< Not inside the solid of their own part, ascending.
  std::vector<PartFace> in_no_part;  ///< Of these: not inside the solid of any other part.
};

/// Whether each face of the input is inside the solid of its own part, exactly: a face is inside a
/// convex set if and only if its corners are, and touching counts as inside. A face that several
/// solids cover only together counts as in no part.
/// @param parts   Of halfspaces, or of points without faces: nothing to test.
/// @param solids  For each part the halfspaces whose intersection it is; without any, the empty
///                set.
/// @throws Error  InvalidArgument unless there is a solid for each part; Stopped when the watch
///                ends it.
/// @par Cost      A sign for each point and halfspace of its part; for each face that is not inside
///                its own part one for each corner and halfspace of the scene.
[[nodiscard]] Gaps find_gaps(std::span<const SceneObject> parts,
                             std::span<const std::vector<Halfspace>> solids,
                             const Watch& watch = {});

// ---- Simplification from inside: removes vertices of a shape's hull one after another, so that
// the hull of those left keeps as much of the volume as such removals can.

/// A request. At least one of `vertices` and `max_loss` must be given.
struct InnerRequest {
  std::optional<std::size_t> vertices;  ///< To keep, >= 4.
  /// The volume stays at least (1 - max_loss) times that of the hull, exactly; >= 0.
  std::optional<Rational> max_loss;
  Engine engine = Engine::Filtered;  ///< Not Float.
  VerifyLevel verify = VerifyLevel::Local;
  std::uint64_t seed = 1;  ///< Of every random order. The answer does not depend on it.
  /// Keep the exact cost of every step, for a trace. The exact engine and VerifyLevel::Full keep it
  /// in any case.
  bool costs = false;
  bool mesh = false;  ///< Keep the result as a mesh in binary64.
  /// Threads, 1 to 256; as many as the machine has cores if it is not given. Nothing depends on it.
  std::optional<std::size_t> jobs = {};
  StageWatch watch = {};  ///< Reports removals as the progress of stage::kSimplify.
};

struct InnerResult {
  std::size_t input_points = 0;
  std::size_t input_halfspaces = 0;  ///< Of the hull.
  VertexHull start;
  InnerRun run;
  std::vector<PointId> kept;                ///< Input ids of the result's vertices, ascending.
  std::vector<Halfspace> hull;              ///< The exact hull of the input.
  Polytope solid;                           ///< The result.
  std::optional<Mesh> mesh;                 ///< Of the input's doubles, unchanged; if asked for.
  Measured input_volume{Enclosure(1), {}};  ///< Exact, as the next.
  Measured output_volume{Enclosure(1), {}};
  Engine engine = Engine::Filtered;
  VerifyLevel verified = VerifyLevel::Local;
  std::vector<Stage> stages;  ///< Each with its time, or the reason why it was left out.
};

using InnerOutcome = std::variant<InnerResult, NotSolid>;

/// Removes vertices of the hull, each time the one whose removal loses the least volume, and proves
/// the result: its vertices are input points and lie in every halfspace of the exact hull of the
/// input; each step is proven again as `verify` says; and where costs are kept, its volume,
/// computed from a separate hull, is that of the input less the sum of all costs.
/// @throws Error InvalidArgument for an invalid request; Unrepresentable if a mesh is wanted and a
///         vertex is no double; Stopped; Internal if a proof fails.
/// @par Source  [Jacobson2026]
[[nodiscard]] InnerOutcome simplify_inner(const PointSet& points, const InnerRequest& request);

}  // namespace convexact
