// SPDX-License-Identifier: MIT
// judge.hpp - whether engines told the truth about one input; nothing that they say is taken from
// them.
#pragma once
#include <span>
#include <vector>

#include "stress/answer.hpp"
#include "stress/input.hpp"

namespace convexact {

struct JudgeLimits {
  /// Solids with at most so many halfspaces left are judged by the definition alone: each is taken
  /// away and the rest intersected from scratch.
  std::size_t definition = 12;
  /// Solids of more halfspaces are large. Of these costs, minima and ties are computed again for
  /// the first `steps` removals, and nothing of that size is intersected from scratch.
  std::size_t whole = 2500;
  std::size_t steps = 200;
};

/// One run for each answer, with what is wrong with it. docs/stress.md has the list of checks.
[[nodiscard]] std::vector<StressRun> judge_answers(const StressInput& input, const Shape& shape,
                                                   std::span<const EngineAnswer> answers,
                                                   const JudgeLimits& limits = {});

/// The same without a judge: each run has the fault that it was not judged, and `why`.
[[nodiscard]] std::vector<StressRun> unjudged(const StressInput& input,
                                              std::span<const EngineAnswer> answers,
                                              const std::string& why);

}  // namespace convexact
