// SPDX-License-Identifier: MIT
// program.hpp - a program with subcommands: convexact, and convexact-lab.
#pragma once
#include <functional>
#include <vector>

#include "cli/command.hpp"

namespace convexact::cli {

/// What a program says of itself, and its subcommands in the order of --help.
struct Program {
  const char* description;
  const char* footer;
  std::vector<std::function<void(Command&, int&)>> commands;
};

/// Parses the command line, runs the subcommand, and returns the exit code.
int run_program(const Program& parts, int argc, char** argv);

}  // namespace convexact::cli
