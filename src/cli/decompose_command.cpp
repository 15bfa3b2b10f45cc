// SPDX-License-Identifier: MIT
// convexact decompose: a mesh as few convex parts.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "bvh/tree_report.hpp"
#include "cli/model_files.hpp"
#include "cli/outputs.hpp"
#include "cli/part_files.hpp"
#include "cli/stdio_loop.hpp"
#include "cli/verify_union.hpp"
#include "convexact/decompose.hpp"
#include "convexact/hull_tree.hpp"
#include "io/json.hpp"
#include "oracle/decompose_request.hpp"
#include "oracle/written_parts.hpp"
#include "report/parts_picture.hpp"
#include "scene/decompose_options.hpp"
#include "scene/decompose_report.hpp"
#include "scene/decomposition_proof.hpp"
#include "scene/result_json.hpp"

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
    "what of the solid is in no part.\n"
    "Exit code 0 also where --max-parts or --flat merge leads beyond the concavity allowed, or a\n"
    "part of acd cannot be split; the summary and \"eps_holds\" say so. 4: INPUT has no face, or "
    "all its faces lie in one plane.";

// The files that a run writes. A new kind must be added to all_paths(), files_of() and the options.
struct DecomposeFiles {
  std::vector<std::string> results;  // -o
  std::string tree;                  // of hulls over the parts
  std::string trace;                 // every merge
  std::string proof;                 // for convexact-check
  std::string picture;               // a page

  std::vector<std::string> all_paths() const {
    std::vector<std::string> paths = results;
    for (const std::string& path : {tree, trace, proof, picture}) {
      if (!path.empty()) paths.push_back(path);
    }
    return paths;
  }
};

struct DecomposeArguments {
  GlobalOptions global;
  std::string input;
  SceneOptions scene;
  DecomposeFiles files;
  DecomposeMethod method = DecomposeMethod::Hacd;
  std::string concavity = "3%";
  std::optional<std::size_t> max_parts, faces, total_faces, tree_faces;
  ConcavityMeasure measure = ConcavityMeasure::Surface;
  BridgeChoice bridge = BridgeChoice::Farther;
  std::string coplanar = "0.99";
  FlatParts flat = FlatParts::Auto;
  bool keep_inner = false;
  Connect connect = Connect::Edge;
  Orient orient = Orient::Auto;
  Engine engine = Engine::Filtered;
  std::string names = "part_%03d";
  Precision precision = Precision::Binary64;
  bool exact_volumes = false, no_measures = false;
  StdioOptions stdio;
};

DecomposeRequest decompose_request(const DecomposeArguments& options) {
  if (options.faces && options.total_faces) {
    throw Error(ErrorCode::InvalidArgument,
                "--total-faces is for all parts together and --faces for each: name one");
  }
  if (options.exact_volumes && options.no_measures) {
    throw Error(ErrorCode::InvalidArgument,
                "--exact-volumes asks for volumes and --no-measures for none: name one");
  }
  DecomposeRequest request;
  request.method = options.method;
  request.limit = parse_concavity("--concavity", options.concavity);
  request.max_parts = options.max_parts;
  request.measure = options.measure;
  request.bridge = options.bridge;
  request.coplanar = parse_cosine("--coplanar", options.coplanar);
  request.connect = options.connect;
  request.orient = options.orient;
  request.flat = options.flat;
  request.keep_inner = options.keep_inner;
  request.engine = options.engine;
  request.faces = options.faces;
  request.total_faces = options.total_faces;
  request.precision = options.precision;
  request.measures = !options.no_measures;
  request.exact_volumes = options.exact_volumes;
  request.for_trace = !options.files.trace.empty();
  request.for_tree = !options.files.tree.empty();
  request.seed = options.global.seed;
  return request;
}

// A decomposition of one object of the input, and the names of its parts.
struct DecomposedObject {
  std::string name;
  Decomposition result;
  std::vector<std::string> part_names;
};

using DecomposedObjects = std::vector<DecomposedObject>;

// Names of parts of several objects begin with the name of the object, or with its number if one of
// these names cannot be part of the name of a file and of an object.
void name_parts(DecomposedObjects& objects, const std::vector<std::string>& object_names,
                const PartNames& names) {
  const bool is_plain = std::all_of(object_names.begin(), object_names.end(), is_plain_name);
  for (std::size_t k = 0; k < objects.size(); ++k) {
    std::string prefix;
    if (objects.size() > 1) {
      prefix = (is_plain ? object_names[k] : fmt::format("object_{}", k)) + "_";
    }
    for (std::size_t part = 0; part < objects[k].result.parts.size(); ++part) {
      objects[k].part_names.push_back(prefix + names(part));
    }
  }
}

