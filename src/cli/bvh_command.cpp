// SPDX-License-Identifier: MIT
// convexact bvh: a tree of hulls over the parts of a mesh, each of which holds its children.
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "cli/outputs.hpp"
#include "cli/part_files.hpp"
#include "convexact/hull_tree.hpp"
#include "convexact/io.hpp"
#include "io/json.hpp"
#include "pages/parts_picture.hpp"
#include "scene/objects.hpp"
#include "wire/decompose_options.hpp"
#include "wire/decompose_report.hpp"
#include "wire/stage_report.hpp"
#include "wire/tree_report.hpp"

namespace convexact::cli {
namespace {

constexpr const char* kBvhFooter =
    "Examples:\n"
    "  convexact bvh cow.obj -o cow_tree.json\n"
    "  convexact bvh cow.obj --method acd --concavity 5% --leaf-faces 24 --faces 16 -o tree.json\n"
    "  convexact bvh cow.obj --join volume --faces 16 -o tree.json\n"
    "  convexact bvh cow.obj --from vhacd_parts.obj -o tree.json\n"
    "  convexact query rays tree.json rays.txt\n"
    "  convexact verify cow.obj tree.json --union\n"
    "\n"
    "Without --from the parts are those of convexact decompose, joined as the planes of cut\n"
    "or the splits of acd parted them, or by the next merges of hacd; groups that this leaves\n"
    "apart, and parts from a file, are joined where the common hull has the least volume.\n"
    "Each hull is made from its children's stored numbers, and is proven to hold them: a ray\n"
    "or a solid that misses it misses all below.\n"
    "convexact decompose --tree writes parts, proof, picture and tree in one run.";

// How parts are joined.
enum class JoinBy { Method, Volume };
constexpr auto kJoinByNames =
    name_table<JoinBy>({{JoinBy::Method, "method"}, {JoinBy::Volume, "volume"}});

struct BvhArguments {
  GlobalOptions global;
  std::string input, from, output, picture;
  SceneOptions scene;
  DecomposeRequest decomposition = default_decompose_request();
  JoinBy join = JoinBy::Method;
  TreeRequest tree;
};

// The parts that a tree is built from.
struct TreeParts {
  std::vector<NamedPart> parts;
  std::vector<Join> joins;
  Surface surface;
  TreeOrigin origin;
};

std::variant<TreeParts, NotSolid> decomposed_parts(const Mesh& mesh, const std::string& name,
                                                   const BvhArguments& options, StageLog& log) {
  DecomposeRequest request = options.decomposition;
  request.faces = options.tree.leaf_faces;
  request.precision = options.tree.precision;
  request.measures = PartMeasures::None;
  request.for_tree = options.join == JoinBy::Method;
  request.seed = options.global.seed;
  request.watch = log.watch();
  request = with_method(mesh, std::move(request));
  DecomposeOutcome outcome = decompose(mesh, request);
  if (auto* reason = std::get_if<NotSolid>(&outcome)) return std::move(*reason);
  auto& decomposition = std::get<Decomposition>(outcome);
  log.add(decomposition.stages);
  TreeParts made{.parts = {},
                 .joins = {},
                 .surface = {},
                 .origin = {name, request.method, decomposition.surface.points.is_binary(), 0}};
  if (options.join == JoinBy::Method) made.joins = joins_of(decomposition);
  const PartNames names("part_%03d");
  for (Part& part : decomposition.parts) {
    made.parts.push_back({names(made.parts.size()), std::move(part.mesh)});
  }
  return made;
}

std::variant<TreeParts, NotSolid> read_parts_of_tree(const Mesh& mesh, const std::string& name,
                                                     const BvhArguments& options, StageLog& log) {
  TreeParts made;
  log.run("read parts", StageKind::Io, [&] {
    CandidateParts read = read_parts(options.from, options.scene.decimal);
    if (const auto* error = std::get_if<Error>(&read)) throw *error;
    made.parts = *parts_of(read);
    if (made.parts.empty()) {
      throw Error(ErrorCode::NoInterior, "there is no part").in_file(options.from);
    }
  });
  made.surface = log.run("surface", [&] { return make_surface(mesh, {}, log.watch("surface")); });
  made.origin = {name, options.from, true, {}};
  for (const NamedPart& part : made.parts) {
    made.origin.is_binary = made.origin.is_binary && part.mesh.points.is_binary();
  }
  return made;
}

// Foreign parts may leave some of the input uncovered, which a tree should not hide.
std::size_t count_uncovered(const Surface& surface, const HullTree& tree, StageLog& log) {
  return log.run("coverage", [&] {
    std::vector<ConvexPart> hulls;
    for (const NamedPart& part : tree.parts) hulls.push_back(convex_part(part.mesh.points));
    return find_uncovered(surface, hulls, log.watch("coverage")).uncovered.size();
  });
}

OutputFiles files_of(const BuiltTree& built, const TreeRequest& request, const TreeOrigin& origin,
                     const BvhArguments& options) {
  OutputFiles files;
  if (!options.output.empty()) {
    files.emplace_back(options.output, proven_tree_file(built, request, origin, options.output));
  }
  if (!options.picture.empty()) {
    const std::string title = std::filesystem::path(origin.input).filename().string();
    files.emplace_back(options.picture, picture_html(tree_picture(built, title)));
  }
  return files;
}

std::string summary_of(const BuiltTree& built, const TreeOrigin& origin, const OutputFiles& files) {
  std::string text = origin.input + "\n" + tree_text(built, origin);
  for (const auto& [path, bytes] : files) text += "  written     " + path + "\n";
  if (files.empty()) text += "  written     nothing; -o tree.json keeps the tree\n";
  return text;
}

int run_bvh(const BvhArguments& options) {
  if (!options.output.empty() && !options.output.ends_with(".json")) {
    throw Error(ErrorCode::InvalidArgument,
                "-o: expected a name that ends in .json, found " + in_quotes(options.output));
  }
  require_outputs({options.output, options.picture}, {options.input, options.from});
  CommandRun run(options.global);
  StageLog& log = run.log();
  SceneObject object = run.read_one(options.input, options.scene);
  const std::string name = object.name;
  auto made = mesh_of(std::move(object));
  if (const auto* reason = std::get_if<NotSolid>(&made)) return run.end_flat(name, *reason);
  const Mesh mesh = with_hulls_of_clouds(std::get<Mesh>(std::move(made)));
  if (mesh.points.size() == 0) {
    throw Error(ErrorCode::NoInterior, "the input has no point").in_file(name);
  }
  auto found = options.from.empty() ? decomposed_parts(mesh, name, options, log)
                                    : read_parts_of_tree(mesh, name, options, log);
  if (const auto* reason = std::get_if<NotSolid>(&found)) return run.end_flat(name, *reason);
  auto& parts = std::get<TreeParts>(found);
  TreeRequest request = options.tree;
  request.seed = options.global.seed;
  request.watch = log.watch();
  const BuiltTree built = build_tree(parts.parts, parts.joins, request);
  log.add(built.stages);
  if (!options.from.empty()) {
    parts.origin.uncovered = count_uncovered(parts.surface, built.tree, log);
  }
  const OutputFiles files = log.run(
      "write", StageKind::Io, [&] { return files_of(built, request, parts.origin, options); });
  return run.end({[&] { return tree_json(built, request, parts.origin); },
                  [&] { return summary_of(built, parts.origin, files); }, files});
}

}  // namespace

void add_bvh_command(Command& program, int& exit_code) {
  auto options = std::make_shared<BvhArguments>();
  Command& command = *program.add_subcommand(
      "bvh", "a tree of hulls over convex parts, each of which holds its children");
  command.footer(kBvhFooter);
  command
      .add_option("INPUT", options->input,
                  "a mesh (OBJ, OFF, PLY, STL, glTF, COLLADA), or halfspaces (JSON, .ine, rows); - "
                  "is standard "
                  "input")
      ->required();
  Option from = command.add_option(
      "--from", options->from,
      "parts to build on, instead of decomposing INPUT: objects of an OBJ, a folder of meshes, or "
      "JSON with \"parts\"");
  for (const BoundField& field : bound_fields(decompose_fields(), options->decomposition,
                                              {"method", "concavity", "max_parts", "loose"})) {
    add_field(command, field)->excludes(from);
  }
  add_choice(
      command, "--join", options->join, kJoinByNames,
      "how to join parts: by the splits or the next merges of the method, or by the least volume "
      "of the common hull, with which rays visit fewer nodes")
      ->excludes(from);
  add_fields(command, bound_fields(tree_fields(), options->tree, {"faces", "leaf_faces"}));
  command.add_option("-o,--output", options->output,
                     "file for the parts and the tree (.json), which query and verify read");
  command.add_option(
      "--picture", options->picture,
      "a page (.html) that shows the parts, and the hulls of each level around them");
  add_fields(command, bound_fields(tree_fields(), options->tree, {"precision"}));
  options->scene.on_read = remember_input;
  add_points_option(command, options->scene.points);
  add_decimal_option(command, options->scene.decimal);
  finish_command(command, options, exit_code, run_bvh);
  add_stages_option(command, options->global);
}

}  // namespace convexact::cli
