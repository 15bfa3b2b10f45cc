// SPDX-License-Identifier: MIT
// answer.hpp - all statements of an engine about one input, for a judge in another process.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "convexact/geometry.hpp"
#include "convexact/run.hpp"
#include "convexact/scene.hpp"
#include "io/json_document.hpp"
#include "lab/stress/stress_report.hpp"

namespace convexact {

/// A result as bytes, as a file would hold it.
struct StoredBytes {
  StressStored stored;  ///< As the engine claims it: the solid holds, or is refused.
  std::string bytes;    ///< JSON for planes, OBJ for a mesh; empty if refused.
};

/// A measure or a cost as an engine reports it: in this interval. An end that excludes nothing is
/// unset.
struct ReportedVolume {
  std::optional<Rational> low, high;
};

/// A step of the engine's run that keeps no record.
struct LeanStep {
  HalfspaceId removed;
  ReportedVolume cost;  ///< Of the float engine an estimate, so a point.
  std::uint64_t tied = 0;
};

/// The result of a search from the end of the removals.
struct SearchAnswer {
  std::vector<Move> moves;      ///< Each with the measure of its solid.
  std::vector<Halfspace> left;  ///< The planes of its result.
};

struct EngineAnswer {
  Engine engine = Engine::Exact;
  StressEnd end = StressEnd::Failed;
  std::string why;  ///< Of an end with an error, and of NoVolume.

  /// Of the solid and the run. Each step has cost and tie; for the float engine, which keeps no
  /// such record, only the removal.
  Run run;
  std::vector<LeanStep> lean;  ///< Empty for the exact engine.

  std::vector<Halfspace> left;                 ///< The result of the pipeline.
  ReportedVolume input_volume, output_volume;  ///< The volumes that it reports.
  /// By area or mean width: this measure of the same two.
  std::optional<std::array<ReportedVolume, 2>> measure;
  std::optional<StressClaim> claim;  ///< Of the float engine.
  /// None if none was asked for, for the float engine, and if more than 100 halfspaces are left.
  std::optional<SearchAnswer> search;
  std::vector<StoredBytes> stored;
  double seconds = 0;        ///< Of processor time: the pipeline with the exact result, not stored.
  std::uint64_t memory = 0;  ///< Peak of its process, known to the parent only.
};

struct Question {
  Engine engine = Engine::Exact;
  std::size_t faces = 4;
  std::uint64_t seed = 1;
  CostMeasure cost = CostMeasure::Volume;
  SearchRequest search = {};
};

/// Runs an engine through the pipeline, as users do; again where needed for the record of its
/// steps, and for a search; and stores the result in every format, unless it is large. For a solid
/// that would take long, the exact engine makes the first removals only. The errors of convexact
/// become part of the answer.
[[nodiscard]] EngineAnswer answer_of(const Shape& shape, const Question& question);

/// From one process to another. Costs are of run.measure. Numbers stay exact; only removal, cost
/// and tie of each step are kept; the answer is read from the text.
[[nodiscard]] Json answer_json(const EngineAnswer& answer);
[[nodiscard]] EngineAnswer answer_in(std::string_view text);

}  // namespace convexact
