// SPDX-License-Identifier: MIT
// engine_run.hpp - one way to run each of the three engines.
#pragma once
#include "convexact/dual.hpp"
#include "convexact/run.hpp"
#include "convexact/simplify.hpp"

namespace convexact {

/// Runs an engine on a solid. @param record  Whether the filtered engine keeps costs and ties; the
/// exact one always does, the float one never.
/// @param center  Strictly inside. @throws Error as the engines.
[[nodiscard]] Run run_engine(Engine engine, const DualHull& dual, const RationalPoint& center,
                             const SimplifyOptions& options, bool record);

}  // namespace convexact
