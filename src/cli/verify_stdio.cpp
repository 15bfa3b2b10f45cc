// SPDX-License-Identifier: MIT
#include "cli/verify_stdio.hpp"

#include <csignal>
#include <iostream>
#include <string>

#include "cli/command.hpp"
#include "oracle/stdio_request.hpp"

namespace convexact::cli {
namespace {

bool is_blank(const std::string& line) {
  return line.find_first_not_of(" \t\r") == std::string::npos;
}

}  // namespace

int run_verify_stdio(std::optional<double> time_limit) {
  // The process mostly waits for a line, and it writes no files that could remain half-written.
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  std::ios::sync_with_stdio(false);
  std::cin.exceptions(std::ios::badbit);  // a line that no memory holds is not the end of the input
  for (std::string line; std::getline(std::cin, line);) {
    if (!is_blank(line)) print(answer_request(line, time_limit) + "\n");
  }
  return 0;
}

}  // namespace convexact::cli
