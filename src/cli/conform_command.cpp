// SPDX-License-Identifier: MIT
// convexact conform: somebody's program over the conformance vectors.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "command.hpp"
#include "convexact/format/candidate_file.hpp"
#include "convexact/format/conformance_report.hpp"
#include "convexact/format/halfspace_file.hpp"
#include "convexact/format/test_vector_json.hpp"
#include "convexact/format/write_json.hpp"
#include "convexact/hull/hull.hpp"
#include "convexact/io/atomic_output.hpp"
#include "convexact/io/write_mesh.hpp"
#include "progress.hpp"
#include "quantity_option.hpp"
#include "scratch_folder.hpp"
#include "shipped_files.hpp"

namespace convexact::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kConformFooter =
    "Examples:\n"
    "  convexact conform -- my_program {input} {faces} {output}\n"
    "  convexact conform -o result.json -o result.md -o badge.svg -- my_program {input} {faces} "
    "{output}\n"
    "  convexact conform --level 1 --flag ties -- convexact simplify {input} --faces {faces} -o "
    "{output}\n"
    "\n"
    "{input}, {faces} and {output} are replaced in each word; no shell is involved. A program\n"
    "passes if it writes a bounded solid that contains every point of its input exactly, with at\n"
    "most that many facets, and if it refuses inputs without volume and malformed files with an\n"
    "exit code other than 0. Exit code 0: every required vector passed. 1: one failed.";

struct ConformArguments {
  GlobalOptions global;
  std::string vectors, flag, tolerance;
  int level = 3;
  ProgramLimits limits{30, 0};
  std::string input_format = "obj", output_format = "obj";
  std::vector<std::string> reports;
  std::vector<std::string> program;
};

// A build folder mirrors the source's folders, but not their data.
bool holds_json(const fs::path& folder) {
  std::error_code failed;
  for (const fs::path& file : fs::directory_iterator(folder, failed)) {
    if (file.extension() == ".json") return true;
  }
  return false;
}

std::string find_vectors(const std::string& given) {
  if (!given.empty()) return given;
  if (const auto found = find_shipped("vectors", holds_json)) return *found;
  throw Error(ErrorCode::Unreadable, "the conformance vectors are not to be found: use --vectors");
}

// The input as the program gets it; nothing if the format cannot hold it.
std::optional<std::string> input_bytes(const TestVector& vector, const std::string& extension) {
  const std::string name = "input." + extension;
  const auto mesh_format = mesh_format_of_path(name);
  if (const auto* file = std::get_if<RawFile>(&vector.input)) {
    if (file->extension != extension) return std::nullopt;
    return file->bytes;
  }
  if (const auto* list = std::get_if<HalfspaceList>(&vector.input)) {
    if (mesh_format || list->impossible_row) return std::nullopt;
    return write_halfspaces(list->halfspaces, *halfspace_format_of_path(name));
  }
  if (!mesh_format) return std::nullopt;
  Mesh mesh;
  mesh.points = std::get<PointSet>(vector.input);
  const HullOutcome outcome = convex_hull(mesh.points);
  if (const auto* hull = std::get_if<Hull>(&outcome)) {
    for (std::size_t f = 0; f < hull->facets.size(); ++f) {
      auto& polygon = mesh.polygons.emplace_back();
      for (const PointId corner : hull->facets[f]) polygon.push_back(corner.value);
    }
  } else if (*mesh_format == MeshFormat::Stl) {
    return std::nullopt;  // no triangles to write
  }
  return write_mesh(mesh, *mesh_format);
}

bool is_chosen(const TestVector& vector, const ConformArguments& options) {
  const auto& flags = vector.flags;
  return vector.level <= options.level &&
         (options.flag.empty() ||
          std::find(flags.begin(), flags.end(), options.flag) != flags.end());
}

bool asks_a_program(const TestVector& vector) {
  return std::holds_alternative<SimplifyQuestion>(vector.question) ||
         std::holds_alternative<RefuseQuestion>(vector.question);
}

ConformanceEntry run_vector(const TestVector& vector, const std::string& bytes,
                            const ConformArguments& options, const Tolerance& tolerance) {
  const ScratchFolder scratch;
  const std::string input = scratch.write("input." + options.input_format, bytes);
  const std::string output = scratch.file("output." + options.output_format);
  const auto* question = std::get_if<SimplifyQuestion>(&vector.question);
  const std::size_t faces = question == nullptr ? 8 : question->faces;
  const std::vector<std::string> words = fill_in(
      options.program, {{"input", input}, {"faces", std::to_string(faces)}, {"output", output}});
  const ProgramRun run = run_program(words, options.limits, &interrupted());
  std::optional<Candidate> candidate;
  if (run.succeeded() && fs::is_regular_file(output)) candidate = read_candidate(output);
  return {&vector, judge_run(vector, run, options.limits, candidate, tolerance), run.seconds};
}

