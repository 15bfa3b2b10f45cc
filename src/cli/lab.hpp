// SPDX-License-Identifier: MIT
// lab.hpp - the subcommands for experiments, which the program convexact-lab holds.
//
// `convexact report` and so on start that program, as git starts its subcommands. So enclosing a
// shape takes no experiments to be compiled.
#pragma once
#include <functional>
#include <string_view>

#include "cli/command.hpp"

namespace convexact::cli {

/// The name of a subcommand, and its line in --help.
struct LabCommand {
  const char* name;
  const char* description;
};

inline constexpr LabCommand kDiffCommand = {
    "diff", "compare engines step by step, and explain the steps where they differ"};
inline constexpr LabCommand kReportCommand = {
    "report", "measure error against run time; writes report.html, .json and .csv"};
inline constexpr LabCommand kStressCommand = {
    "stress", "run every engine on ever harder inputs, and judge every answer"};
inline constexpr LabCommand kCompareCommand = {
    "compare", "measure exactly how tightly other methods enclose the inputs"};

/// Lists a subcommand of the lab in --help.
[[nodiscard]] std::function<void(Command&, int&)> listed(const LabCommand& command);

/// Whether a word of the command line names one of these subcommands.
[[nodiscard]] bool is_lab_command(std::string_view word);

/// Becomes the program convexact-lab with the same arguments. Looks for it beside this program,
/// where the build puts it, and in PATH.
/// @returns The exit code, after an error, if there is no such program.
int start_lab(char** argv);

}  // namespace convexact::cli
