// SPDX-License-Identifier: MIT
// The program: one subcommand per file.
#include "cli/command.hpp"

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

// An empty name is refused: a script has lost it, it was not left out. Every picture must be a
// page.
void check_file_names(CLI::App& command) {
  for (const char* const name :
       {"--output", "--picture", "--trace", "--proof", "--tree", "--csv", "--from"}) {
    CLI::Option* const option = command.get_option_no_throw(name);
    if (option == nullptr) continue;
    option->check([](const std::string& text) {
      return std::string(text.empty() ? "expected the name of a file, found ''" : "");
    });
  }
  if (CLI::Option* const picture = command.get_option_no_throw("--picture")) {
    picture->check([](const std::string& text) {
      return std::string(text.ends_with(".html") ? "" : "expected a name that ends in .html");
    });
  }
}

}  // namespace

int main(int argc, char** argv) {
  convexact::cli::install_memory_functions();
  convexact::cli::remember_command_line(argc, argv);
  CLI::App program(kDescription, "convexact");
  program.footer(kFooter);
  program.set_version_flag("--version", CONVEXACT_VERSION);
  program.require_subcommand(1);
  int exit_code = 0;
  using namespace convexact::cli;
  for (const auto add_to :
       {add_hull_command, add_simplify_command, add_decompose_command, add_bvh_command,
        add_verify_command, add_diff_command, add_report_command, add_conform_command,
        add_generate_command, add_shrink_command, add_stress_command, add_query_command,
        add_compare_command, add_teach_command}) {
    add_to(program, exit_code);
  }
  for (CLI::App* const command : program.get_subcommands({})) check_file_names(*command);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return convexact::cli::end_of_parsing(program, error);
  }
  return exit_code;
}
