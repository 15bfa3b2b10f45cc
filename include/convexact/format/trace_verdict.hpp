// SPDX-License-Identifier: MIT
// trace_verdict.hpp - how somebody's removal order was judged, for machines
// (docs/schema/trace_verdict.schema.json) and for people.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "convexact/oracle/judge_trace.hpp"

namespace convexact {

/// "greedy", "greedy up to regret 0.0123 (step 5)", "not greedy from step 7", "unbounded at step
/// 7", "cannot be followed from step 7" or "unreadable". Steps are counted from 0.
[[nodiscard]] std::string verdict_line(const TraceVerdict& verdict);

/// All steps with exact costs, whatever their length; without the stages.
[[nodiscard]] nlohmann::ordered_json trace_verdict_json(const TraceVerdict& verdict);

/// The verdict, what is violated and with what witness, the worst steps, totals.
[[nodiscard]] std::string trace_verdict_text(const TraceVerdict& verdict);

}  // namespace convexact
