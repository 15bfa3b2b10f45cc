// SPDX-License-Identifier: MIT
// convexact diff: compares engines step by step.
#include <algorithm>
#include <memory>
#include <optional>

#include "cli/outputs.hpp"
#include "convexact/scene.hpp"
#include "io/json_document.hpp"
#include "lab/commands.hpp"
#include "lab/diff/diff.hpp"
#include "lab/diff_clusters.hpp"
#include "simplify/run_names.hpp"
#include "wire/keep_selectors.hpp"

namespace convexact::cli {
namespace {

constexpr const char* kDiffFooter =
    "Examples:\n"
    "  convexact diff bunny.obj --faces 18\n"
    "  convexact diff meshes/*.obj --engines filtered,float --json\n"
    "  convexact diff bunny.obj --faces 18 --cost mean-width\n"
    "  convexact diff spot.obj --clusters --engines filtered,float\n"
    "\n"
    "Where two runs differ, both costs are computed from scratch: the remaining halfspaces are\n"
    "intersected with and without each plane. A run of the float engine is followed to its end.\n"
    "Exit code 0: the engines agree, or the float engine chose between costs that are equal up to\n"
    "rounding. Exit code 1: anything else.";

struct DiffArguments {
  GlobalOptions global;
  std::vector<std::string> inputs;
  SceneOptions scene;
  std::optional<std::size_t> faces;
  std::vector<std::string> keep;
  ClusterDiffOptions clusters;
  std::string engines = "exact,filtered,float";
  CostMeasure cost = CostMeasure::Volume;
  long tie_bits = CompareLimits{}.bits;
};

using DiffedObject = FoundObject<DiffReport>;

std::string table_of(const std::vector<DiffedObject>& objects) {
  std::vector<NamedDiff> named;
  for (const DiffedObject& object : objects) named.push_back({object.source.name, &object.result});
  return diff_table(named) + "\n";
}

// Merges of clusters have no faces to keep, and no choice of the cost.
int run_diff_of_clusters(const DiffArguments& options) {
  const char* foreign = options.faces                              ? "--faces"
                        : !options.keep.empty()                    ? "--keep"
                        : options.cost != CostMeasure::Volume      ? "--cost"
                        : options.tie_bits != CompareLimits{}.bits ? "--tie-bits"
                                                                   : nullptr;
  if (foreign != nullptr) {
    throw Error(ErrorCode::InvalidArgument,
                std::string(foreign) + " does not apply to a comparison of clusters (--clusters)");
  }
  return run_cluster_diff(options.global, options.inputs, options.scene,
                          parse_words("--engines", options.engines, kEngineNames),
                          options.clusters);
}

int run_diff(const DiffArguments& options) {
  if (options.clusters.is_asked) return run_diff_of_clusters(options);
  if (const std::string foreign = options.clusters.foreign_to_removals(); !foreign.empty()) {
    throw Error(ErrorCode::InvalidArgument,
                foreign + " applies only to a comparison of clusters; give --clusters as well");
  }
  CommandRun run(options.global);
  DiffRequest request;
  request.faces = options.faces.value_or(4);
  request.engines = parse_words("--engines", options.engines, kEngineNames);
  request.cost = options.cost;
  request.compare.bits = options.tie_bits;
  request.seed = options.global.seed;
  request.watch = run.watch();
  std::vector<SceneObject> scene = run.read(options.inputs, options.scene);
  const auto keep = keep_selectors("--keep", options.keep, scene);
  // One after another: the report says how long each engine took.
  const auto found = on_each_object<DiffReport>(
      std::move(scene), run.log(), 1,
      [&](const Shape& shape, std::size_t k, const StageWatch&, std::size_t) {
        request.keep = keep[k];
        return diff_engines(shape, request);
      });
  if (const auto* flat = std::get_if<FlatObject>(&found)) {
    return run.end_flat(flat->name, flat->reason);
  }
  const auto& objects = std::get<std::vector<DiffedObject>>(found);
  const bool explained = std::all_of(objects.begin(), objects.end(),
                                     [](const DiffedObject& o) { return o.result.holds(); });
  return run.end({.json =
                      [&] {
                        return Json{{"faces", request.faces},
                                    {"explained", explained},
                                    {"objects", objects_json(objects, diff_json)}};
                      },
                  .text = [&] { return table_of(objects); },
                  .exit = explained ? 0 : 1});
}

}  // namespace

void add_diff_command(Command& program, int& exit_code) {
  auto options = std::make_shared<DiffArguments>();
  Command& command = *program.add_subcommand(kDiffCommand.name, kDiffCommand.description);
  command.footer(kDiffFooter);
  add_input_argument(command, options->inputs);
  add_faces(command, options->faces, "how many halfspaces to keep, at least 4");
  add_keep_option(command, options->keep);
  command
      .add_option("--engines", options->engines,
                  "engines to run; the first is the reference of the others")
      ->capture_default_str();
  add_choice(command, "--cost", options->cost, kCostMeasureNames,
             "what each removal is to add the least to; the runs are judged by it");
  add_tie_bits(
      command, options->tie_bits,
      "mean widths that neither this many bits nor a proof can order count as equal; the result "
      "says so");
  add_cluster_diff_options(command, options->clusters);
  add_scene_options(command, options->scene);
  finish_command(command, options, exit_code, run_diff);
  add_stages_option(command, options->global);
}

}  // namespace convexact::cli
