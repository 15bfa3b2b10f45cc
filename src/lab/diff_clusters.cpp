// SPDX-License-Identifier: MIT
#include "lab/diff_clusters.hpp"

#include "cli/outputs.hpp"
#include "io/json_document.hpp"
#include "lab/diff/cluster_diff.hpp"
#include "scene/objects.hpp"
#include "wire/decompose_options.hpp"
#include "wire/decompose_report.hpp"

namespace convexact::cli {

namespace {

const std::vector<std::string_view> kNames = {"concavity", "max_parts", "measure", "connect"};

}  // namespace

std::string ClusterDiffOptions::foreign_to_removals() const {
  return given.all().empty() ? "" : option_of(*given.all().front().first);
}

void add_cluster_diff_options(Command& command, ClusterDiffOptions& options) {
  command.add_flag("--clusters", options.is_asked,
                   "compare the merges of a decomposition instead: see decompose");
  DecomposeRequest usual;
  for (const BoundField& shown : bound_fields(decompose_fields(), usual, kNames)) {
    FieldInfo info = *shown.info;
    info.meaning = "with --clusters: as in decompose (default: " + shown.present + ")";
    if (shown.present.empty()) info.meaning = "with --clusters: as in decompose";
    for (BoundField field : options.given.bound(decompose_fields(), {info.name})) {
      field.info = &info;
      add_field(command, field);
    }
  }
}

int run_cluster_diff(const GlobalOptions& global, const std::vector<std::string>& inputs,
                     const SceneOptions& scene, const std::vector<Engine>& engines,
                     const ClusterDiffOptions& options) {
  DecomposeRequest asked;
  options.given.apply_to(asked, decompose_fields());
  ClusterOptions wanted;
  wanted.limit = asked.limit;
  wanted.max_parts = asked.max_parts;
  wanted.measure = asked.measure;
  wanted.connect = asked.connect;
  CommandRun run(global);
  std::vector<SceneObject> objects = run.read(inputs, scene);
  Json list = Json::array();
  std::string text;
  bool explained = true;
  for (SceneObject& object : objects) {
    const std::string name = object.name;
    const auto mesh = mesh_of(std::move(object));
    if (const auto* reason = std::get_if<NotSolid>(&mesh)) return run.end_flat(name, *reason);
    const Surface surface =
        run.log().run("surface", [&] { return make_surface(std::get<Mesh>(mesh)); });
    const ClusterDiff diff = diff_clusters(surface, wanted, engines, run.watch());
    run.log().add(diff.stages);
    explained = explained && diff.holds();
    list.push_back({{"name", name}});
    list.back().update(cluster_diff_json(diff));
    text += name + "\n" + cluster_diff_text(diff);
  }
  return run.end({.json =
                      [&] {
                        return Json{{"explained", explained}, {"objects", list}};
                      },
                  .text = [&] { return text; },
                  .exit = explained ? 0 : 1});
}

}  // namespace convexact::cli
