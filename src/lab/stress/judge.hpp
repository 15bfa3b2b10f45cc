// SPDX-License-Identifier: MIT
// judge.hpp - decides whether the answers of engines about one input are right, without relying on
// any part of them.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "convexact/verify_order.hpp"
#include "lab/stress/answer.hpp"
#include "lab/stress/input.hpp"

namespace convexact {

/// One run for each answer, with its faults. docs/stress.md has the list of checks.
[[nodiscard]] std::vector<StressRun> judge_answers(const StressInput& input, const Shape& shape,
                                                   std::span<const EngineAnswer> answers);

/// The same without a judge: each run has the fault that it was not judged, and `why`.
[[nodiscard]] std::vector<StressRun> unjudged(const StressInput& input,
                                              std::span<const EngineAnswer> answers,
                                              const std::string& why);

// The parts of judge_answers().

/// The reference of the judge: a dual hull that it computes itself.
struct CenteredDual {
  const DualHull& dual;
  RationalPoint center;  ///< Strictly inside.
};

/// Whether the value is in the interval. A root or an angle is known to 256 bits: the answer is no
/// if these show that it is outside.
[[nodiscard]] bool holds(const ReportedVolume& reported, const Cost& value);

/// Whether both are missing, or nothing shows that they differ.
[[nodiscard]] bool may_be_same(const std::optional<Cost>& a, const std::optional<Cost>& b);

/// Whether the removals are different halfspaces of the run, and leave at least four.
[[nodiscard]] bool is_valid_order(const Run& run);

/// Follows the removals with all claims of the answer about them; for large solids only the first
/// ones.
[[nodiscard]] TraceVerdict follow(const CenteredDual& solid, const EngineAnswer& answer);

/// The faults of an engine that promises the greedy order. @param verdict  Of follow().
[[nodiscard]] std::vector<std::string> faults_of_order(const EngineAnswer& answer,
                                                       const TraceVerdict& verdict);

/// By the definition, once few halfspaces are left: each is removed and the rest intersected from
/// scratch. Each removal must be the cheapest of all, at the recorded cost, with all ties; and an
/// end above the wanted number must have no bounded removal left.
[[nodiscard]] std::vector<std::string> faults_by_definition(const CenteredDual& solid,
                                                            const EngineAnswer& answer);

/// Whether the volumes that the pipeline reports are those of the solids at its start and at its
/// end, both intersected from scratch; likewise the measure of the costs, and whether the two
/// measures differ by the sum of the costs. For large solids only the end is tested.
[[nodiscard]] std::vector<std::string> faults_of_volume(const CenteredDual& solid,
                                                        const EngineAnswer& answer);

/// Follows the moves of a search from the end of the removals: each must exchange halfspaces that
/// are there for as many others, leave a bounded solid of less measure, and state that measure. The
/// last one must be the result. Every solid is intersected from scratch.
[[nodiscard]] std::vector<std::string> faults_of_search(const CenteredDual& solid,
                                                        const EngineAnswer& answer);

/// For the float engine: adds to the run its errors against exact costs and minima in the states
/// that it reached, and its faults. An error is no fault; an error beyond the engine's stated bound
/// is one, and so is an unbounded solid. @param verdict  Of follow().
void judge_float(const EngineAnswer& answer, const TraceVerdict& verdict, StressRun& run);

/// The largest distance of the ends of a reported cost from the true cost, relative to the latter;
/// rounded up, and infinite if an end is.
[[nodiscard]] double error_of_cost(const ReportedVolume& reported, const Cost& cost);

}  // namespace convexact
