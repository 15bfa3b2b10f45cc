// SPDX-License-Identifier: MIT
// convexact conform: runs a program over the conformance vectors.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <set>

#include "cli/command.hpp"
#include "cli/kept_failures.hpp"
#include "cli/options.hpp"
#include "cli/outputs.hpp"
#include "cli/program_case.hpp"
#include "cli/progress.hpp"
#include "cli/promise_options.hpp"
#include "cli/shipped_vectors.hpp"
#include "convexact/conform.hpp"
#include "convexact/error.hpp"
#include "convexact/io.hpp"
#include "io/json.hpp"
#include "wire/conformance_report.hpp"

namespace convexact::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kConformFooter =
    "Examples:\n"
    "  convexact conform -- my_program {input} {faces} {output}\n"
    "  convexact conform --jobs 4 -o result.json -o result.md -o badge.svg -- my_program {input} "
    "{faces} {output}\n"
    "  convexact conform --asks hull --numbers binary32 -- my_hull {input} {output}\n"
    "  convexact conform --profile jolt -- my_jolt_cooker {input} {output}\n"
    "  convexact conform --keep-failing failing -- my_hull {input} {output}\n"
    "  convexact conform --known-failures known.txt -o result.xml -- my_hull {input} {output}\n"
    "\n"
    "{input}, {faces} and {output} are replaced in each word; no shell is involved. A program\n"
    "passes if its output is of the kind that --asks names, every claim of verify holds, its\n"
    "volume is not too large, and it refuses inputs without volume and malformed files with an\n"
    "exit code other than 0; docs/conform.md has the details. Exit code 0: every required vector\n"
    "passed. 1: one failed.";

struct ConformArguments {
  GlobalOptions global;
  std::string vectors, flag, keep_failing, known_failures;
  std::vector<std::string> skipped_flags;
  int level = 3;
  PromiseOptions promise;
  ConformRun run;
  std::vector<std::string> reports;
};

bool is_chosen(const TestVector& vector, const ConformArguments& options) {
  const auto has = [&](const std::string& flag) {
    return std::find(vector.flags.begin(), vector.flags.end(), flag) != vector.flags.end();
  };
  return vector.level <= options.level && (options.flag.empty() || has(options.flag)) &&
         std::none_of(options.skipped_flags.begin(), options.skipped_flags.end(), has);
}

// Lines with the id of a vector each; what follows a # is a comment.
std::set<std::string> read_known_failures(const std::string& path,
                                          const std::vector<TestVector>& vectors) {
  std::set<std::string> known;
  std::size_t line_number = 0;
  for (const std::string& line : split(read_bytes(path), '\n')) {
    ++line_number;
    const std::string id = trimmed(line.substr(0, line.find('#')));
    if (id.empty()) continue;
    try {
      known.insert(vector_of_id(vectors, id).id);
    } catch (const Error& error) {
      throw Error(error.code(), fmt::format("{}: line {}: {}", path, line_number, error.what()));
    }
  }
  return known;
}

void require_known_flags(const ConformArguments& options, const std::vector<TestVector>& vectors) {
  std::set<std::string> flags;
  for (const TestVector& vector : vectors) flags.insert(vector.flags.begin(), vector.flags.end());
  std::vector<std::string> asked = options.skipped_flags;
  if (!options.flag.empty()) asked.push_back(options.flag);
  for (const std::string& flag : asked) {
    if (flags.contains(flag)) continue;
    throw Error(ErrorCode::InvalidArgument, "no vector has the flag " + in_quotes(flag) +
                                                did_you_mean(flag, {flags.begin(), flags.end()}));
  }
}

std::string report_bytes(const ConformanceReport& report, const std::string& path) {
  const std::string extension = fs::path(path).extension();
  if (extension == ".json") return write_json(conformance_json(report), 2) + "\n";
  if (extension == ".xml") return conformance_junit(report);
  if (extension == ".txt") return failed_ids(report);
  return extension == ".md" ? conformance_markdown(report) : conformance_badge(report);
}

void require_sensible(const ConformArguments& options) {
  for (const std::string& path : options.reports) {
    const std::string extension = fs::path(path).extension();
    constexpr std::array kExtensions = {".json", ".md", ".svg", ".xml", ".txt"};
    if (std::find(kExtensions.begin(), kExtensions.end(), extension) == kExtensions.end()) {
      throw Error(ErrorCode::InvalidArgument,
                  "-o " + path +
                      ": expected a file with the extension .json, .md, .svg, .xml or "
                      ".txt");
    }
  }
  for (const char* place : {"{input}", "{output}"}) {
    if (mentions(options.run.program, place)) continue;
    throw Error(ErrorCode::InvalidArgument, std::string("the program's arguments lack ") + place);
  }
}

