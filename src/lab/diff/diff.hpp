// SPDX-License-Identifier: MIT
// diff.hpp - compares engines on one shape.
#pragma once
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "convexact/dual.hpp"
#include "convexact/number.hpp"
#include "convexact/run.hpp"
#include "convexact/simplify.hpp"
#include "io/json_document.hpp"
#include "lab/diff/divergence.hpp"

namespace convexact {

/// Runs an engine on a solid. @param record  Whether the filtered engine keeps costs and ties; the
/// exact one always does, the float one never.
/// @param center  Strictly inside. @throws Error as the engines.
[[nodiscard]] Run run_engine(Engine engine, const DualHull& dual, const RationalPoint& center,
                             const SimplifyOptions& options, bool record);

struct DiffRequest {
  std::size_t faces = 4;                ///< Halfspaces at which each run ends, >= 4.
  std::vector<KeepSelector> keep = {};  ///< Facets that no run removes.
  /// At least two, all different; the others are compared with the first.
  std::vector<Engine> engines = {Engine::Exact, Engine::Filtered, Engine::Float};
  CostMeasure cost = CostMeasure::Volume;  ///< The measure that the runs keep small.
  CompareLimits compare = {};              ///< Of mean widths, by the engines and the judge.
  std::uint64_t seed = 1;                  ///< Of every random order. The answer does not depend on
                                           ///< it.
  StageWatch watch = {};  ///< Reports removals as the progress of each engine's stage.
};

/// One engine against the reference.
///
/// Two engines that promise the same answer are compared up to the first step where they differ. If
/// one of them is the float engine, its run is followed from there to the end (check_greedy()):
/// every step is judged in the state that the float engine had reached.
struct Comparison {
  Engine reference, other;
  /// Ascending by step; empty if the runs are the same, step by step. The first is where the runs
  /// differ. In the later ones, the choice of the engine that is not `float` is the removal of the
  /// filtered engine in that state, since the separate run of that engine has reached another one.
  std::vector<Divergence> divergences = {};
  bool explained = true;      ///< Whether each of them is (is_explained()).
  std::size_t judged = 0;     ///< Steps that were compared or judged, from the first one on.
  bool with_records = false;  ///< Costs and tie lists were compared, not only removals.
  /// Final volume of `other` over that of the reference; none if either is unbounded.
  std::optional<Enclosure> volume_ratio = {};
  /// The same of the area or mean width, if that is the measure of the runs.
  std::optional<Enclosure> measure_ratio = {};
};

struct DiffReport {
  CostMeasure cost = CostMeasure::Volume;  ///< Of all runs.
  std::vector<Halfspace> halfspaces;       ///< Of the input, in canonical order; ids are positions.
  std::vector<HalfspaceId> kept;           ///< The facets that no run removes.
  std::vector<Engine> engines;             ///< In the order asked for.
  std::vector<Run> runs;                   ///< Of each of these engines.
  std::vector<Comparison> comparisons;
  std::vector<Stage> stages;

  /// Whether every difference is explained.
  bool holds() const;
};

using DiffOutcome = std::variant<DiffReport, NotSolid>;

/// Runs the engines on one dual hull, from one center, and judges where they differ. Steps are not
/// verified in addition: the comparison is the verification. The filtered engine keeps its record,
/// costs and tie lists, only if the exact one runs too: no other engine has one to compare it with.
/// @throws Error InvalidArgument for an invalid request; Stopped; Internal.
[[nodiscard]] DiffOutcome diff_engines(const Shape& shape, const DiffRequest& request);

/// One object's report without its name and stages. Where two runs differ first and worst, costs
/// are exact, of any length.
[[nodiscard]] Json diff_json(const DiffReport& report);

struct NamedDiff {
  std::string name;
  const DiffReport* report;
};

/// A table with a row per object and comparison, then where each pair differs first and worst, with
/// planes and costs.
[[nodiscard]] std::string diff_table(const std::vector<NamedDiff>& objects);

}  // namespace convexact
