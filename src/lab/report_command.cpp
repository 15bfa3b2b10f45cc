// SPDX-License-Identifier: MIT
// convexact report: error against run time, as data and as a page of plots.
#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <memory>
#include <optional>

#include "cli/outputs.hpp"
#include "cli/progress.hpp"
#include "convexact/scene.hpp"
#include "io/json.hpp"
#include "lab/commands.hpp"
#include "lab/report/report.hpp"
#include "simplify/run_names.hpp"
#include "wire/decompose_options.hpp"

namespace convexact::cli {

// From build_info.cpp, a separate library.
extern const char* const kCommit;    // "unknown" if it was built outside of a repository
extern const char* const kFlags;     // of the compiler, as far as they change what is measured
extern const char* const kCompiler;  // with its version

namespace {

constexpr const char* kReportFooter =
    "Examples:\n"
    "  convexact report bunny.obj fandisk.obj -o out\n"
    "  convexact report bunny.obj --sections precision,tightness --repetitions 9\n"
    "  convexact report bunny.obj --sections tightness --cost area\n"
    "  convexact report --sections stability --family needle --family slab\n"
    "  convexact report spot.obj --sections parts\n"
    "\n"
    "Writes report.html, which opens without a network, and the same numbers as report.json\n"
    "(docs/schema/report.schema.json) and report.csv. docs/report.md says how to read them.";

struct ReportArguments {
  GlobalOptions global;
  std::vector<std::string> inputs;
  SceneOptions scene;
  std::string folder = "report";
  std::string sections = "precision,tightness,stages,scaling,stability";
  ReportRequest request;
};

ReportSections parse_sections(const std::string& text) {
  using Section = bool ReportSections::*;
  constexpr auto kSections = name_table<Section>({{&ReportSections::precision, "precision"},
                                                  {&ReportSections::tightness, "tightness"},
                                                  {&ReportSections::stages, "stages"},
                                                  {&ReportSections::scaling, "scaling"},
                                                  {&ReportSections::stability, "stability"},
                                                  {&ReportSections::parts, "parts"}});
  ReportSections sections;
  for (const auto& [section, name] : kSections) sections.*section = false;
  for (const Section section : parse_words("--sections", text, kSections)) {
    sections.*section = true;
  }
  return sections;
}

// The command of a figure names no folder of the machine on which it ran.
std::string without_folder(const std::string& name) {
  const std::size_t slash = name.find_last_of('/');
  return slash == std::string::npos ? name : name.substr(slash + 1);
}

OutputFiles files_of(const std::string& folder, const Json& document) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure) throw Error(ErrorCode::Unwritable, folder + ": " + failure.message());
  return {{folder + "/report.json", write_json(document, 1) + "\n"},
          {folder + "/report.csv", report_csv(document)},
          {folder + "/report.html", report_page(write_json(document))}};
}

std::string seconds_text(const std::optional<Spread>& seconds) {
  return seconds ? fmt::format("{:.3g} s", seconds->median) : "over budget";
}

std::string percent_or_none(const std::optional<double>& share) {
  return share ? fmt::format("{:.3g}%", 100 * *share) : std::string("-");
}

std::string parts_table(const InputReport& input) {
  if (input.parts.empty()) return "";
  std::string text = fmt::format("  {:<10}  {:>6}  {:>12}  {:>6}  {:>9}  {:>9}  {:>9}\n", "method",
                                 "limit", "time", "parts", "distance", "excess", "uncovered");
  for (const PartsPoint& point : input.parts) {
    text += fmt::format("  {:<10}  {:>5}%  {:>12}", name_in(kDecomposeMethodNames, point.method),
                        100 * point.limit, seconds_text(point.seconds));
    if (point.seconds) {
      text +=
          fmt::format("  {:>6}  {:>9}  {:>9}  {:>9}", point.parts, percent_or_none(point.distance),
                      percent_or_none(point.excess), percent_or_none(point.uncovered));
    }
    text += "\n";
  }
  return text;
}