std::vector<WrittenPart> written_parts(const DecomposedObjects& objects) {
  std::vector<WrittenPart> parts;
  for (const DecomposedObject& object : objects) {
    for (std::size_t k = 0; k < object.result.parts.size(); ++k) {
      parts.push_back({object.part_names[k], &object.result.parts[k], &object.result.surface});
    }
  }
  return parts;
}

// For several objects: their documents under "objects", and all parts together under "parts", each
// with the number of its object.
nlohmann::ordered_json document_of(const DecomposedObjects& objects,
                                   const DecomposeRequest& request, DecompositionDetail detail) {
  if (objects.size() == 1) {
    return decomposition_json(objects[0].result, request, objects[0].part_names, detail);
  }
  bool holds = true;
  nlohmann::ordered_json parts = nlohmann::ordered_json::array(), list = parts;
  for (std::size_t k = 0; k < objects.size(); ++k) {
    nlohmann::ordered_json entry = {{"name", objects[k].name}};
    entry.update(decomposition_json(objects[k].result, request, objects[k].part_names, detail));
    for (const nlohmann::ordered_json& part : entry["parts"]) {
      parts.push_back({{"name", part["name"]}, {"object", k}});
      parts.back().update(part);
    }
    entry.erase("parts");
    holds = holds && objects[k].result.limit_holds;
    list.push_back(std::move(entry));
  }
  return {{"decomposition", 1},
          {"eps_holds", holds},
          {"covers", "surface"},
          {"objects", list},
          {"parts", std::move(parts)}};
}

struct FilesOfParts {
  OutputFiles files;
  std::vector<std::string> folders, removed, notes;
  std::string tree;  // its lines in the summary
};

std::string in_folder(const std::string& folder, const std::string& file) {
  return (std::filesystem::path(folder) / file).string();
}

void add_folder(FilesOfParts& out, const std::string& folder, nlohmann::ordered_json document,
                const std::vector<WrittenPart>& parts, const std::string& input) {
  out.folders.push_back(folder);
  std::set<std::string> written;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const std::string file = part_file_name(parts[k].name), path = in_folder(folder, file);
    document["parts"][k]["file"] = file;
    written.insert(file);
    out.files.emplace_back(path, proven_parts_obj(std::span(parts).subspan(k, 1), path));
    require_other_files({path}, {input});
  }
  const std::string path = in_folder(folder, kPartsDocument);
  require_other_files({path}, {input});
  out.files.emplace_back(path, proven_parts_json(document, parts, path));
  const LeftInFolder left = left_in_folder(folder, written, {input});
  out.removed.insert(out.removed.end(), left.stale.begin(), left.stale.end());
  for (const std::string& file : left.foreign) {
    out.notes.push_back(file + " is none of these parts; verify of the folder takes it for one");
  }
}

// The tree over the parts as they are stored: its file, and its levels in the picture.
void add_tree(const DecomposedObject& object, const DecomposeRequest& request,
              const DecomposeArguments& options, FilesOfParts& out, Picture& picture) {
  const TreeRequest tree{.faces = options.tree_faces,
                         .leaf_faces = {},
                         .precision = request.precision,
                         .seed = request.seed,
                         .watch = {.stop = request.watch.stop}};
  const TreeOrigin origin{object.name, name_in(kDecomposeMethodNames, request.method),
                          object.result.surface.points.is_binary(), 0};
  const BuiltTree built = build_tree(object.result, object.part_names, tree);
  const std::string& path = options.files.tree;
  out.files.emplace_back(path, proven_tree_file(built, tree, origin, path));
  out.tree = tree_summary(built, origin);
  for (PictureLayer& layer : tree_layers(built)) picture.layers.push_back(std::move(layer));
}

