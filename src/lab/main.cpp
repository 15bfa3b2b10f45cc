// SPDX-License-Identifier: MIT
// The program convexact-lab: experiments, one subcommand per file.
#include "cli/program.hpp"
#include "lab/commands.hpp"

namespace {

constexpr const char* kDescription =
    "convexact-lab holds the experiments of convexact. `convexact report` and so on start it.\n";

constexpr const char* kFooter =
    "Examples:\n"
    "  convexact diff tests/data/spot.obj --faces 18\n"
    "  convexact report tests/data/spot.obj -o out\n"
    "  convexact stress needle slab\n"
    "  convexact compare tests/data/bunny.obj --faces 18";

}  // namespace

int main(int argc, char** argv) {
  using namespace convexact::cli;
  return run_program(
      {kDescription,
       kFooter,
       {add_diff_command, add_report_command, add_stress_command, add_compare_command}},
      argc, argv);
}
