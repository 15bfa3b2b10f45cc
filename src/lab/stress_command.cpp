// SPDX-License-Identifier: MIT
// convexact stress: sweeps of hard inputs, every engine on each, every answer judged.
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <memory>

#include "cli/progress.hpp"
#include "convexact/io.hpp"
#include "io/json_document.hpp"
#include "lab/commands.hpp"
#include "lab/stress/parts_stress.hpp"
#include "lab/stress/stress.hpp"
#include "lab/stress/stress_report.hpp"
#include "simplify/run_names.hpp"
#include "wire/simplify_options.hpp"
#include "wire/simplify_report.hpp"

namespace convexact::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kStressFooter =
    "Examples:\n"
    "  convexact stress                             every family, a few minutes\n"
    "  convexact stress needle slab --cases         each input on a line of its own\n"
    "  convexact stress needle --values 3e7,1e299 --size 200 --seed 5\n"
    "  convexact stress mixture --seeds 1000        random shapes, put together at random\n"
    "  convexact stress my_mesh.obj                 scaled and moved\n"
    "  convexact stress lattice --cost area         greedy by area\n"
    "  convexact stress lattice --search local      and a search from where it ends\n"
    "  convexact stress --parts                     solids cut into parts: walls, needles, shells\n"
    "  convexact stress --json > stress.json\n"
    "\n"
    "Columns: early: runs that end above the wanted number; diff: runs that removed a halfspace\n"
    "that was not among the cheapest; cost, regret, volume: largest relative errors; vouched,\n"
    "own: runs that the float engine vouches for; refuse: results that a format cannot hold;\n"
    "miss: input points outside the written solid; push: largest, of binary64; secs: longest,\n"
    "of processor time. Exit code 0: every promise was kept. 1: one was not.";

struct StressArguments {
  GlobalOptions global;
  std::vector<std::string> families;
  SweepOptions sweep;
  std::string engines = "exact,filtered,float";
  CostMeasure cost = CostMeasure::Volume;
  // Fewer kicks than in a single run, because the exact engine makes them, too.
  SearchRequest search{.kicks = 20};
  StressLimits limits{120, std::uint64_t(4) << 30};
  std::size_t jobs = 2;
  std::string log;
  bool list = false, cases = false, parts = false;
};

// The meshes of the default sweep.
constexpr const char* kMeshes[] = {"spot", "teapot", "bunny"};

StressFamily family_of_mesh(const std::string& path) {
  const Mesh mesh = read_mesh(path);
  const auto points = mesh.points.doubles();
  return mesh_family(fs::path(path).stem().string(), {points.begin(), points.end()});
}

StressFamily shipped_mesh(const std::string& name) {
  const auto path = find_shipped(fs::path("data") / (name + ".obj"));
  if (!path) throw Error(ErrorCode::Unreadable, "the shipped meshes were not found");
  return family_of_mesh(*path);
}

StressFamily family_of(const std::string& word) {
  if (mesh_format_of_path(word)) return family_of_mesh(word);
  const bool is_mesh = std::find(std::begin(kMeshes), std::end(kMeshes), word) != std::end(kMeshes);
  return is_mesh ? shipped_mesh(word) : stress_family(word);
}

std::vector<StressFamily> chosen_families(const StressArguments& options) {
  std::vector<StressFamily> families;
  for (const std::string& word : options.families) families.push_back(family_of(word));
  if (!families.empty()) return families;
  families.assign(stress_families().begin(), stress_families().end());
  for (const char* mesh : kMeshes) families.push_back(shipped_mesh(mesh));
  return families;
}

std::vector<PartsFamily> chosen_parts_families(const StressArguments& options) {
  const std::span<const PartsFamily> all = parts_families();
  if (options.families.empty()) return {all.begin(), all.end()};
  std::vector<PartsFamily> chosen;
  for (const std::string& word : options.families) {
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const PartsFamily& family) { return family.name == word; });
    if (found == all.end()) {
      std::string names;
      for (const PartsFamily& family : all) names += (names.empty() ? "" : ", ") + family.name;
      throw Error(ErrorCode::InvalidArgument,
                  "no family '" + word + "' of solids to take apart: expected one of " + names);
    }
    chosen.push_back(*found);
  }
  return chosen;
}

int run_parts(const StressArguments& options) {
  const std::vector<PartsFamily> families = chosen_parts_families(options);
  if (options.list) {
    Json list = Json::array();
    std::string text;
    for (const PartsFamily& family : families) {
      list.push_back({{"name", family.name},
                      {"description", family.description},
                      {"parameter", family.parameter},
                      {"values", family.values}});
      text += fmt::format("{:<20} {}\n{:<20}   {}: {:g}\n", family.name, family.description, "",
                          family.parameter, fmt::join(family.values, ", "));
    }
    options.global.json ? print(Json{{"families", list}}) : print(text);
    return 0;
  }
  Progress progress;
  const std::vector<PartsStressRun> runs = stress_parts(
      families, options.sweep.values, options.limits, progress.watch("cutting solids"));
  progress.clear();
  options.global.json ? print(parts_stress_json(runs)) : print(parts_stress_table(runs));
  const bool passes = std::all_of(runs.begin(), runs.end(),
                                  [](const PartsStressRun& run) { return run.faults.empty(); });
  return passes ? 0 : 1;
}

