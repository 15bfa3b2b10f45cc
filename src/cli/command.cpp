// SPDX-License-Identifier: MIT
#include "cli/command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <new>

#include "cli/reproducer.hpp"
#include "conform/program.hpp"
#include "io/json.hpp"
#include "number/text.hpp"
#include "wire/stage_report.hpp"

namespace convexact::cli {
namespace {

namespace fs = std::filesystem;

std::atomic<bool> interrupt_flag = false, settle_flag = false, may_settle_flag = false;
static_assert(std::atomic<bool>::is_always_lock_free, "set by a signal handler");

// The first interrupt makes the work end by itself, so that no half-written file remains; the
// second one, with the default action restored, ends the process. A search that can settle uses up
// an earlier interrupt, once in a run: after it the searches of further objects settle, too.
extern "C" void on_interrupt(int signal) {
  if (may_settle_flag.exchange(false)) {
    settle_flag = true;
    return;
  }
  interrupt_flag = true;
  std::signal(signal, SIG_DFL);
}

Reproducer& reproducer() {
  static Reproducer kept;
  return kept;
}

// An internal error, with the file for a bug report.
Error with_reproducer(const Error& error) {
  reproducer().failure = error.what();
  const std::string path = write_reproducer(reproducer(), ".");
  const std::string hint =
      path.empty() ? "please report it with the input" : "please report it with " + path;
  return {ErrorCode::Internal, std::string(error.what()) + "; this is a bug in convexact: " + hint};
}

// Reports an error, with further facts for --json, and returns its exit code.
int report(const GlobalOptions& options, const Error& error, const Json& proof = {}) {
  const int code = exit_code(error.code());
  if (options.json) {
    Json body = error_json(error);
    if (!proof.is_null()) body["proof"] = proof;
    std::cout << write_json({{"error", body}}, 2) << std::endl;
  } else {
    std::cerr << "convexact: " << error.what() << std::endl;
  }
  return code;
}

Error out_of_memory(const GlobalOptions& options) {
  if (options.max_memory == 0) return {ErrorCode::Stopped, "out of memory"};
  return {ErrorCode::Stopped,
          fmt::format("out of memory: --max-memory allows {} bytes", options.max_memory)};
}

void limit_memory(const GlobalOptions& options) {
  if (options.max_memory == 0) return;
  cli::limit_memory(options.max_memory, [&options] {
    remove_scratch_folders();
    report(options, out_of_memory(options));
  });
}

// The command line up to --, which a program and its arguments follow.
std::vector<std::string> own_words() {
  const std::vector<std::string>& all = reproducer().command_line;
  return {all.begin() + 1, std::find(all.begin() + 1, all.end(), "--")};
}

std::string unknown_word(const std::string& kind, const std::string& word,
                         const std::vector<std::string>& known, const std::string& hint) {
  const std::string meant = did_you_mean(word, known);
  return "there is no " + kind + " " + in_quotes(word) + (meant.empty() ? ";" : meant) + " " + hint;
}

// Says which is the first word that looks like an option but is no option of its subcommand. The
// parser's message would also name the words after it.
std::optional<std::string> unknown_option(const Command& program,
                                          const std::vector<std::string>& words) {
  std::vector<const Command*> commands;
  for (const Command* command = &program; command != nullptr;
       command = command->parsed_subcommand()) {
    commands.push_back(command);
  }
  for (const std::string& word : words) {
    // A minus sign before a digit belongs to a number.
    if (word.size() < 2 || word[0] != '-' || (word[1] >= '0' && word[1] <= '9')) continue;
    const std::string name = word[1] == '-' ? word.substr(0, word.find('=')) : word.substr(0, 2);
    const bool is_known =
        std::any_of(commands.begin(), commands.end(),
                    [&](const Command* command) { return command->find_option(name).has_value(); });
    if (is_known) continue;
    std::vector<std::string> names;
    for (const Command* command : commands) {
      for (const Option& option : command->options()) names.push_back(option.name());
    }
    return unknown_word("option", name, names, "--help names the options");
  }
  return std::nullopt;
}

// Says that the first word is in the place of a subcommand but is none.
std::optional<std::string> unknown_subcommand(const Command& program,
                                              const std::vector<std::string>& words) {
  if (words.empty() || words[0].starts_with('-')) return std::nullopt;
  std::vector<std::string> names;
  for (const auto& command : program.subcommands()) {
    if (command->is_called(words[0])) return std::nullopt;
    names.push_back(command->name());
  }
  return unknown_word("subcommand", words[0], names, "--help names them");
}

}  // namespace

void add_global_options(Command& command, GlobalOptions& options) {
  command.add_flag("--json", options.json, "print one JSON object, even on failure");
  add_count(command, "--seed", options.seed, {},
            "seed of the random orders; the answer does not depend on it");
  add_bytes(command, "--max-memory", options.max_memory,
            "stop with exit code 6 rather than use more heap, e.g. 1.5GB");
}

void add_stages_option(Command& command, GlobalOptions& options) {
  command.add_flag("--stages", options.stages,
                   "list every stage with its time, or why it was not needed (--json always does)");
}

void add_verbose_option(Command& command, GlobalOptions& options) {
  add_stages_option(command, options);
  command.add_flag("--verbose", options.verbose,
                   "every stage, how steps were proven, and what rounding added");
}

void remember_command_line(int argc, char** argv) {
  reproducer().command_line.assign(argv, argv + argc);
}

const std::string& called_as() { return reproducer().command_line.front(); }

void remember_input(const std::string& name, std::shared_ptr<const std::string> bytes) {
  reproducer().inputs.emplace_back(name, std::move(bytes));
}

int end_of_parsing(const Command& program, const NotRun& reason) {
  if (reason.is_answer) {
    return run_guarded({}, [&] {
      print(reason.text);
      return 0;
    });
  }
  const std::vector<std::string> words = own_words();
  GlobalOptions options;
  options.json = std::find(words.begin(), words.end(), "--json") != words.end();
  std::string what = reason.text;
  const auto subcommand = unknown_subcommand(program, words);
  const auto option = unknown_option(program, words);
  if (subcommand || option) {
    what = subcommand ? *subcommand : *option;
  } else if (!reason.is_of_value) {
    what += "; --help names the options";
  }
  return report(options, Error(ErrorCode::InvalidArgument, what));
}

int run_guarded(const GlobalOptions& options, const std::function<int()>& work) {
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
  // A closed pipe and a file that grows too large are errors of writing, not the end of the
  // process.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    limit_memory(options);
    return work();
  } catch (const Error& error) {
    lift_memory_limit();
    const bool is_bug = error.code() == ErrorCode::Internal;
    return report(options, is_bug ? with_reproducer(error) : error);
  } catch (const std::bad_alloc&) {
    lift_memory_limit();
    return report(options, out_of_memory(options));
  } catch (const std::exception& error) {
    lift_memory_limit();
    return report(options, with_reproducer(Error(ErrorCode::Internal, error.what())));
  }
}

