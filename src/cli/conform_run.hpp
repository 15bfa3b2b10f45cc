// SPDX-License-Identifier: MIT
// conform_run.hpp - runs a program over vectors, several at a time.
#pragma once
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "oracle/conformance_report.hpp"

namespace convexact::cli {

struct ConformRun {
  std::vector<std::string> program;  ///< Its words, with {input}, {output} and perhaps {faces}.
  ProgramLimits limits{30, 0};
  std::string input_format = "obj", output_format = "obj";  ///< Extensions.
  std::size_t jobs = 1;                                     ///< Vectors at the same time.
  Promise promise;
};

/// Runs the program over the chosen vectors, and judges its outputs. Only the seconds of the result
/// depend on the number of jobs. An interrupt ends it.
/// @throws Error InvalidArgument if the program cannot be started; Stopped.
[[nodiscard]] ConformanceReport run_vectors(std::span<const TestVector> vectors,
                                            const std::function<bool(const TestVector&)>& is_chosen,
                                            const ConformRun& options);

}  // namespace convexact::cli