void print_list(const StressArguments& options) {
  Json list = Json::array();
  std::string text;
  for (const StressFamily& family : chosen_families(options)) {
    list.push_back({{"name", family.name},
                    {"description", family.description},
                    {"parameter", family.parameter},
                    {"values", family.values},
                    {"large_values", family.large_values}});
    text += fmt::format("{:<20} {}\n", family.name, family.description);
    if (family.parameter.empty()) continue;
    text += fmt::format("{:<20}   {}: {:g}", "", family.parameter, fmt::join(family.values, ", "));
    if (!family.large_values.empty()) {
      text += fmt::format("; with --large: {:g}", fmt::join(family.large_values, ", "));
    }
    text += "\n";
  }
  if (options.global.json) return print(Json{{"families", list}});
  print(text);
}

std::vector<StressInput> all_inputs(const StressArguments& options) {
  std::vector<StressInput> inputs;
  for (const StressFamily& family : chosen_families(options)) {
    SweepOptions sweep = options.sweep;
    sweep.seed = options.global.seed;
    std::vector<StressInput> more = inputs_of(family, sweep);
    std::move(more.begin(), more.end(), std::back_inserter(inputs));
  }
  return inputs;
}

// A line for each run, which is in the file when this returns.
void write_log(std::ofstream& log, const std::string& path, std::span<const StressRun> runs) {
  for (const StressRun& run : runs) log << write_json(stress_run_json(run)) << "\n";
  if (!log.flush()) throw Error(ErrorCode::Unwritable, path + ": cannot be written");
}

int run_stress(const StressArguments& options) {
  if (options.parts) return run_parts(options);
  if (options.list) {
    print_list(options);
    return 0;
  }
  Progress progress;
  StressRequest request;
  request.engines = parse_words("--engines", options.engines, kEngineNames);
  request.cost = options.cost;
  request.search = options.search;
  request.limits = options.limits;
  request.processes = options.jobs;
  std::ofstream log;
  if (!options.log.empty()) {
    log.open(options.log);
    request.judged = [&](std::span<const StressRun> runs) { write_log(log, options.log, runs); };
    request.judged({});
  }
  request.watch = progress.watch("judging inputs");
  const StressReport report = stress(all_inputs(options), request);
  progress.clear();
  if (options.global.json) {
    print(stress_json(report));
  } else {
    print(options.cases ? stress_case_table(report) : stress_table(report));
  }
  return report.passes() ? 0 : 1;
}

void add_sweep_options(Command& command, StressArguments& options) {
  command.add_option("FAMILY", options.families,
                     "families by name, or mesh files to be scaled and moved (default: all)");
  command.add_flag("--list", options.list, "name every family, what is varied and its values");
  add_text(command, "--values", "values instead of the family's own, e.g. 1e3,1e17",
           [&options](const auto& option, const auto& text) {
             for (const std::string& word : split(text, ',')) {
               options.sweep.values.push_back(parse_decimal(option, word));
             }
           });
  add_count(command, "--size", options.sweep.points, {1, 10000000},
            "points of shapes that take a number of points, if that is not what is varied");
  add_count(command, "--seeds", options.sweep.seeds, {1, 1000000000},
            "how many seeds for each value, from --seed on");
  add_faces(command, options.sweep.faces, "how many halfspaces to keep, at least 4");
  command.add_flag("--large", options.sweep.large, "also the values that take minutes");
  command.add_flag("--parts", options.parts,
                   "cut solids that are hard to take apart, and judge the parts; of the other "
                   "options --list, --values, --json and the limits apply");
  command.add_flag("--cases", options.cases, "a line for each input, not for each family");
}

void add_run_options(Command& command, StressArguments& options) {
  command.add_option("--engines", options.engines, "engines to run")->capture_default_str();
  add_choice(command, "--cost", options.cost, kCostMeasureNames,
             "what each removal is to add the least to; every answer is judged by it");
  add_choice(command, "--search", options.search.kind, kSearchKindNames,
             "what the exact and the filtered engine try after the removals");
  add_count(command, "--moves", options.search.kicks, {0, std::uint64_t(1) << 32},
            "with --search local: how many random exchanges each tries");
  add_seconds(command, "--time-limit", options.limits.seconds,
              "processor time of each engine on each input, and of the judge");
  add_bytes(command, "--memory-limit", options.limits.memory,
            "address space for each of these, e.g. 2GB; 0 for none (default: 4GB)");
  add_count(command, "--jobs", options.jobs, {1, 256}, "how many of these run at the same time");
  command.add_option("--log", options.log,
                     "a file that gets each run as a line of JSON as soon as it is judged: what is "
                     "there survives a stop");
}

}  // namespace

void add_stress_command(Command& program, int& exit_code) {
  auto options = std::make_shared<StressArguments>();
  Command& command = *program.add_subcommand(kStressCommand.name, kStressCommand.description);
  command.footer(kStressFooter);
  add_sweep_options(command, *options);
  add_run_options(command, *options);
  finish_command(command, options, exit_code, run_stress);
  command.get_option("--seed")->description("the first seed of shapes and random orders");
}

}  // namespace convexact::cli
