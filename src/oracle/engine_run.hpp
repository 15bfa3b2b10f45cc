// SPDX-License-Identifier: MIT
// engine_run.hpp - the run of an engine, in a form in which engines can be compared.
#pragma once
#include <span>
#include <vector>

#include "convexact/dual.hpp"
#include "convexact/simplify.hpp"

namespace convexact {

struct EngineRun {
  Engine engine = Engine::Exact;
  std::vector<HalfspaceId> removed;  ///< In the order of removal.
  /// Exact cost and tie list of each step as recorded; both empty if the engine keeps no record.
  std::vector<Rational> costs;
  std::vector<std::vector<HalfspaceId>> ties;
  StopReason stop = StopReason::Reached;
};

/// Runs an engine on a solid. @param record  Whether the filtered engine keeps costs and ties; the
/// exact one always does, the float one never.
/// @param center  Strictly inside. @throws Error as the engines.
[[nodiscard]] EngineRun run_engine(Engine engine, const DualHull& solid,
                                   const RationalPoint& center, const SimplifyOptions& options,
                                   bool record);

/// The halfspaces that the first `count` removals leave, in canonical order.
[[nodiscard]] std::vector<Halfspace> left_after(std::span<const Halfspace> halfspaces,
                                                const EngineRun& run, std::size_t count);

}  // namespace convexact
