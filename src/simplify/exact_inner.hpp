// SPDX-License-Identifier: MIT
// exact_inner.hpp - the greedy removal of vertices in integers: the reference engine of inner runs.
#pragma once
#include "convexact/run.hpp"

namespace convexact {

/// Removes one vertex after another, each time the one whose removal loses the least volume; of
/// equal ones the first in canonical order. Every sign and every cost is an integer.
/// @throws Error  InvalidArgument if options.vertices < 4 or options.max_loss < 0; Stopped.
/// @par Cost      Expected O(k) products for each evaluated ring of k; each step evaluates the
///                vertices of one ring.
/// @par Source    [Jacobson2026]
[[nodiscard]] InnerRun simplify_inner_exact(const VertexHull& hull,
                                            const InnerOptions& options = {});

}  // namespace convexact
