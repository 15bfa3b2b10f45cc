// SPDX-License-Identifier: MIT
// stdio_loop.hpp - subcommands that answer requests on standard input, a line of JSON each.
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "cli/command.hpp"

namespace convexact::cli {

struct StdioOptions {
  const Command* command = nullptr;  ///< Set by add_stdio_options().
  bool is_asked = false;             ///< --stdio
  std::optional<double> time_limit;  ///< --time-limit, in seconds

  /// @throws Error InvalidArgument for other options and arguments together with --stdio, and for a
  ///               limit without it.
  void require_sensible() const;
};

/// Adds --stdio and --time-limit. @param answers  The answer to a line: "one verdict".
void add_stdio_options(Command& command, StdioOptions& options, const std::string& answers);

/// Answers each line of standard input with a line on standard output, at once, until the end of
/// the input; blank lines have no answer. Errors are in the answers, so the exit code is 0.
/// @param kind  Of the requests, as answer_line_of().
int answer_lines(const StdioOptions& options, std::string_view kind);

}  // namespace convexact::cli
