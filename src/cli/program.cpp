// SPDX-License-Identifier: MIT
#include "cli/program.hpp"

namespace convexact::cli {
namespace {

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

int run_program(const Program& parts, int argc, char** argv) {
  install_memory_functions();
  remember_command_line(argc, argv);
  CLI::App program(parts.description, "convexact");
  program.footer(parts.footer);
  program.set_version_flag("--version", CONVEXACT_VERSION);
  program.require_subcommand(1);
  int exit_code = 0;
  for (const auto& add_to : parts.commands) add_to(program, exit_code);
  for (CLI::App* const command : program.get_subcommands({})) check_file_names(*command);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return end_of_parsing(program, error);
  }
  return exit_code;
}

}  // namespace convexact::cli
