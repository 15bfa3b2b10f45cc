// SPDX-License-Identifier: MIT
// convexact decompose: a mesh as few convex parts.
#include <memory>

#include "cli/decomposed_files.hpp"
#include "cli/measures_options.hpp"
#include "cli/outputs.hpp"
#include "cli/part_files.hpp"
#include "cli/stdio_loop.hpp"
#include "convexact/decompose.hpp"
#include "io/json.hpp"
#include "scene/objects.hpp"
#include "simplify/run_names.hpp"
#include "wire/decompose_options.hpp"
#include "wire/decompose_report.hpp"
#include "wire/decompose_request.hpp"
#include "wire/stage_report.hpp"
#include "wire/written_parts.hpp"

namespace convexact::cli {
namespace {

constexpr const char* kDecomposeFooter =
    "Examples:\n"
    "  convexact decompose cow.obj -o parts.obj\n"
    "  convexact decompose cow.obj --concavity 5% --measure vertices -o parts/\n"
    "  convexact decompose cow.obj --max-parts 8 --faces 24 --names 'UCX_cow_%02d' -o cow_ucx.obj\n"
    "  convexact decompose cow.obj --method acd --concavity 10% --picture splits.html\n"
    "  convexact decompose cow.obj --engine exact --trace merges.json -o parts.json\n"
    "  convexact decompose cow.obj --proof cow.proof && convexact-check cow.proof cow.obj\n"
    "  convexact decompose cow.obj --total-faces 400 -o parts/ --tree tree.json --tree-faces 24\n"
    "  convexact decompose cow.obj --precision 32 -o parts/ -o cow.mjcf.xml -o cow.urdf\n"
    "  convexact verify cow.obj parts.obj --union\n"
    "  convexact decompose --stdio <requests.jsonl\n"
    "\n"
    "Every part is the convex hull of a cluster of triangles. The parts hold every triangle, "
    "tested\n"
    "on the written numbers. That covers the surface and need not cover the solid: the summary "
    "says\n"
    "what of the solid is in no part; --measures all also says what of the parts is outside.\n"
    "The exit code is 0 even if --max-parts or --flat merge leads beyond the concavity allowed, or "
    "a\n"
    "part of acd cannot be split; the summary and \"eps_holds\" say so. 4: INPUT has no point, "
    "or all its faces lie in one plane.";

struct DecomposeArguments {
  GlobalOptions global;
  std::string input;
  SceneOptions scene;
  DecomposeFiles files;
  DecomposeRequest request;
  std::string concavity = "3%", coplanar = "0.99";  // of the request, as text
  MeasuresOptions measures;
  StdioOptions stdio;
};

DecomposeRequest decompose_request(const DecomposeArguments& options) {
  DecomposeRequest request = options.request;
  if (request.faces && request.total_faces) {
    throw Error(ErrorCode::InvalidArgument,
                "--total-faces is for all parts together and --faces for each: name one");
  }
  request.measures =
      options.measures.to_print(options.global.json || options.files.have_document());
  request.exact_volumes = options.measures.exact_volumes;
  request.limit = parse_concavity("--concavity", options.concavity);
  request.coplanar = parse_cosine("--coplanar", options.coplanar);
  request.for_trace = !options.files.trace.empty();
  request.for_tree = !options.files.tree.empty();
  request.every_merge = options.global.json || options.files.show_merges();
  request.seed = options.global.seed;
  return request;
}

std::string answer_of(const std::vector<DecomposedObject>& objects, const DecomposeRequest& request,
                      const FilesOfParts& out, const std::vector<Stage>& stages,
                      const DecomposeArguments& options) {
  if (options.global.json) {
    Json document = decomposition_json(objects, request, DecompositionDetail::Numbers);
    if (objects.size() == 1) document["input"] = objects[0].name;
    document["files"] = options.files.all_paths();
    document["removed"] = out.removed;
    if (!out.notes.empty()) document["notes"] = out.notes;
    document["stages"] = stages_json(stages);
    return write_json(document, 2) + "\n";
  }
  std::string text;
  for (const DecomposedObject& object : objects) {
    text += object.name + "\n" + summary(object.result, request, object.part_names);
  }
  text += out.tree_summary;
  for (const std::string& path : options.files.all_paths()) text += "  written     " + path + "\n";
  for (const std::string& path : out.removed) {
    text += "  removed     " + path + ", of an earlier run\n";
  }
  for (const std::string& note : out.notes) text += "  note        " + note + "\n";
  if (options.files.all_paths().empty()) {
    text += "  written     nothing; -o parts.obj keeps the parts\n";
  }
  return text + stage_text(stages, options.global.stages);
}

// decompose(), with the name of the object in errors about it.
DecomposeOutcome decompose_object(const std::string& name, const Mesh& mesh,
                                  const DecomposeRequest& request) {
  try {
    return decompose(mesh, request);
  } catch (const Error& error) {
    if (error.code() == ErrorCode::NoInterior) throw error.in_file(name);
    if (error.code() != ErrorCode::Unrepresentable) throw;
    const bool is_narrow = request.precision == Precision::Binary32;
    throw Error(error.code(),
                error.what() + std::string(is_narrow ? "; --precision 64 holds more" : ""))
        .in_file(name);
  }
}

int run_decompose(const DecomposeArguments& options) {
  options.stdio.require_sensible();
  if (options.stdio.is_asked) return answer_lines(options.stdio, answer_decompose_request);
  if (options.input.empty()) {
    throw Error(ErrorCode::InvalidArgument, "name an INPUT, or --stdio");
  }
  DecomposeRequest request = decompose_request(options);
  options.files.require_sensible(options.input, request);
  Progress progress;
  StageLog log(progress.watch());
  std::vector<SceneObject> scene =
      log.run("read", StageKind::Io, [&] { return read_scene({options.input}, options.scene); });
  options.files.require_room_for(scene.size());
  request.watch = progress.watch();
  std::vector<DecomposedObject> objects;
  std::vector<std::string> object_names;
  for (SceneObject& object : scene) {
    const std::string name = object.name;
    object_names.push_back(object.part);
    auto made = mesh_of(std::move(object));
    const auto* reason = std::get_if<NotSolid>(&made);
    std::optional<DecomposeOutcome> outcome;
    if (reason == nullptr) {
      const Mesh mesh = with_hulls_of_clouds(std::get<Mesh>(std::move(made)));
      outcome = decompose_object(name, mesh, request);
      reason = std::get_if<NotSolid>(&*outcome);
    }
    if (reason != nullptr) {
      progress.clear();
      return report_not_solid(options.global, name, *reason);
    }
    objects.push_back({name, std::get<Decomposition>(std::move(*outcome)), {}});
    log.add(objects.back().result.stages);
  }
  name_parts(objects, object_names, options.files.names);
  const FilesOfParts out = log.run("write", StageKind::Io, [&] {
    return decomposed_files(objects, request, options.files, options.input);
  });
  progress.clear();
  write_parts_together(out.files, out.folders, out.removed,
                       answer_of(objects, request, out, log.stages(), options));
  return 0;
}

// Where the clusters come from, and how many there are.
void add_cluster_options(Command& command, DecomposeArguments& options) {
  add_choice(
      command, "--method", options.request.method, kDecomposeMethodNames,
      "hacd merges neighbouring triangles, then clusters, by concavity and shape; acd splits "
      "the most concave part at its deepest notch, again and again");
  command
      .add_option("--concavity", options.concavity,
                  "how deep a cluster may lie in its hull: a share of the diameter, 3% or 0.03d, "
                  "or a length, 0.05")
      ->capture_default_str();
  add_count(command, "--max-parts", options.request.max_parts, {1},
            "at least 1: hacd keeps merging beyond the concavity allowed until this many parts are "
            "left; acd stops splitting at this many");
  add_choice(command, "--measure", options.request.measure, kConcavityMeasureNames,
             "hacd only: concavity at every point of the triangles, or at their corners only, as "
             "published, which sees no notch whose corners all lie on the hull");
  add_choice(command, "--bridge", options.request.bridge, kBridgeChoiceNames,
             "acd only: concavity is the distance to a bridge, facets of the hull over the nearest "
             "path; to the farther of its bridges, to that of the whole region, or to the nearer");
  command
      .add_option("--coplanar", options.coplanar,
                  "acd only: facets are one bridge where the cosine of the angle between their "
                  "normals is larger; above 0, at most 1")
      ->capture_default_str();
}

}  // namespace

void add_decompose_command(Command& program, int& exit_code) {
  auto options = std::make_shared<DecomposeArguments>();
  Command& command = *program.add_subcommand(
      "decompose", "the surface of a mesh as few convex parts, each the hull of some triangles");
  command.footer(kDecomposeFooter);
  command.add_option("INPUT", options->input,
                     "a mesh (OBJ, OFF, PLY, STL), or halfspaces (JSON, .ine, rows); - is standard "
                     "input");
  add_cluster_options(command, *options);
  add_faces(command, options->request.faces,
            "how many halfspaces to keep of each part, at least 4");
  add_count(command, "--total-faces", options->request.total_faces, {4, std::uint64_t(1) << 32},
            "how many halfspaces to keep in all parts together, at least 4 for each");
  add_choice(command, "--flat", options->request.flat, kFlatPartsNames,
             "how to treat clusters in a plane: thicken them, keep polygons, or merge them with a "
             "neighbour; auto thickens, and refuses an input that is entirely flat");
  command.add_flag("--keep-inner", options->request.keep_inner,
                   "keep parts that lie in another part");
  add_choice(command, "--connect", options->request.connect, kConnectNames,
             "neighbours have a common edge; or also edges that overlap; or also a common point of "
             "two components");
  add_choice(command, "--orient", options->request.orient, kOrientationNames,
             "turn faces so that they bound the solid correctly, or keep them as they are");
  add_loose_option(command, options->request.loose);
  add_choice(command, "--engine", options->request.engine, kEngineNames,
             "hacd only: rationals everywhere; the same parts, faster; or doubles that choose, the "
             "parts still proven");
  add_decompose_files(command, options->files);
  add_choice<Precision>(command, "--precision", options->request.precision,
                        {{"64", Precision::Binary64}, {"32", Precision::Binary32}},
                        "the numbers of the parts: binary64, or rounded outward to binary32");
  add_measures_options(command, options->measures, "");
  add_scene_options(command, options->scene);
  add_stdio_options(command, options->stdio, "one decomposition");
  finish_command(command, options, exit_code, run_decompose);
  add_stages_option(command, options->global);
  command.show_first({"--method", "--concavity", "--max-parts", "--faces", "--total-faces",
                      "--output", "--names", "--picture", "--proof", "--precision", "--measures",
                      "--parts", "--json"});
}

}  // namespace convexact::cli
