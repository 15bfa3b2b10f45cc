// SPDX-License-Identifier: MIT
// inner_trace.hpp - an inner run as JSON text, with enough data for another program to replay every
// step.
#pragma once
#include <string>

#include "convexact/inner_run.hpp"
#include "io/names.hpp"

namespace convexact {

inline constexpr auto kInnerStopNames =
    name_table<InnerStop>({{InnerStop::Reached, "reached"}, {InnerStop::LossLimit, "loss-limit"}});
inline const char* name_of(InnerStop reason) { return name_in(kInnerStopNames, reason); }

/// One object as docs/schema/inner-trace.schema.json describes it. Coordinates are strings, p or
/// p/q. Precondition: each step has its cost.
[[nodiscard]] std::string write_inner_trace_json(const VertexHull& start, const InnerRun& run);

}  // namespace convexact