// All promises of the program.
Promise promise_of(const ConformArguments& options) {
  const bool has_faces = mentions(options.run.program, "{faces}");
  Promise promise = options.promise.promise(has_faces ? Asks::Simplify : Asks::Enclosure);
  if (promise.asks == Asks::Simplify && !has_faces) {
    throw Error(ErrorCode::InvalidArgument,
                "the program's arguments lack {faces}, and --asks simplify needs it");
  }
  return promise;
}

int run_conform(const ConformArguments& options) {
  require_sensible(options);
  require_outputs(options.reports, {options.known_failures});
  ConformRun run = options.run;
  run.promise = promise_of(options);
  const std::vector<TestVector> vectors = read_vectors(options.vectors);
  require_known_flags(options, vectors);
  std::optional<std::set<std::string>> known;
  if (!options.known_failures.empty()) {
    known = read_known_failures(options.known_failures, vectors);
  }
  std::optional<KeptFailures> kept;
  if (!options.keep_failing.empty()) {
    kept.emplace(options.keep_failing, run, options.promise);
    run.on_failure = [&](const FailedRun& failed) { (*kept)(failed); };
  }
  Progress progress;
  run.watch = progress.watch();
  ConformanceReport report = run_vectors(
      vectors, [&](const TestVector& vector) { return is_chosen(vector, options); }, run);
  progress.clear();
  report.profile = options.promise.profile;
  report.known_failures = std::move(known);
  if (report.entries.empty()) {
    throw Error(ErrorCode::InvalidArgument,
                "no vector is left with this --level, --flag, --skip-flag, --input-format and "
                "these promises");
  }
  AtomicOutput files;
  for (const std::string& path : options.reports) files.add(path, report_bytes(report, path));
  files.commit([&] {
    if (options.global.json) {
      print(conformance_json(report));
    } else {
      print(conformance_text(report));
      if (kept && report.passed() < report.entries.size()) {
        print(fmt::format("Kept: {}/ID for each failure; sh {}/ID/shrink.sh makes it minimal\n",
                          options.keep_failing, options.keep_failing));
      }
    }
  });
  return report.conforms() ? 0 : 1;
}

}  // namespace

void add_conform_command(Command& program, int& exit_code) {
  auto options = std::make_shared<ConformArguments>();
  Command& command = *program.add_subcommand(
      "conform", "run a program over inputs with known answers, and judge its outputs");
  command.footer(kConformFooter);
  command.add_option("PROGRAM", options->run.program, "the program and its arguments, after --")
      ->required()
      ->expected(-1);
  command.add_option("--vectors", options->vectors,
                     "a folder of vectors (default: the shipped ones)");
  add_count(command, "--level", options->level, {1, 3},
            "hardest level of vectors: 1 everyday, 2 hard, 3 cruel");
  command.add_option("--flag", options->flag, "vectors with this flag only, see docs/flags.md");
  command
      .add_option("--skip-flag", options->skipped_flags,
                  "no vectors with this flag; may be repeated")
      ->allow_extra_args(false);
  command.add_option("--known-failures", options->known_failures,
                     "a file with the ids of vectors that are known to fail, a line each, as -o "
                     "NAME.txt writes it: exit code 0 if no other vector fails");
  command.add_option("--keep-failing", options->keep_failing,
                     "a new folder for the input, the output and the verdict of each failure, and "
                     "the command that shrinks it");
  add_promise_options(command, options->promise, "simplify with {faces}, else enclosure", true);
  add_count(command, "--jobs", options->run.jobs, {1, 256}, "how many vectors at the same time");
  add_seconds(command, "--time-limit", options->run.limits.seconds, "time for each vector");
  add_seconds(command, "--judge-time-limit", options->run.judge_seconds,
              "time for the verdict on each output, after which it is undecided, which is no pass; "
              "no limit by default");
  add_bytes(command, "--memory-limit", options->run.limits.memory,
            "address space for each vector, e.g. 2GB; no limit by default");
  add_bytes(command, "--output-limit", options->run.limits.output,
            "size of an output that is read; a larger one is unreadable-output (default: 1GiB)");
  command.add_option("--input-format", options->run.input_format, "what the program reads")
      ->one_of({"obj", "off", "ply", "stl", "xyz", "json", "ine", "txt"})
      ->capture_default_str();
  command
      .add_option("--output-format", options->run.output_format,
                  "what the program writes: a mesh, or halfspaces")
      ->one_of({"obj", "off", "ply", "stl", "json", "ine", "txt"})
      ->capture_default_str();
  command
      .add_option("-o,--output", options->reports,
                  "the report, by its extension: .json, .md, .xml (JUnit), .svg for a badge, or "
                  ".txt for the ids that failed; may be repeated")
      ->allow_extra_args(false);  // otherwise it removes the --

  finish_command(command, options, exit_code, run_conform);
  command.show_first({"--level", "--flag", "--skip-flag", "--known-failures", "--keep-failing",
                      "--asks", "--profile", "--tolerance", "--output-format", "--jobs",
                      "--time-limit", "--output", "--json"});
}

}  // namespace convexact::cli
