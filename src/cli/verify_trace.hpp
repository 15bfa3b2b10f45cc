// SPDX-License-Identifier: MIT
// verify_trace.hpp - verify INPUT --trace FILE: judges a removal order.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "convexact/cost.hpp"
#include "convexact/geometry.hpp"
#include "convexact/scene.hpp"

namespace convexact::cli {

struct TraceOptions {
  std::string trace;   ///< The file; empty without --trace.
  std::string facets;  ///< The file of the list that ids refer to; empty for canonical order.
  std::string max_regret = "0";
  std::optional<CostMeasure> cost;  ///< None: the measure of the trace, or the volume.
  long tie_bits = CompareLimits{}.bits;
  std::vector<HalfspaceId> left_out;  ///< In canonical order of the input's facets.
  std::vector<std::string> keep;      ///< Selectors of facets that the order is to keep.
};

/// Adds --trace, --cost, --tie-bits, --facets, --max-regret, --left-out and --keep.
void add_trace_options(Command& command, TraceOptions& options);

/// Judges the order, prints the verdict and returns the exit code: 0 if nothing is violated, else 1
/// (4 for an input without interior).
/// @param input    A file of points or halfspaces.
/// @param reading  How it is read; the order with its meaning of decimals.
/// @throws Error Unreadable if a file is not there; InvalidArgument; as read_scene() for the input.
int run_verify_trace(const GlobalOptions& global, const std::string& input,
                     const SceneOptions& reading, const TraceOptions& options);

}  // namespace convexact::cli