std::string report_bytes(const ConformanceReport& report, const std::string& path) {
  const std::string extension = fs::path(path).extension();
  if (extension == ".json") return write_json(conformance_json(report), 2) + "\n";
  return extension == ".md" ? conformance_markdown(report) : conformance_badge(report);
}

void require_sensible(const ConformArguments& options) {
  for (const std::string& path : options.reports) {
    const std::string extension = fs::path(path).extension();
    if (extension != ".json" && extension != ".md" && extension != ".svg") {
      throw Error(ErrorCode::InvalidArgument,
                  "-o " + path + ": expected a file with the extension .json, .md or .svg");
    }
  }
  for (const char* place : {"{input}", "{faces}", "{output}"}) {
    const bool found =
        std::any_of(options.program.begin(), options.program.end(),
                    [place](const auto& word) { return word.find(place) != std::string::npos; });
    if (!found) {
      throw Error(ErrorCode::InvalidArgument, std::string("the program's arguments lack ") + place);
    }
  }
}

ConformanceReport run_all(const std::vector<TestVector>& vectors, const ConformArguments& options) {
  const Tolerance tolerance =
      options.tolerance.empty() ? Tolerance{} : parse_tolerance(options.tolerance);
  Progress progress;
  ConformanceReport report;
  report.program = fmt::format("{}", fmt::join(options.program, " "));
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    if (!is_chosen(vectors[i], options)) continue;
    progress("running vectors", i, vectors.size());
    std::optional<std::string> bytes;
    if (asks_a_program(vectors[i])) bytes = input_bytes(vectors[i], options.input_format);
    if (!bytes) {
      ++report.not_run;
      continue;
    }
    report.entries.push_back(run_vector(vectors[i], *bytes, options, tolerance));
    if (report.entries.back().result.outcome == Outcome::NotStarted) {
      throw Error(ErrorCode::InvalidArgument,
                  "the program '" + options.program.front() + "' cannot be started");
    }
  }
  return report;
}

int run_conform(const ConformArguments& options) {
  require_sensible(options);
  const std::vector<TestVector> vectors = read_test_vectors(find_vectors(options.vectors));
  const ConformanceReport report = run_all(vectors, options);
  if (report.entries.empty()) {
    throw Error(ErrorCode::InvalidArgument, "no vector has this --level, --flag and input format");
  }
  AtomicOutput files;
  for (const std::string& path : options.reports) files.add(path, report_bytes(report, path));
  files.commit([&] {
    if (options.global.json) {
      print(conformance_json(report));
    } else {
      print(conformance_text(report));
    }
  });
  return report.conforms() ? 0 : 1;
}

}  // namespace

void add_conform_command(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<ConformArguments>();
  CLI::App& command = *program.add_subcommand(
      "conform", "run somebody's program over inputs whose answers are known, and judge it");
  command.footer(kConformFooter);
  command.add_option("PROGRAM", options->program, "the program and its arguments, after --")
      ->required()
      ->expected(-1);
  command.add_option("--vectors", options->vectors, "a folder of vectors (default: the shipped)");
  add_count(command, "--level", options->level, {1, 3}, "up to this: 1 everyday, 2 hard, 3 cruel");
  command.add_option("--flag", options->flag, "vectors with this flag only, see docs/flags");
  add_seconds(command, "--time-limit", options->limits.seconds, "for each vector");
  add_bytes(command, "--memory-limit", options->limits.memory,
            "address space for each vector, e.g. 2GB (default: none)");
  command.add_option("--tolerance", options->tolerance,
                     "let the output miss points by this much: 1e-6, or 1e-9d of the diameter");
  command.add_option("--input-format", options->input_format, "what the program reads")
      ->check(CLI::IsMember({"obj", "off", "ply", "stl", "xyz", "json", "ine", "txt"}))
      ->capture_default_str();
  command
      .add_option("--output-format", options->output_format,
                  "what the program writes: a mesh, or halfspaces")
      ->check(CLI::IsMember({"obj", "off", "ply", "stl", "json", "ine", "txt"}))
      ->capture_default_str();
  command
      .add_option("-o,--output", options->reports,
                  "the report, by its extension: .json, .md, or .svg for a badge; may be repeated")
      ->allow_extra_args(false);  // else it takes the -- away

  add_global_options(command, options->global);
  command.callback([options, &exit_code] {
    exit_code = run_guarded(options->global, [&] { return run_conform(*options); });
  });
}

}  // namespace convexact::cli
