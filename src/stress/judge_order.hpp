// SPDX-License-Identifier: MIT
// judge_order.hpp - removals, costs and ties of one run, judged step by step and by the definition.
#pragma once
#include <string>
#include <vector>

#include "convexact/verify_run.hpp"
#include "stress/judge.hpp"

namespace convexact {

/// What is judged against: the judge's own dual hull.
struct JudgedSolid {
  const DualHull& dual;
  RationalPoint center;  ///< Strictly inside.
};

/// Follows the removals, as far as the limits say, with whatever the answer claims of them.
[[nodiscard]] TraceVerdict follow(const JudgedSolid& solid, const EngineAnswer& answer,
                                  const JudgeLimits& limits);

/// Of an engine that promises the greedy order: what is wrong with it. @param verdict  Of follow().
[[nodiscard]] std::vector<std::string> faults_of_order(const EngineAnswer& answer,
                                                       const TraceVerdict& verdict);

/// By the definition: from where at most `limits.definition` halfspaces are left, each removal must
/// be the cheapest of all, at the recorded cost, with all ties; and an end above the wanted number
/// must have nothing bounded left to remove.
[[nodiscard]] std::vector<std::string> faults_by_definition(const JudgedSolid& solid,
                                                            const EngineAnswer& answer,
                                                            const JudgeLimits& limits);

/// Whether the volumes that the pipeline reports are those of what it started from and of what it
/// ended with, both intersected from scratch, and differ by the sum of the costs.
/// Of large solids only what they end with.
[[nodiscard]] std::vector<std::string> faults_of_volume(const JudgedSolid& solid,
                                                        const EngineAnswer& answer,
                                                        const JudgeLimits& limits);

}  // namespace convexact
