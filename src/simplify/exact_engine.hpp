// SPDX-License-Identifier: MIT
// exact_engine.hpp - the greedy simplification in exact arithmetic: the reference engine.
#pragma once
#include <vector>

#include "convexact/dual.hpp"
#include "convexact/run.hpp"

namespace convexact {

/// Removes one halfspace after another, each time the one whose removal adds the least to the
/// measure of the options; of equal ones the first in canonical order. Every sign and every cost is
/// exact. Mean widths whose comparison is undecided count as equal, and the step says so.
/// @param dual    The dual hull of the input.
/// @param center  Strictly inside the solid. Costs and ties do not depend on it.
/// @throws Error  InvalidArgument if options.faces < 4, options.max_growth < 0, or the center is
///                not strictly inside; Stopped if `stop` becomes true; Internal if a verification
///                fails.
/// @par Cost      Expected O(k) exact operations per evaluated cap of a ring of k; each step
///                evaluates the caps of one ring.
/// @par Source    [Jacobson2026]
[[nodiscard]] Run simplify_exact(const DualHull& dual, const RationalPoint& center,
                                 const SimplifyOptions& options = {});

}  // namespace convexact
