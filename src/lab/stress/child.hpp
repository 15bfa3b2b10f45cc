// SPDX-License-Identifier: MIT
// child.hpp - a part of a sweep in a process of its own, with limits of time and memory.
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "conform/program.hpp"
#include "io/json_document.hpp"
#include "lab/stress/stress_report.hpp"

namespace convexact {

/// The limits of each process.
struct StressLimits {
  /// Of processor time, more than 0; an integer. A process that only waits gets 20 times as long.
  double seconds = 120;
  std::uint64_t memory = 0;  ///< Bytes of address space; 0 for no limit.
};

/// The end of a process that was to answer: its answer, or why there is none.
struct ChildEnd {
  std::optional<std::string> answer;
  StressEnd end = StressEnd::Reached;
  std::string why;
  std::uint64_t memory = 0;  ///< Peak, bytes.
};

/// A process whose result is the document that `work` makes.
[[nodiscard]] std::unique_ptr<ChildProcess> start_child(const std::function<Json()>& work,
                                                        const StressLimits& limits);

/// @param run  Of the child, which has ended.
[[nodiscard]] ChildEnd end_of(const ProgramRun& run, const ChildProcess& process,
                              const StressLimits& limits);

}  // namespace convexact
