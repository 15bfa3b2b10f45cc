// SPDX-License-Identifier: MIT
// trace_json.hpp - a run as JSON text (a trace), with enough data for another program to replay
// every step.
#pragma once
#include <string>
#include <vector>

#include "convexact/cost.hpp"
#include "convexact/run.hpp"
#include "io/json_document.hpp"

namespace convexact {

/// Version 1, which has neither version nor measure, knew volumes only; it is still read.
inline constexpr int kTraceVersion = 2;

/// A cost as a trace has it, see trace_json().
[[nodiscard]] Json cost_json(const Cost& cost);

/// Moves as a trace has them, see trace_json().
[[nodiscard]] Json moves_json(const std::vector<Move>& moves);

/// One object as docs/schema/trace.schema.json describes it: integers of any size are strings, a
/// cost is {"value": nearest double, or null beyond the largest one, "decimal": 17 digits} with, by
/// the measure, "exact": "p/q", "roots": [["q", "N"], ...], or
/// "edges": [["factor", "squared length", "squared cross product", "dot product"], ...].
/// Precondition: each step has its cost, and each move its measure.
[[nodiscard]] Json trace_json(const Run& run);
[[nodiscard]] std::string write_trace_json(const Run& run);  ///< Its text, with a line end.

/// The same of an inner run, as docs/schema/inner-trace.schema.json describes it. Coordinates are
/// strings, p or p/q. Precondition: each step has its cost.
[[nodiscard]] Json inner_trace_json(const VertexHull& start, const InnerRun& run);
[[nodiscard]] std::string write_inner_trace_json(const VertexHull& start, const InnerRun& run);

}  // namespace convexact
