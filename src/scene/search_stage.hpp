// SPDX-License-Identifier: MIT
// search_stage.hpp - the stage of simplify() that makes the solid of the removals smaller.
#pragma once
#include "convexact/simplify.hpp"
#include "scene/run_stages.hpp"
#include "solid/stage_log.hpp"

namespace convexact {

/// @throws Error InvalidArgument if the search is combined with options that exclude it.
void require_sensible_search(const SimplifyRequest& request);

/// The end of a search that begins at the end of a run: its polytope is the solid that was found,
/// intersected from scratch, which shows that it is bounded. Unless no verification is asked for,
/// the measure is proven to be less than before; with VerifyLevel::Full, or for a trace, after
/// every move.
/// @throws Error Internal if that fails.
[[nodiscard]] RunEnd search_further(RunEnd end, const RunInput& input,
                                    const SimplifyRequest& request, StageLog& log);

}  // namespace convexact
