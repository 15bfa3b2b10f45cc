// SPDX-License-Identifier: MIT
// float_engine.hpp - the greedy simplification in plain floating point: fast, never wrong by much.
#pragma once
#include "fast/filtered_engine.hpp"

namespace convexact {

/// Makes the removals that doubles find cheapest. Exact numbers decide none of them.
///
/// These facts hold without any check of the result: the survivors are a subset of the input's
/// halfspaces, so they contain the solid; and they are bounded, because a removal is made only if
/// every new vertex is proven to exist (docs/design/filtered.md). Two things may differ from
/// simplify_filtered(). The choice between costs that are equal up to rounding may differ. And
/// where not even DoubleDouble, which is used where doubles are in doubt, can tell whether a vertex
/// exists, the run may end early with AllUnbounded.
///
/// A bound on its errors is proven during the run and stands in FastResult::bound: costs
/// are enclosed, T is right if every sign that doubles leave uncertain agrees with the exact one,
/// and a cap that was never enclosed counts as free of cost.
/// @param options  `verify` is ignored: there is no claim to verify except the two above.
///                 `max_growth` is compared in doubles.
/// @throws Error   As simplify_filtered(), but never Internal.
/// @par Source     [Jacobson2026]
[[nodiscard]] FastResult simplify_float(const FastDual& dual, const SimplifyOptions& options = {});

}  // namespace convexact
