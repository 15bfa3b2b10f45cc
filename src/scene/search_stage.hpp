// SPDX-License-Identifier: MIT
// search_stage.hpp - the stage of simplify() that makes the solid of the removals smaller.
#pragma once
#include "convexact/simplify.hpp"
#include "scene/run_stages.hpp"
#include "solid/stage_log.hpp"

namespace convexact {

/// @throws Error InvalidArgument if the search is combined with options that exclude it.
void require_sensible_search(const SimplifyRequest& request);

/// Searches from the end of a run, and replaces its polytope by the solid that was found,
/// intersected from scratch, which shows that it is bounded. Unless no verification is asked for,
/// the measure is proven to be less than before; with VerifyLevel::Full, or for a trace, after
/// every move.
/// @throws Error Internal if that fails.
void search_further(RunEnd& end, const RunInput& input, const SimplifyRequest& request,
                    StageLog& log);

}  // namespace convexact
