// SPDX-License-Identifier: MIT
// convexact hull: the exact hull, or the exact solid that halfspaces bound, and its measures.
#include <fmt/format.h>

#include <memory>

#include "cli/command.hpp"
#include "cli/outputs.hpp"
#include "cli/progress.hpp"
#include "cli/quantity_option.hpp"
#include "convexact/scene.hpp"
#include "io/json.hpp"
#include "number/text.hpp"
#include "scene/result_json.hpp"
#include "scene/stage_log.hpp"
#include "scene/summary.hpp"

namespace convexact::cli {
namespace {

constexpr const char* kHullFooter =
    "Examples:\n"
    "  convexact hull bunny.obj\n"
    "  convexact hull bunny.obj --digits 50 -o hull.obj -o planes.ine\n"
    "  convexact hull planes.json --json\n"
    "  convexact hull scan.ply --measures volume     without the slow area and mean width\n"
    "\n"
    "Every digit printed is certain: off by less than one unit of the last one.\n"
    "Planes are written as exact integers unless --precision is given.";

struct HullArguments {
  GlobalOptions global;
  std::vector<std::string> inputs;
  SceneOptions scene;
  OutputOptions output;
  HullRequest request;
};

struct MeasuredObject {
  SceneObject source;
  HullResult result;
};

nlohmann::ordered_json document_of(const std::vector<MeasuredObject>& objects, int digits) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const MeasuredObject& object : objects) {
    nlohmann::ordered_json entry = {{"name", object.source.name}};
    entry.update(hull_json(object.result, digits));
    entry["stages"] = stages_json(object.result.stages);
    list.push_back(entry);
  }
  return objects.size() == 1 ? list[0] : nlohmann::ordered_json{{"objects", list}};
}

std::string summary_of(const std::vector<MeasuredObject>& objects, int digits,
                       const OutputOptions& output, const StageLog& log, bool lists_stages) {
  std::string text;
  for (const MeasuredObject& object : objects) {
    text += object.source.name + "\n" + summary(object.result, digits);
  }
  for (const std::string& path : output.all_paths()) {
    text += fmt::format("  written     {}\n", path);
  }
  return text + stage_text(log.stages(), lists_stages);
}

// "volume,area" and the like, or none.
void take_measures(const std::string& option, const std::string& text, HullRequest& request) {
  request.volume = request.area = request.mean_width = false;
  if (text == "none") return;
  for (const std::string& word : CLI::detail::split(text, ',')) {
    bool* const asked = word == "volume"       ? &request.volume
                        : word == "area"       ? &request.area
                        : word == "mean-width" ? &request.mean_width
                                               : nullptr;
    if (asked == nullptr) {
      throw Error(ErrorCode::InvalidArgument,
                  option + ": expected names out of volume,area,mean-width, or none, found " +
                      in_quotes(word));
    }
    *asked = true;
  }
}

int run_hull(const HullArguments& options) {
  options.output.require_sensible();
  require_other_files(options.output.all_paths(), options.inputs);
  Progress progress;
  StageLog log(progress.watch());
  std::vector<SceneObject> scene =
      log.run("read", StageKind::Io, [&] { return read_scene(options.inputs, options.scene); });
  options.output.require_room_for(scene.size());
  HullRequest request = options.request;
  if (request.exact_volume && !request.volume) {
    throw Error(ErrorCode::InvalidArgument, "--exact-values: --measures leaves the volume out");
  }
  request.seed = options.global.seed;
  request.watch = progress.watch();
  request.store = options.output.store_request();
  std::vector<MeasuredObject> objects;
  for (SceneObject& source : scene) {
    HullReport outcome = measure_hull(source.shape, request);
    if (const auto* reason = std::get_if<NotSolid>(&outcome)) {
      progress.clear();
      return report_not_solid(options.global, source.name, of_typed_rows(*reason, source.rows));
    }
    auto& result = std::get<HullResult>(outcome);
    log.add(result.stages);
    to_typed_rows(result.redundant, source.rows);
    objects.push_back({std::move(source), std::move(result)});
  }
  std::vector<OutputObject> outputs;
  for (const MeasuredObject& object : objects) {
    outputs.push_back({object.source, object.result.solid});
  }
  const OutputFiles files =
      log.run("write", StageKind::Io, [&] { return output_files(outputs, options.output); });
  progress.clear();
  const std::string text =
      options.global.json
          ? write_json(document_of(objects, request.digits), 2) + "\n"
          : summary_of(objects, request.digits, options.output, log, options.global.stages);
  write_together(files, text);
  return 0;
}

}  // namespace

void add_hull_command(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<HullArguments>();
  CLI::App& command =
      *program.add_subcommand("hull", "the exact hull: counts, volume, area, mean width");
  command.footer(kHullFooter);
  add_input_argument(command, options->inputs);
  add_output_options(command, options->output);
  add_scene_options(command, options->scene);
  add_count(command, "--digits", options->request.digits, {1, 10000},
            "certain digits of each measure");
  add_text(command, "--measures", "compute only these, out of volume,area,mean-width, or none",
           [&request = options->request](const auto& option, const auto& text) {
             take_measures(option, text, request);
           })
      ->default_str("volume,area,mean-width");
  command.add_flag("--exact-values", options->request.exact_volume,
                   "with --json: the volume as a fraction too");
  add_global_options(command, options->global);
  add_stages_option(command, options->global);
  command.callback([options, &exit_code] {
    exit_code = run_guarded(options->global, [&] { return run_hull(*options); });
  });
}

}  // namespace convexact::cli
