// SPDX-License-Identifier: MIT
// commands.hpp - the subcommands of convexact-lab, one per file.
#pragma once
#include "cli/command.hpp"
#include "cli/lab.hpp"

namespace convexact::cli {

/// Each adds its subcommand to the program; the subcommand's exit code goes to `exit_code`.
void add_compare_command(Command& program, int& exit_code);
void add_diff_command(Command& program, int& exit_code);
void add_report_command(Command& program, int& exit_code);
void add_stress_command(Command& program, int& exit_code);

}  // namespace convexact::cli
