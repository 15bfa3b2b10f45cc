// SPDX-License-Identifier: MIT
// convexact hull: the exact hull, or the exact solid that halfspaces bound, and its measures.
#include <memory>

#include "cli/outputs.hpp"
#include "cli/stdio_loop.hpp"
#include "convexact/scene.hpp"
#include "io/json.hpp"
#include "wire/simplify_options.hpp"
#include "wire/simplify_report.hpp"
#include "wire/stage_report.hpp"

namespace convexact::cli {
namespace {

constexpr const char* kHullFooter =
    "Examples:\n"
    "  convexact hull bunny.obj\n"
    "  convexact hull bunny.obj --digits 50 -o hull.obj -o planes.ine\n"
    "  convexact hull planes.json --json\n"
    "  convexact hull scan.ply --measures volume     without the slow area and mean width\n"
    "  convexact hull box.obj --measures inertia     and center of mass, for density 1\n"
    "\n"
    "Every digit printed is certain: off by less than one unit of the last one.\n"
    "Planes are written as exact integers unless --precision is given.";

struct HullArguments {
  GlobalOptions global;
  std::vector<std::string> inputs;
  SceneOptions scene;
  OutputOptions output;
  HullRequest request;
  std::optional<std::size_t> jobs;
  StdioOptions stdio;

  bool needs_polygons() const { return !output.picture.empty(); }
};

using MeasuredHulls = std::vector<FoundObject<HullResult>>;

Json document_of(const MeasuredHulls& objects, int digits) {
  const Json list = objects_json(
      objects, [digits](const HullResult& result) { return hull_json(result, digits); });
  return objects.size() == 1 ? list[0] : Json{{"objects", list}};
}

std::string summary_of(const MeasuredHulls& objects, const HullArguments& options) {
  std::string text;
  for (const auto& [source, result] : objects)
    text += source.name + "\n" + summary(result, options.request.digits, options.global.verbose);
  return text + written_lines(options.output);
}

// "volume,area" and the like, or none.
void take_measures(const std::string& option, const std::string& text, HullRequest& request) {
  request.volume = request.area = request.mean_width = request.inertia = false;
  if (text == "none") return;
  for (const auto measure : parse_words(option, text, kHullMeasureNames, ", or none"))
    request.*measure = true;
}

int run_hull(const HullArguments& options) {
  options.stdio.require_sensible();
  if (options.stdio.is_asked) return answer_lines(options.stdio, "hull");
  if (options.inputs.empty()) reject_argument("name an INPUT, or --stdio");
  HullRequest request = options.request;
  if (request.exact_volume && !request.volume) {
    throw Error(ErrorCode::InvalidArgument, "--exact-values: --measures leaves the volume out");
  }
  request.seed = options.global.seed;
  request.store = options.output.store_request();
  return run_on_inputs<HullResult>(
      options, options.jobs,
      [&](const auto& scene) { return std::vector<HullRequest>(scene.size(), request); },
      measure_hull,
      [&](const MeasuredHulls& objects) {
        return CommandAnswer{[&] { return document_of(objects, request.digits); },
                             [&] { return summary_of(objects, options); }};
      });
}

}  // namespace

void add_hull_command(Command& program, int& exit_code) {
  auto options = std::make_shared<HullArguments>();
  Command& command =
      *program.add_subcommand("hull", "the exact hull: counts, volume, area, mean width");
  command.footer(kHullFooter);
  add_input_argument(command, options->inputs);
  command.get_option("INPUT")->required(false);
  add_output_options(command, options->output);
  add_scene_options(command, options->scene);
  add_count(command, "--digits", options->request.digits, {1, 10000},
            "certain digits of each measure");
  add_text(command, "--measures",
           "compute only these, out of volume,area,mean-width,inertia, or none",
           [&request = options->request](const auto& option, const auto& text) {
             take_measures(option, text, request);
           })
      ->default_str("volume,area,mean-width");
  command.add_flag("--exact-values", options->request.exact_volume,
                   "with --json: the volume as a fraction too");
  add_jobs_option(command, options->jobs);
  add_stdio_options(command, options->stdio, "one hull");
  finish_command(command, options, exit_code, run_hull);
  add_verbose_option(command, options->global);
}

}  // namespace convexact::cli
