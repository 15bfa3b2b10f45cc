// SPDX-License-Identifier: MIT
// simplify.hpp - the main job: enclose a shape in few halfspaces and prove that they hold it.
#pragma once
#include <array>
#include <optional>
#include <variant>
#include <vector>

#include "convexact/dual.hpp"
#include "convexact/hull.hpp"
#include "convexact/keep.hpp"
#include "convexact/measure.hpp"
#include "convexact/run.hpp"
#include "convexact/scene.hpp"
#include "convexact/search.hpp"
#include "convexact/watch.hpp"

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
  StageWatch watch = {};       ///< Reports removals as the progress of stage::kSimplify.
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
  int digits = 10;            ///< Certain decimal digits of each measure, 1 to 10000.
  bool exact_volume = false;  ///< The volume as a rational too.
  std::uint64_t seed = 1;     ///< Of every random order. The answer does not depend on it.
  StoreRequest store;
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
  std::vector<Stage> stages;  ///< Each with its time, or the reason why it was left out.
};

using HullReport = std::variant<HullResult, NotSolid>;

/// The hull of points, or the solid that halfspaces bound, measured. @throws Error as simplify().
[[nodiscard]] HullReport measure_hull(const Shape& shape, const HullRequest& request = {});

}  // namespace convexact
