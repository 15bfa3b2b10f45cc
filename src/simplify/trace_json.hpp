// SPDX-License-Identifier: MIT
// trace_json.hpp - a run as JSON text (a trace), with enough data for another program to replay
// every step.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "convexact/cost.hpp"
#include "convexact/run.hpp"
#include "io/names.hpp"

namespace convexact {

inline constexpr auto kStopReasonNames =
    name_table<StopReason>({{StopReason::Reached, "reached"},
                            {StopReason::GrowthLimit, "growth-limit"},
                            {StopReason::AllUnbounded, "all-unbounded"},
                            {StopReason::AllKeptOrUnbounded, "all-kept-or-unbounded"}});
inline const char* name_of(StopReason reason) { return name_in(kStopReasonNames, reason); }

inline constexpr auto kCostMeasureNames =
    name_table<CostMeasure>({{CostMeasure::Volume, "volume"},
                             {CostMeasure::Area, "area"},
                             {CostMeasure::MeanWidth, "mean-width"}});
inline const char* name_of(CostMeasure measure) { return name_in(kCostMeasureNames, measure); }

inline constexpr auto kTieProofNames =
    name_table<TieProof>({{TieProof::EqualRationals, "rational"},
                          {TieProof::Congruent, "congruent"},
                          {TieProof::SquareClasses, "square-classes"},
                          {TieProof::NormalForm, "normal-form"},
                          {TieProof::AngleBasis, "angle-basis"},
                          {TieProof::Undecided, "undecided"}});
inline const char* name_of(TieProof proof) { return name_in(kTieProofNames, proof); }

/// Version 1, which has no keys for version and measure, was for volumes only; it is still read.
inline constexpr int kTraceVersion = 2;

/// A cost as a trace has it, see write_trace_json().
[[nodiscard]] nlohmann::ordered_json cost_json(const Cost& cost);

/// Moves as a trace has them, see write_trace_json().
[[nodiscard]] nlohmann::ordered_json moves_json(const std::vector<Move>& moves);

/// The exact number of such an object: what "exact", "roots" or "edges" spell, by the measure; none
/// if the object does not have that key.
/// @throws Error Malformed if the key holds anything else.
[[nodiscard]] std::optional<Cost> cost_in_json(const nlohmann::json& object, CostMeasure measure);

/// One object as docs/schema/trace.schema.json describes it: integers of any size are strings, a
/// cost is {"value": nearest double, or null beyond the largest one, "decimal": 17 digits} with, by
/// the measure, "exact": "p/q", "roots": [["q", "N"], ...], or
/// "edges": [["factor", "squared length", "squared cross product", "dot product"], ...].
/// Precondition: each step has its cost, and each move its measure.
[[nodiscard]] std::string write_trace_json(const Run& run);

}  // namespace convexact
