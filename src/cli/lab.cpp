// SPDX-License-Identifier: MIT
#include "cli/lab.hpp"

#include <unistd.h>

#include <algorithm>
#include <filesystem>

namespace convexact::cli {
namespace {

constexpr const char* kLab = "convexact-lab";
constexpr LabCommand kLabCommands[] = {kDiffCommand, kReportCommand, kStressCommand,
                                       kCompareCommand};

}  // namespace

std::function<void(Command&, int&)> listed(const LabCommand& command) {
  return [command](Command& program, int&) {
    program.add_subcommand(command.name, command.description);
  };
}

bool is_lab_command(std::string_view word) {
  return std::any_of(std::begin(kLabCommands), std::end(kLabCommands),
                     [&](const LabCommand& command) { return word == command.name; });
}

int start_lab(char** argv) {
  std::error_code failed;
  const std::filesystem::path folder =
      std::filesystem::read_symlink("/proc/self/exe", failed).parent_path();
  for (const std::filesystem::path& place : {folder / kLab, folder / "../lab" / kLab}) {
    execv(place.c_str(), argv);  // returns only if it fails
  }
  execvp(kLab, argv);
  GlobalOptions options;
  for (char** word = argv; *word != nullptr; ++word) options.json |= *word == std::string("--json");
  return run_guarded(options, [&]() -> int {
    throw Error(ErrorCode::InvalidArgument,
                std::string(argv[1]) + " is a subcommand of " + kLab +
                    ", which was found neither beside convexact nor in PATH: build it by "
                    "`ninja src/lab/convexact-lab` (./dev run does), or install it");
  });
}

}  // namespace convexact::cli
