// SPDX-License-Identifier: MIT
#include "cli/kept_failures.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "cli/command.hpp"
#include "cli/outputs.hpp"
#include "cli/program_case.hpp"
#include "convexact/error.hpp"
#include "convexact/io.hpp"
#include "io/json.hpp"
#include "wire/conformance_report.hpp"

namespace convexact::cli {
namespace {

namespace fs = std::filesystem;

// A word for a shell.
std::string shell_word(const std::string& word) {
  constexpr const char* kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_@%+=:,./-";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

// Points go into an OBJ, which every viewer shows; a program that reads another format gets its
// bytes again from shrink.
struct KeptInput {
  std::string name, bytes;
};
KeptInput input_of(const ConformRun& run, const FailedRun& failed) {
  const auto* points = std::get_if<PointSet>(&failed.vector.input);
  const std::string name = "input." + run.input_format;
  if (points == nullptr || run.input_format == "obj") return {name, failed.input};
  return {"input.obj", *input_bytes(failed.vector, "obj", run.promise.numbers)};
}

// What shrink finds again: how the program ended, or a claim of verify. The rest, such as a volume
// that is too large, is judged by what the vector knows. And it reads and writes the input.
bool is_seen_by_shrink(const ConformRun& run, const FailedRun& failed) {
  if (std::holds_alternative<RawFile>(failed.vector.input) || run.input_format == "stl") {
    return false;
  }
  switch (failed.entry.result.outcome()) {
    case Outcome::AcceptedUnusable:  // nothing is simpler than an input without volume
    case Outcome::TooLoose:
    case Outcome::Undecided:
    case Outcome::NotStarted:
    case Outcome::Passed:
      return false;
    case Outcome::TooManyFacets:
      return run.promise.asks == Asks::Simplify || run.promise.max_facets.has_value();
    default:
      return true;
  }
}

// The claims of verify that an outcome stands for, so that shrink looks for no other failure.
std::string claims_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::UnreadableOutput:
      return "candidate-readable,candidate-finite";
    case Outcome::NoSolid:
      return "candidate-solid,candidate-bounded";
    case Outcome::NotEnclosing:
      return "contains-input";
    case Outcome::NotInside:
      return "inside-input";
    case Outcome::BrokenMesh:
      return "mesh-closed,mesh-oriented";
    case Outcome::NotConvex:
      return "mesh-planar,mesh-convex";
    case Outcome::NotTheHull:
      return "is-hull";
    case Outcome::TooManyFacets:
      return "max-facets";
    case Outcome::TooManyVertices:
      return "max-vertices";
    case Outcome::TooManyFacetVertices:
      return "max-facet-vertices";
    default:
      return "";
  }
}

}  // namespace

std::string shrink_line(const ConformRun& run, const PromiseOptions& promise,
                        const FailedRun& failed, const std::string& input,
                        const std::string& minimal) {
  if (!is_seen_by_shrink(run, failed)) return {};
  std::vector<std::string> words = {called_as(), "shrink", input, "-o", minimal};
  const auto add = [&](const char* option, const std::string& value) {
    words.insert(words.end(), {option, value});
  };
  const std::vector<std::string> promised = promise.words();
  words.insert(words.end(), promised.begin(), promised.end());
  if (mentions(run.program, "{faces}")) {
    if (!promise.is_asked()) add("--asks", name_of(run.promise.asks));
    add("--faces", std::to_string(failed.faces));
  }
  const std::string claims = claims_of(failed.entry.result.outcome());
  if (!claims.empty()) add("--claims", claims);
  if (run.output_format != "obj") add("--output-format", run.output_format);
  add("--time-limit", fmt::format("{}", run.limits.seconds));
  if (run.limits.memory != 0) add("--memory-limit", std::to_string(run.limits.memory));
  words.emplace_back("--");
  words.insert(words.end(), run.program.begin(), run.program.end());
  for (std::string& word : words) word = shell_word(word);
  return join(words, " ");
}

KeptFailures::KeptFailures(std::string folder, const ConformRun& run, const PromiseOptions& promise)
    : folder_(std::move(folder)), run_(run), promise_(promise) {
  require_folder(folder_);
  std::error_code failed;
  if (fs::exists(folder_, failed) && !fs::is_empty(folder_, failed)) {
    throw Error(ErrorCode::InvalidArgument,
                "--keep-failing " + folder_ +
                    ": the folder is not empty; name another, so that failures of two runs are not "
                    "mixed");
  }
}

void KeptFailures::operator()(const FailedRun& failed) const {
  const fs::path place = fs::path(folder_) / failed.entry.vector->id;
  std::error_code error;
  fs::create_directories(place, error);
  if (error) throw Error(ErrorCode::Unwritable, place.string() + ": " + error.message());
  AtomicOutput files;
  const auto add = [&](const std::string& name, const std::string& bytes) {
    files.add((place / name).string(), bytes);
  };
  const KeptInput input = input_of(run_, failed);
  add(input.name, input.bytes);
  add("printed.txt", failed.run.printed);
  add("verdict.json", write_json(conformance_entry_json(failed.entry), 2) + "\n");
  const std::string line = shrink_line(run_, promise_, failed, (place / input.name).string(),
                                       (place / ("minimal." + run_.input_format)).string());
  if (!line.empty()) add("shrink.sh", "#!/bin/sh\n" + line + "\n");
  files.commit();
  // What was written may be anything, even a folder or a device: only a file is kept.
  if (!fs::is_regular_file(failed.output_path, error)) return;
  fs::copy_file(failed.output_path, place / ("output." + run_.output_format), error);
  if (error) throw Error(ErrorCode::Unwritable, place.string() + ": " + error.message());
}

}  // namespace convexact::cli
