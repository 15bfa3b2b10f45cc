// SPDX-License-Identifier: MIT
// inner_trace.hpp - an inner run as JSON text: enough for another program to replay every step.
#pragma once
#include <string>

#include "convexact/inner_run.hpp"

namespace convexact {

/// One object as docs/schema/inner-trace.schema.json describes it. Coordinates are strings, p or
/// p/q. Precondition: each step has its cost.
[[nodiscard]] std::string write_inner_trace_json(const VertexHull& start, const InnerRun& run);

}  // namespace convexact