std::string summary_of(const ReportData& report, const std::string& folder) {
  std::string text;
  for (const InputReport& input : report.inputs) {
    text += fmt::format("{}: {} halfspaces\n", input.name, input.halfspaces) + parts_table(input);
    if (!input.precision) continue;
    text += fmt::format("  {:<10}  {:>12}  {:>12}  {:>14}  {:>11}\n", "way", "time", "cost error",
                        "volume error", "wrong step");
    for (const WayResult& way : input.precision->ways) {
      text += fmt::format(
          "  {:<10}  {:>12}  {:>12.3g}  {:>14.3g}  {:>11}\n", way.way, seconds_text(way.seconds),
          way.cost_worst.value, way.volume ? way.volume->value : 0.0,
          way.first_wrong ? std::to_string(way.first_wrong->step + 1) : std::string("none"));
    }
  }
  return text + fmt::format("written: {0}/report.html, {0}/report.json, {0}/report.csv\n", folder);
}

int run_report(const ReportArguments& options) {
  ReportRequest request = options.request;
  request.sections = parse_sections(options.sections);
  require_other_files({options.folder + "/report.html", options.folder + "/report.json",
                       options.folder + "/report.csv"},
                      options.inputs);
  require_folder(options.folder);
  request.effort.seed = options.global.seed;
  request.effort.stop = &interrupted();
  Progress progress;
  // Into a pipe or a file a line for each step, since the whole takes minutes.
  const bool is_terminal = isatty(STDERR_FILENO) != 0;
  std::string last;
  request.effort.progress = [&](const std::string& what) {
    progress(what, 0, 0);
    if (!is_terminal && what != last) fmt::print(stderr, "{}\n", what);
    last = what;
  };
  std::vector<SceneObject> scene = read_scene(options.inputs, options.scene);
  ReportData report;
  for (const SceneObject& object : scene) {
    auto measured =
        measure_input(without_folder(object.name), object.shape, request, object.polygons);
    if (const auto* reason = std::get_if<NotSolid>(&measured)) {
      return report_not_solid(options.global, object.name, of_typed_rows(*reason, object.rows));
    }
    report.inputs.push_back(std::get<InputReport>(std::move(measured)));
  }
  measure_families(report, request);
  progress.clear();
  const ReportOrigin origin{.version = CONVEXACT_VERSION,
                            .commit = kCommit,
                            .compiler = kCompiler,
                            .flags = kFlags,
                            .machine = this_machine()};
  const Json document = report_json(report, request, origin);
  write_together(files_of(options.folder, document), options.global.json
                                                         ? write_json(document, 2) + "\n"
                                                         : summary_of(report, options.folder));
  return 0;
}

}  // namespace

void add_report_command(Command& program, int& exit_code) {
  auto options = std::make_shared<ReportArguments>();
  Command& command = *program.add_subcommand(kReportCommand.name, kReportCommand.description);
  command.footer(kReportFooter);
  command.add_option("INPUT", options->inputs,
                     "meshes or halfspaces; without any, only the sections that need no input");
  command.add_option("-o,--output", options->folder, "the folder for the files; made if missing")
      ->capture_default_str();
  command
      .add_option("--sections", options->sections,
                  "what to measure; also parts: of decompositions by cut, hacd and acd")
      ->capture_default_str();
  ReportRequest& request = options->request;
  add_faces(command, request.faces, "halfspaces at which runs end, at least 4");
  add_choice(command, "--cost", request.cost, kCostMeasureNames,
             "the measure that the section tightness keeps small and shows; the other "
             "sections are by volume");
  add_count(command, "--repetitions", request.effort.repetitions, {1, 1000},
            "repetitions of every timed run");
  add_seconds(command, "--budget", request.effort.budget,
              "time for the repetitions of one run; a first run that takes longer is left out, and "
              "the page says so");
  command
      .add_option(
          "--family", request.families,
          "family of shapes for the section stability; default: every one that can be swept")
      ->one_of(breakdown_families());
  add_scene_options(command, options->scene);
  finish_command(command, options, exit_code, run_report);
}

}  // namespace convexact::cli
