// SPDX-License-Identifier: MIT
// verify_stdio.hpp - verify --stdio: a verdict per line, for test suites in any language.
#pragma once
#include <optional>

namespace convexact::cli {

/// Answers each line of standard input with a line on standard output, at once, until the end of
/// the input; blank lines have no answer. Verdicts and errors are in the answers, so the exit code
/// is 0. @param time_limit  Seconds for each verdict; beyond them its line is an error.
/// @throws Error Stopped if the reader of the answers has closed the pipe.
int run_verify_stdio(std::optional<double> time_limit);

}  // namespace convexact::cli
