// SPDX-License-Identifier: MIT
#include "lab/diff_clusters.hpp"

#include "cli/outputs.hpp"
#include "cli/progress.hpp"
#include "io/json_document.hpp"
#include "lab/diff/cluster_diff.hpp"
#include "scene/objects.hpp"
#include "solid/stage_log.hpp"
#include "wire/decompose_options.hpp"
#include "wire/decompose_report.hpp"
#include "wire/stage_report.hpp"

namespace convexact::cli {

std::string ClusterDiffOptions::foreign_to_removals() const {
  return concavity   ? "--concavity"
         : max_parts ? "--max-parts"
         : measure   ? "--measure"
         : connect   ? "--connect"
                     : "";
}

void add_cluster_diff_options(Command& command, ClusterDiffOptions& options) {
  command.add_flag("--clusters", options.is_asked,
                   "compare the merges of a decomposition instead: see decompose");
  command.add_option("--concavity", options.concavity,
                     "with --clusters: as in decompose (default: 3%)");
  add_count(command, "--max-parts", options.max_parts, {1}, "with --clusters: as in decompose");
  add_choice(command, "--measure", options.measure, kConcavityMeasureNames,
             "with --clusters: as in decompose (default: surface)");
  add_choice(command, "--connect", options.connect, kConnectNames,
             "with --clusters: as in decompose (default: edge)");
}

int run_cluster_diff(const GlobalOptions& global, const std::vector<std::string>& inputs,
                     const SceneOptions& scene, const std::vector<Engine>& engines,
                     const ClusterDiffOptions& options) {
  ClusterOptions wanted;
  if (options.concavity) wanted.limit = parse_concavity("--concavity", *options.concavity);
  wanted.max_parts = options.max_parts;
  wanted.measure = options.measure.value_or(ConcavityMeasure::Surface);
  wanted.connect = options.connect.value_or(Connect::Edge);
  Progress progress;
  StageLog log(progress.watch());
  std::vector<SceneObject> objects =
      log.run("read", StageKind::Io, [&] { return read_scene(inputs, scene); });
  Json list = Json::array();
  std::string text;
  bool explained = true;
  for (SceneObject& object : objects) {
    const std::string name = object.name;
    const auto mesh = mesh_of(std::move(object));
    if (const auto* reason = std::get_if<NotSolid>(&mesh)) {
      progress.clear();
      return report_not_solid(global, name, *reason);
    }
    const Surface surface = log.run("surface", [&] { return make_surface(std::get<Mesh>(mesh)); });
    const ClusterDiff diff = diff_clusters(surface, wanted, engines, progress.watch());
    log.add(diff.stages);
    explained = explained && diff.holds();
    list.push_back({{"name", name}});
    list.back().update(cluster_diff_json(diff));
    text += name + "\n" + cluster_diff_text(diff);
  }
  progress.clear();
  if (global.json) {
    print(Json{{"explained", explained}, {"objects", list}, {"stages", stages_json(log.stages())}});
  } else {
    print(text + stage_text(log.stages(), global.stages));
  }
  return explained ? 0 : 1;
}

}  // namespace convexact::cli
