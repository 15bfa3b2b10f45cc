// SPDX-License-Identifier: MIT
#include "cli/stdio_loop.hpp"

#include <csignal>
#include <iostream>

#include "pages/answers.hpp"

namespace convexact::cli {

void add_stdio_options(Command& command, StdioOptions& options, const std::string& answers) {
  options.command = &command;
  command.add_flag("--stdio", options.is_asked,
                   "answer requests on standard input, one JSON object per line, with " + answers +
                       " per line; takes no other option but --time-limit and --max-memory");
  add_seconds(command, "--time-limit", options.time_limit,
              "with --stdio: time for each request; beyond it the answer is an error");
}

void StdioOptions::require_sensible() const {
  if (!is_asked && time_limit) {
    throw Error(ErrorCode::InvalidArgument, "--time-limit is for each request of --stdio");
  }
  if (!is_asked) return;
  for (const Option& option : command->options()) {
    const std::string name = option.name();
    const bool is_known =
        name == "--stdio" || name == "--time-limit" || name == "--max-memory" || name == "--json";
    if (option.is_given() && !is_known) {
      throw Error(ErrorCode::InvalidArgument, "--stdio takes everything from standard input: " +
                                                  name + " belongs in the requests");
    }
  }
}

int answer_lines(const StdioOptions& options, std::string_view kind) {
  // The process mostly waits for a line, and it writes no files that could remain half-written.
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  std::ios::sync_with_stdio(false);
  std::cin.exceptions(std::ios::badbit);  // a line too long for the memory is not the end of the
                                          // input
  for (std::string line; std::getline(std::cin, line);) {
    const bool is_blank = line.find_first_not_of(" \t\r") == std::string::npos;
    if (!is_blank) print(answer_line_of(kind, line, options.time_limit) + "\n");
  }
  return 0;
}

}  // namespace convexact::cli