int report_not_solid(const GlobalOptions& options, const std::string& name,
                     const NotSolid& reason) {
  const Error error = Error(ErrorCode::NoInterior, describe(reason)).in_file(name);
  return report(options, error, proof_json(reason));
}

void print(const std::string& text) {
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0) {
    return;
  }
  if (errno == EPIPE)
    throw Error(ErrorCode::Stopped, "the reader of standard output has closed the pipe");
  throw Error(ErrorCode::Unwritable,
              std::string("standard output cannot be written: ") + std::strerror(errno));
}

void print(const Json& document) { print(write_json(document, 2) + "\n"); }

std::optional<fs::path> find_shipped(const fs::path& name,
                                     const std::function<bool(const fs::path&)>& is_it) {
  std::error_code failed;
  const fs::path folder = fs::read_symlink("/proc/self/exe", failed).parent_path();
  std::vector<fs::path> places = {folder / "../share/convexact" / name};
  for (fs::path above = folder; above != above.parent_path(); above = above.parent_path()) {
    places.push_back(above / "tests" / name);
    places.push_back(above / "share/convexact" / name);
  }
  places.push_back(fs::path(CONVEXACT_DATADIR) / name);
  for (const fs::path& place : places) {
    if (is_it(place)) return place.lexically_normal();
  }
  return std::nullopt;
}

const std::atomic<bool>& interrupted() noexcept { return interrupt_flag; }
const std::atomic<bool>& settled() noexcept { return settle_flag; }
void let_interrupt_settle(bool may_settle) noexcept {
  may_settle_flag = may_settle && !settle_flag;
}

}  // namespace convexact::cli