FilesOfParts files_of(const DecomposedObjects& objects, const DecomposeRequest& request,
                      const DecomposeArguments& options) {
  FilesOfParts out;
  const Watch watch(request.watch.stop);
  const std::vector<WrittenPart> parts = written_parts(objects);
  for (const std::string& path : options.files.results) {
    watch.ask();
    const PartsOutput kind = parts_output_of(path);
    if (kind == PartsOutput::Obj) {
      out.files.emplace_back(path, proven_parts_obj(parts, path));
      continue;
    }
    if (kind != PartsOutput::Json && kind != PartsOutput::Folder) {
      out.files.emplace_back(path, model_bytes(path, options.files.results, parts));
      continue;
    }
    nlohmann::ordered_json document = document_of(objects, request, DecompositionDetail::All);
    if (kind == PartsOutput::Json) {
      out.files.emplace_back(path, proven_parts_json(document, parts, path));
    } else {
      add_folder(out, path, std::move(document), parts, options.input);
    }
  }
  watch.ask();
  if (!options.files.trace.empty()) {
    out.files.emplace_back(options.files.trace, write_decompose_trace(objects[0].result, request));
  }
  if (!options.files.proof.empty()) {
    out.files.emplace_back(options.files.proof,
                           write_decomposition_proof(objects[0].result, request));
  }
  Picture picture;
  if (!options.files.picture.empty()) {
    const std::string title = std::filesystem::path(objects[0].name).filename().string();
    picture = decomposition_picture(objects[0].result, title);
  }
  if (!options.files.tree.empty()) add_tree(objects[0], request, options, out, picture);
  if (!options.files.picture.empty()) {
    out.files.emplace_back(options.files.picture, picture_html(picture));
  }
  watch.ask();
  return out;
}

