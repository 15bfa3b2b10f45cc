// SPDX-License-Identifier: MIT
// The program: one subcommand per file.
#include "cli/lab.hpp"
#include "cli/program.hpp"

namespace {

constexpr const char* kDescription =
    "convexact encloses a 3D shape in few halfspaces, and proves in exact arithmetic that it "
    "does.\n";

constexpr const char* kFooter =
    "Examples:\n"
    "  convexact hull tests/data/spot.obj\n"
    "  convexact simplify tests/data/bunny.obj --faces 18 -o bunny18.obj\n"
    "  convexact verify tests/data/bunny.obj bunny18.obj\n"
    "  convexact decompose tests/data/spot.obj -o spot_parts.obj\n"
    "  convexact simplify --help\n"
    "\n"
    "Exit codes:\n"
    "  0  done, and every claim holds        4  the input has no 3D interior or is unbounded\n"
    "  1  the oracle's answer is no          5  the output cannot be written or represented\n"
    "  2  wrong usage                        6  stopped: memory, interrupt, closed pipe\n"
    "  3  a file is unreadable or malformed  70 an internal verification failed";

}  // namespace

int main(int argc, char** argv) {
  using namespace convexact::cli;
  if (argc > 1 && is_lab_command(argv[1])) return start_lab(argv);
  const Program program{
      kDescription,
      kFooter,
      {add_hull_command, add_simplify_command, add_decompose_command, add_bvh_command,
       add_verify_command, listed(kDiffCommand), listed(kReportCommand), add_conform_command,
       add_generate_command, add_shrink_command, listed(kStressCommand), add_query_command,
       listed(kCompareCommand), add_teach_command}};
  return run_program(program, argc, argv);
}
