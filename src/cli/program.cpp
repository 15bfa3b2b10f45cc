// SPDX-License-Identifier: MIT
#include "cli/program.hpp"

namespace convexact::cli {
namespace {

// Every picture must be a page.
void check_picture(Command& command) {
  if (std::optional<Option> picture = command.find_option("--picture")) {
    picture->check([](const std::string& text) {
      return std::string(text.ends_with(".html") ? "" : "expected a name that ends in .html");
    });
  }
}

}  // namespace

int run_program(const Program& parts, int argc, char** argv) {
  install_memory_functions();
  remember_command_line(argc, argv);
  Command program(parts.description, "convexact");
  program.footer(parts.footer);
  program.set_version_flag("--version", CONVEXACT_VERSION);
  program.require_subcommand(1);
  int exit_code = 0;
  for (const auto& add_to : parts.commands) add_to(program, exit_code);
  for (const auto& command : program.subcommands()) check_picture(*command);
  const std::optional<NotRun> reason = program.parse(argc, argv);
  return reason ? end_of_parsing(program, *reason) : exit_code;
}

}  // namespace convexact::cli