std::string answer_of(const DecomposedObjects& objects, const DecomposeRequest& request,
                      const FilesOfParts& out, const std::vector<Stage>& stages,
                      const DecomposeArguments& options) {
  if (options.global.json) {
    nlohmann::ordered_json document = document_of(objects, request, DecompositionDetail::Numbers);
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
  text += out.tree;
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

// The files that a run writes to a folder are known only when it ends, which is too late for a
// refusal.
void require_other_names(const DecomposeArguments& options, const PartNames& names) {
  const std::filesystem::path input(options.input);
  if (input.extension() != ".obj" || !names.may_end(input.stem().string())) return;
  const auto folder = input.has_parent_path() ? input.parent_path() : std::filesystem::path(".");
  for (const std::string& path : options.files.results) {
    std::error_code missing;
    if (parts_output_of(path) != PartsOutput::Folder ||
        !std::filesystem::equivalent(folder, path, missing)) {
      continue;
    }
    throw Error(ErrorCode::InvalidArgument,
                "-o " + path +
                    ": the input lies there and is called as a part may be; name "
                    "another folder, or other --names");
  }
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
  const PartNames names(options.names);
  if (!options.files.tree.empty() && !options.files.tree.ends_with(".json")) {
    throw Error(ErrorCode::InvalidArgument, "--tree: expected a name that ends in .json");
  }
  if (options.tree_faces && options.files.tree.empty()) {
    throw Error(ErrorCode::InvalidArgument, "--tree-faces is of a tree: name its file by --tree");
  }
  require_model_options(options.files.results, options.precision, options.flat);
  require_other_files(options.files.all_paths(), {options.input});
  require_other_names(options, names);
  Progress progress;
  StageLog log(progress.watch());
  std::vector<SceneObject> scene =
      log.run("read", StageKind::Io, [&] { return read_scene({options.input}, options.scene); });
  for (const auto& [option, path] :
       {std::pair("--tree", &options.files.tree), std::pair("--trace", &options.files.trace),
        std::pair("--proof", &options.files.proof),
        std::pair("--picture", &options.files.picture)}) {
    if (scene.size() > 1 && !path->empty()) {
      throw Error(ErrorCode::InvalidArgument,
                  std::string(option) + ": it shows one object, but there are several");
    }
  }
  request.watch = progress.watch();
  DecomposedObjects objects;
  std::vector<std::string> object_names;
  for (SceneObject& object : scene) {
    const std::string name = object.name;
    object_names.push_back(object.part);
    const auto made = mesh_of(std::move(object));
    const auto* reason = std::get_if<NotSolid>(&made);
    std::optional<DecomposeOutcome> outcome;
    if (reason == nullptr) {
      outcome = decompose_object(name, std::get<Mesh>(made), request);
      reason = std::get_if<NotSolid>(&*outcome);
    }
    if (reason != nullptr) {
      progress.clear();
      return report_not_solid(options.global, name, *reason);
    }
    objects.push_back({name, std::get<Decomposition>(std::move(*outcome)), {}});
    log.add(objects.back().result.stages);
  }
  name_parts(objects, object_names, names);
  const FilesOfParts out =
      log.run("write", StageKind::Io, [&] { return files_of(objects, request, options); });
  progress.clear();
  write_parts_together(out.files, out.folders, out.removed,
                       answer_of(objects, request, out, log.stages(), options));
  return 0;
}

}  // namespace

void add_decompose_command(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<DecomposeArguments>();
  CLI::App& command = *program.add_subcommand(
      "decompose", "the surface of a mesh as few convex parts, each the hull of some triangles");
  command.footer(kDecomposeFooter);
  command.add_option("INPUT", options->input,
                     "a mesh (OBJ, OFF, PLY, STL), or halfspaces (JSON, .ine, rows); - is standard "
                     "input");
  add_choice(
      command, "--method", options->method, kDecomposeMethodNames,
      "hacd merges neighbouring triangles, then clusters, by concavity and shape; acd splits "
      "the most concave part at its deepest notch, again and again");
  command
      .add_option("--concavity", options->concavity,
                  "how deep a cluster may lie in its hull: a share of the diameter, 3% or 0.03d, "
                  "or a length, 0.05")
      ->capture_default_str();
  add_count(command, "--max-parts", options->max_parts, {1},
            "at least 1: hacd merges on beyond the concavity allowed until so many parts are left, "
            "acd splits no more when there are so many");
  add_choice(command, "--measure", options->measure, kConcavityMeasureNames,
             "of hacd: concavity at every point of the triangles, or at their corners only, as "
             "published, which sees no notch whose corners all lie on the hull");
  add_choice(command, "--bridge", options->bridge, kBridgeChoiceNames,
             "of acd: concavity is the distance to a bridge, facets of the hull over the nearest "
             "path; to the farther of its bridges, to that of the whole region, or to the nearer");
  command
      .add_option("--coplanar", options->coplanar,
                  "of acd: facets are one bridge where the cosine of the angle between their "
                  "normals is larger; above 0, at most 1")
      ->capture_default_str();
  add_faces(command, options->faces, "how many halfspaces to keep of each part, at least 4");
  add_count(command, "--total-faces", options->total_faces, {4, std::uint64_t(1) << 32},
            "how many halfspaces to keep in all parts together, at least 4 for each");
  add_choice(command, "--flat", options->flat, kFlatPartsNames,
             "what becomes of clusters in a plane: thicken them, keep polygons, or merge them with "
             "a neighbour; auto thickens, and refuses an input that is flat as a whole");
  command.add_flag("--keep-inner", options->keep_inner, "keep parts that lie in another part");
  add_choice(command, "--connect", options->connect, kConnectNames,
             "neighbours have a common edge; or also edges that overlap; or also a common point of "
             "two components");
  add_choice(command, "--orient", options->orient, kOrientationNames,
             "turn faces until the solid comes out right, or keep them as they are");
  add_choice(command, "--engine", options->engine, kEngineNames,
             "of hacd: rationals everywhere; the same parts, faster; or doubles that choose, the "
             "parts still proven");
  command
      .add_option("-o,--output", options->files.results,
                  "file for the parts: .obj with an object for each, .json, or a folder (ends in "
                  "/) with a file for each; or a model for simulators, with --precision 32: "
                  ".mjcf.xml or .urdf beside a folder, .usda; may be repeated")
      ->expected(1)
      ->allow_extra_args(false)  // an INPUT that need not be there may follow
      ->take_all();
  command
      .add_option("--names", options->names,
                  "the name of a part: exactly one %d or %0Nd, which becomes its number")
      ->capture_default_str();
  command.add_option("--tree", options->files.tree,
                     "a tree of hulls over the parts (.json), as convexact bvh writes it");
  add_count(command, "--tree-faces", options->tree_faces, {4, std::uint64_t(1) << 32},
            "how many halfspaces to keep of each branch of the tree, at least 4");
  command.add_option("--trace", options->files.trace,
                     "every merge, or split, as JSON, for a program that replays it");
  command.add_option("--proof", options->files.proof,
                     "a text from which convexact-check proves owners, concavities, and that no "
                     "neighbours can be merged; of acd owners, and how deep corners lie");
  command.add_option("--picture", options->files.picture,
                     "a page (.html) that shows the parts, which a slider draws apart, and the "
                     "merges or splits step by step");
  add_choice<Precision>(command, "--precision", options->precision,
                        {{"64", Precision::Binary64}, {"32", Precision::Binary32}},
                        "the numbers of the parts: binary64, or rounded outward to binary32");
  command.add_flag("--exact-volumes", options->exact_volumes,
                   "volumes in JSON as fractions, too, which may be very long");
  command.add_flag("--no-measures", options->no_measures, "do not measure volumes");
  add_scene_options(command, options->scene);
  add_stdio_options(command, options->stdio, "one decomposition");
  finish_command(command, options, exit_code, run_decompose);
  add_stages_option(command, options->global);
}

}  // namespace convexact::cli
