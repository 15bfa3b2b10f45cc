// SPDX-License-Identifier: MIT
// command.hpp - the common parts of the subcommands: global options, the end of a run, the report
// of errors.
#pragma once
#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "cli/options.hpp"
#include "cli/parser.hpp"
#include "convexact/error.hpp"
#include "convexact/scene.hpp"
#include "io/json_document.hpp"

namespace convexact::cli {

/// Options that every subcommand understands.
struct GlobalOptions {
  bool json = false;             ///< One JSON object on standard output, even on failure.
  std::uint64_t seed = 1;        ///< Of every random order; no answer depends on it.
  std::uint64_t max_memory = 0;  ///< Bytes of heap; 0 for no limit.
  bool stages = false;           ///< List every stage in the text for people.
  bool verbose = false;          ///< And what else few people ask for.
};

/// Adds --json, --seed and --max-memory to a subcommand.
void add_global_options(Command& command, GlobalOptions& options);

/// Adds --stages to a subcommand whose summary ends with the time of its stages.
void add_stages_option(Command& command, GlobalOptions& options);
/// Adds --verbose, too, for a summary that has more to say.
void add_verbose_option(Command& command, GlobalOptions& options);

/// Each adds its subcommand to the program; the subcommand's exit code goes to `exit_code`.
void add_conform_command(Command& program, int& exit_code);
void add_bvh_command(Command& program, int& exit_code);
void add_decompose_command(Command& program, int& exit_code);
void add_generate_command(Command& program, int& exit_code);
void add_hull_command(Command& program, int& exit_code);
void add_query_command(Command& program, int& exit_code);
void add_shrink_command(Command& program, int& exit_code);
void add_simplify_command(Command& program, int& exit_code);
void add_teach_command(Command& program, int& exit_code);
void add_verify_command(Command& program, int& exit_code);

/// For a reproducer: the words of the command line, and each input as soon as it is read.
void remember_command_line(int argc, char** argv);
void remember_input(const std::string& name, std::shared_ptr<const std::string> bytes);
/// The program as it was called: a name, or a path.
[[nodiscard]] const std::string& called_as();

/// Reports an error in the command line, unknown options first, or prints the requested help;
/// returns the exit code.
int end_of_parsing(const Command& program, const NotRun& reason);

/// Runs a subcommand's work and turns each Error into its sentence on standard error (or, with
/// --json, into {"error": {...}} on standard output) and its exit code. Internal errors leave a
/// reproducer in the current folder.
int run_guarded(const GlobalOptions& options, const std::function<int()>& work);

/// Adds the global options, and lets the command run `run` in this way.
template <class Arguments>
void finish_command(Command& command, const std::shared_ptr<Arguments>& arguments, int& exit_code,
                    int (*run)(const Arguments&)) {
  add_global_options(command, arguments->global);
  command.callback([arguments, run, &exit_code] {
    exit_code = run_guarded(arguments->global, [&] { return run(*arguments); });
  });
}

/// Reports that an input encloses no volume, with the proof, and returns the exit code.
int report_not_solid(const GlobalOptions& options, const std::string& name, const NotSolid& reason);

/// Prints to standard output.
/// @throws Error Stopped if its reader has closed the pipe; Unwritable if it cannot be written.
void print(const std::string& text);
void print(const Json& document);

/// Becomes true when an interrupt (Ctrl-C, SIGTERM) arrives; long loops check it and end with
/// Stopped.
const std::atomic<bool>& interrupted() noexcept;
/// While a search that can end with its best result so far is running, the first interrupt makes
/// this true instead, once in a run.
const std::atomic<bool>& settled() noexcept;
void let_interrupt_settle(bool may_settle) noexcept;

/// Finds a file or folder that comes with the program: "vectors", "data/bunny.obj", "profiles.json"
/// and the like. The first place that `is_it` accepts: beside the installed program; in the source
/// folder, if the program runs where it was built; or in the folder for which the build was
/// configured.
[[nodiscard]] std::optional<std::filesystem::path> find_shipped(
    const std::filesystem::path& name,
    const std::function<bool(const std::filesystem::path&)>& is_it =
        [](const std::filesystem::path& place) { return std::filesystem::exists(place); });

// memory.cpp: how much memory the program may use, and how it ends when that is used up.

/// Makes GMP and MPFR allocate through memory.cpp. To be called before any number exists.
void install_memory_functions();

/// From now on at most `bytes` of heap may be in use; memory in use already is not counted.
///
/// C++ gets std::bad_alloc from seven eighths of that on, so that a run ends by unwinding, as after
/// any error. No exception may pass through GMP: it may use the last eighth, and if that is used
/// up, too, the process ends, after `last_words`, with the exit code of Stopped.
void limit_memory(std::uint64_t bytes, std::function<void()> last_words);

/// To be called before an error is reported, which takes memory, too.
void lift_memory_limit() noexcept;

}  // namespace convexact::cli
