// SPDX-License-Identifier: MIT
// command.hpp - what the subcommands share: global options, the end of a run, the report of errors.
#pragma once
#include <CLI/CLI.hpp>
#include <atomic>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/quantity_option.hpp"
#include "convexact/error.hpp"
#include "convexact/number.hpp"
#include "convexact/scene.hpp"
#include "io/names.hpp"
#include "number/text.hpp"

namespace convexact::cli {

/// Options that every subcommand understands.
struct GlobalOptions {
  bool json = false;             ///< One JSON object on standard output, also on failure.
  std::uint64_t seed = 1;        ///< Of every random order; no answer depends on it.
  std::uint64_t max_memory = 0;  ///< Bytes of heap; 0 for no limit.
  bool stages = false;           ///< List every stage in the text for people.
};

/// Adds --json, --seed and --max-memory to a subcommand.
void add_global_options(CLI::App& command, GlobalOptions& options);

/// Adds --stages to a subcommand whose summary ends with the time of its stages.
void add_stages_option(CLI::App& command, GlobalOptions& options);

/// An option that takes one of a few words, in upper or lower case; the help shows them and the
/// default.
template <class Value>
CLI::Option* add_choice(CLI::App& command, const std::string& name, Value& value,
                        const std::map<std::string, Value>& words, const std::string& meaning) {
  std::string list, marked;
  for (const auto& [word, meant] : words) {
    list += (list.empty() ? "" : ", ") + word;
    marked += (marked.empty() ? "" : "|") + word + (meant == value ? "*" : "");
  }
  const std::string note = marked.find('*') == marked.npos ? "" : " (* is the default)";
  return add_text(command, name, meaning + note,
                  [&value, words, list](const auto& option, const auto& text) {
                    const auto found = words.find(CLI::detail::to_lower(text));
                    if (found == words.end()) {
                      throw Error(ErrorCode::InvalidArgument, option + ": expected one of " + list +
                                                                  ", found " + in_quotes(text));
                    }
                    value = found->second;
                  })
      ->type_name(marked);
}

template <class E, std::size_t N>
CLI::Option* add_choice(CLI::App& command, const std::string& name, E& value,
                        const NameTable<E, N>& table, const std::string& meaning) {
  std::map<std::string, E> words;
  for (const auto& [meant, word] : table) words.emplace(word, meant);
  return add_choice(command, name, value, words, meaning);
}

/// Each adds its subcommand to the program; the subcommand's exit code goes to `exit_code`.
void add_conform_command(CLI::App& program, int& exit_code);
void add_diff_command(CLI::App& program, int& exit_code);
void add_generate_command(CLI::App& program, int& exit_code);
void add_hull_command(CLI::App& program, int& exit_code);
void add_report_command(CLI::App& program, int& exit_code);
void add_shrink_command(CLI::App& program, int& exit_code);
void add_simplify_command(CLI::App& program, int& exit_code);
void add_stress_command(CLI::App& program, int& exit_code);
void add_verify_command(CLI::App& program, int& exit_code);

/// For a reproducer: the words of the command line, and each input as soon as it is read.
void remember_command_line(int argc, char** argv);
void remember_input(const std::string& name, const std::string& bytes);

/// Reports an error of the command line, an unknown option before any other, or prints the
/// requested help; returns the exit code.
int end_of_parsing(const CLI::App& program, const CLI::ParseError& error);

/// Runs a subcommand's work and turns each Error into its sentence on standard error (or, with
/// --json, into {"error": {...}} on standard output) and its exit code. Internal errors leave a
/// reproducer in the current folder.
int run_guarded(const GlobalOptions& options, const std::function<int()>& work);

/// Reports that an input encloses no volume, with the proof, and returns the exit code.
int report_not_solid(const GlobalOptions& options, const std::string& name, const NotSolid& reason);

/// Prints to standard output.
/// @throws Error Stopped if its reader has closed the pipe; Unwritable if it cannot be written.
void print(const std::string& text);
void print(const nlohmann::ordered_json& document);

/// Becomes true when an interrupt (Ctrl-C, SIGTERM) arrives; long loops check it and end with
/// Stopped.
const std::atomic<bool>& interrupted() noexcept;

}  // namespace convexact::cli
