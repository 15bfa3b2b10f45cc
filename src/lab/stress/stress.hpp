// SPDX-License-Identifier: MIT
// stress.hpp - a sweep: every engine on every input, each in a separate process, all judged.
#pragma once
#include <functional>
#include <span>
#include <vector>

#include "lab/stress/child.hpp"
#include "lab/stress/judge.hpp"

namespace convexact {

struct StressRequest {
  std::vector<Engine> engines = {Engine::Exact, Engine::Filtered, Engine::Float};
  CostMeasure cost = CostMeasure::Volume;  ///< The measure that the runs keep small.
  /// After the removals of the exact and the filtered engine, where few halfspaces are left.
  SearchRequest search = {};
  StressLimits
      limits;  ///< Of each process: one engine on one input, or the judge of their answers.
  std::size_t processes = 1;  ///< At the same time, >= 1.
  /// The engines under test; replaced in tests of the judge itself.
  std::function<EngineAnswer(const Shape&, const Question&)> answer = answer_of;
  /// Told of the runs on each input as soon as they are judged.
  std::function<void(std::span<const StressRun>)> judged = [](std::span<const StressRun>) {};
  Watch watch = {};  ///< Told of the inputs that are done; ends it: Error Stopped.
};

/// The runs in the order of the inputs and, of each, of the engines. Every failure of an engine or
/// of the judge becomes a run with a fault. Forks: a child process has no other thread of the
/// caller, and must not need one.
/// @throws Error InvalidArgument for an invalid request; Stopped.
[[nodiscard]] StressReport stress(std::span<const StressInput> inputs,
                                  const StressRequest& request);

}  // namespace convexact
