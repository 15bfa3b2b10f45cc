// SPDX-License-Identifier: MIT
// convexact decompose: a mesh as few convex parts.
#include <memory>

#include "cli/decompose_arguments.hpp"
#include "cli/outputs.hpp"
#include "cli/part_files.hpp"
#include "cli/promise_options.hpp"
#include "convexact/decompose.hpp"
#include "io/json.hpp"
#include "number/text.hpp"
#include "scene/objects.hpp"
#include "wire/decompose_options.hpp"
#include "wire/decompose_report.hpp"
#include "wire/stage_report.hpp"
#include "wire/written_parts.hpp"

namespace convexact::cli {
namespace {

constexpr const char* kDecomposeFooter =
    "Examples:\n"
    "  convexact decompose cow.obj -o parts.obj\n"
    "  convexact decompose cow.obj --concavity 5% --measure vertices -o parts/\n"
    "  convexact decompose cow.obj --max-parts 8 --faces 24 --names 'UCX_cow_%02d' -o cow_ucx.obj\n"
    "  convexact decompose cup.obj --distance 1% --effort high --picture parts.html\n"
    "  convexact decompose robot.stl --profile physx-gpu -o parts/ -o robot.usda\n"
    "  convexact decompose cow.obj --method acd --concavity 10% --picture splits.html\n"
    "  convexact decompose cow.obj --method hacd --trace merges.json -o parts.json\n"
    "  convexact decompose cow.obj --proof cow.proof && convexact-check cow.proof cow.obj\n"
    "  convexact decompose cow.obj --total-faces 400 -o parts/ --tree tree.json --tree-faces 24\n"
    "  convexact decompose cow.obj --precision 32 -o parts/ -o cow.mjcf.xml -o cow.urdf\n"
    "  convexact decompose robot.urdf --package my_robot=src/my_robot -o out/\n"
    "  convexact verify cow.obj parts.obj --distance 3%\n"
    "  convexact decompose --stdio <requests.jsonl\n"
    "\n"
    "A solid is cut by planes: the parts hold it, and no point of them is farther from it than "
    "--distance,\n"
    "both tested on the written numbers. The parts of hacd and acd are hulls of clusters of "
    "triangles: they\n"
    "hold every triangle, which need not cover the solid, and they may fill cavities; the summary "
    "says how\n"
    "much is in no part, and --measures all what of the parts is outside. Open surfaces are taken "
    "apart by\n"
    "hacd, with --guard reach and --merge reach.\n"
    "The exit code is 0 even if --max-parts, --faces or --flat merge leads beyond the limit, or a "
    "part of acd\n"
    "cannot be split; the summary and \"eps_holds\" say so. 4: INPUT has no point, or all its "
    "faces lie in one\n"
    "plane.";

DecomposeRequest decompose_request(const DecomposeArguments& options) {
  DecomposeRequest request = options.request;
  if (!options.profile.empty()) {
    if (request.faces || request.total_faces || request.max_vertices) {
      throw Error(ErrorCode::InvalidArgument,
                  "--profile says how many faces and corners a part may have: leave --faces, "
                  "--total-faces and --max-part-vertices out");
    }
    const Promise promise = find_profile(options.profile).promise;
    request.faces = promise.max_facets;
    request.max_vertices = promise.max_vertices;
    request.max_facet_vertices = promise.max_facet_vertices;
    request.precision = promise.numbers;
  } else if (options.files.need_binary32() && !options.precision->is_given()) {
    request.precision = Precision::Binary32;
  }
  if (request.faces && request.total_faces) {
    throw Error(ErrorCode::InvalidArgument,
                "--total-faces is for all parts together and --faces for each: name one");
  }
  request.measures =
      options.measures.to_print(options.global.json || options.files.have_document());
  request.exact_volumes = options.measures.exact_volumes;
  request.for_trace = !options.files.trace.empty();
  request.for_tree = !options.files.tree.empty();
  request.every_merge = options.global.json || options.files.show_merges();
  request.seed = options.global.seed;
  return request;
}

Json document_of(const std::vector<DecomposedObject>& objects, const FilesOfParts& out,
                 const DecomposeArguments& options) {
  Json document = decomposition_json(objects, DecompositionDetail::Numbers);
  if (objects.size() == 1) document["input"] = objects[0].name;
  document["files"] = options.files.all_paths();
  document["removed"] = out.removed;
  if (!out.mass.is_null()) document["mass"] = out.mass;
  if (!out.notes.empty()) document["notes"] = out.notes;
  return document;
}

std::string summary_of(const std::vector<DecomposedObject>& objects, const FilesOfParts& out,
                       const DecomposeArguments& options) {
  std::string text;
  for (const DecomposedObject& object : objects) {
    text += object.name + "\n" + summary(object.result, object.request, object.part_names);
  }
  text += out.tree_summary + out.mass_summary;
  for (const std::string& path : options.files.all_paths()) text += "  written     " + path + "\n";
  for (const std::string& path : out.removed) {
    text += "  removed     " + path + ", of an earlier run\n";
  }
  for (const std::string& note : out.notes) text += "  note        " + note + "\n";
  if (options.files.all_paths().empty()) {
    text += "  written     nothing; -o parts.obj keeps the parts\n";
  }
  return text;
}

// decompose(), with the name of the object in errors about it.
DecomposeOutcome decompose_mesh(const std::string& name, const Mesh& mesh,
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

// The mesh with corners joined that are near, as --weld asks, and a note of it.
Mesh welded(Mesh mesh, const std::string& name, const DecomposeArguments& options,
            CommandRun& run) {
  if (!options.weld || mesh.points.size() == 0) return mesh;
  const Rational squared = bounding_box(mesh.points).squared_diameter();
  WeldedMesh joined = run.log().run(
      "weld", [&] { return weld(mesh, options.weld->squared(squared), run.log().watch("weld")); });
  run.note(name, joined.moved == 0 ? "no corner is so near to another one"
                                   : counted(joined.moved, "corner was", "corners were") +
                                         " joined with another one, at most " +
                                         decimal_of_root(joined.squared_move) +
                                         " away; the parts hold where they were, too");
  return std::move(joined.mesh);
}

}  // namespace

std::variant<DecomposedObject, FlatMesh> decompose_object(SceneObject object,
                                                          const DecomposeRequest& request,
                                                          const DecomposeArguments& options,
                                                          CommandRun& run) {
  const std::string name = object.name;
  auto made = mesh_of(std::move(object));
  if (const auto* reason = std::get_if<NotSolid>(&made)) return FlatMesh{name, *reason};
  const Mesh mesh =
      welded(with_hulls_of_clouds(std::get<Mesh>(std::move(made))), name, options, run);
  DecomposeRequest own = with_method(mesh, request);
  if (request.method == DecomposeMethod::Auto && own.method == DecomposeMethod::Hacd) {
    run.note(name, own.guard == ReachUse::Reach && request.guard != ReachUse::Reach
                       ? "the surface is open: hacd, guarded and merged by reach"
                       : "hacd, as it alone has one of these options; --method cut holds solids");
  }
  DecomposeOutcome outcome = decompose_mesh(name, mesh, own);
  if (const auto* reason = std::get_if<NotSolid>(&outcome)) return FlatMesh{name, *reason};
  auto& result = std::get<Decomposition>(outcome);
  if (result.caps > 0 && !options.files.proof.empty()) {
    throw Error(ErrorCode::InvalidArgument,
                "caps close the surface, and --proof is about the faces in the file: add --close "
                "never");
  }
  run.log().add(result.stages);
  return DecomposedObject{name, std::move(result), {}, std::move(own)};
}

namespace {

int run_decompose(const DecomposeArguments& given) {
  DecomposeArguments options = given;
  const std::string folder_note = options.files.add_missing_folder();
  options.stdio.require_sensible();
  if (options.stdio.is_asked) return answer_lines(options.stdio, "decompose");
  if (options.input.empty()) {
    throw Error(ErrorCode::InvalidArgument, "name an INPUT, or --stdio");
  }
  DecomposeRequest request = decompose_request(options);
  if (is_robot(options.input)) return run_robot(options, request);
  options.files.require_sensible(options.input, request);
  if (options.weld && !options.files.proof.empty()) {
    throw Error(ErrorCode::InvalidArgument,
                "--weld changes the mesh, and --proof is about the mesh in the file: name one");
  }
  CommandRun run(options.global);
  std::vector<SceneObject> scene = run.read({options.input}, options.scene);
  options.files.require_room_for(scene.size());
  if (!folder_note.empty()) run.note(options.input, folder_note);
  if (request.precision != options.request.precision && options.files.need_binary32()) {
    run.note(options.input,
             "the parts are in binary32, rounded outward, as simulators and GLB take them");
  }
  request.watch = run.watch();
  std::vector<DecomposedObject> objects;
  std::vector<std::string> object_names;
  for (SceneObject& object : scene) {
    object_names.push_back(object.part);
    auto made = decompose_object(std::move(object), request, options, run);
    if (const auto* flat = std::get_if<FlatMesh>(&made)) {
      return run.end_flat(flat->name, flat->reason);
    }
    objects.push_back(std::get<DecomposedObject>(std::move(made)));
  }
  name_parts(objects, object_names, options.files.names);
  const FilesOfParts out = run.log().run("write", StageKind::Io, [&] {
    return decomposed_files(objects, request, options.files, options.input);
  });
  return run.end({.json = [&] { return document_of(objects, out, options); },
                  .text = [&] { return summary_of(objects, out, options); },
                  .files = out.files,
                  .write =
                      [&](const OutputFiles& files, const std::string& said) {
                        write_parts_together(files, out.folders, out.removed, said);
                      }});
}

void add_robot_options(Command& command, DecomposeArguments& options) {
  command
      .add_option(
          "--package", options.packages,
          "of a robot (.urdf): NAME=DIR, the folder that package://NAME/ stands for; may be "
          "repeated")
      ->expected(1)
      ->allow_extra_args(false)
      ->take_all();
  command.add_flag("--keep-going", options.keep_going,
                   "of a robot: a collision whose mesh cannot be decomposed stays as it is");
}

}  // namespace

void add_decompose_command(Command& program, int& exit_code) {
  auto options = std::make_shared<DecomposeArguments>();
  Command& command = *program.add_subcommand(
      "decompose", "a mesh as few convex parts that hold it, none far from it");
  command.footer(kDecomposeFooter);
  command.add_option(
      "INPUT", options->input,
      "a mesh (OBJ, OFF, PLY, STL, glTF, COLLADA), halfspaces (JSON, .ine, rows), or "
      "a robot (.urdf) with -o FOLDER/; - is standard input");
  add_fields(command, bound_fields(decompose_fields(), options->request));
  options->precision = command.get_option("--precision");
  add_text(command, "--profile",
           "parts that fit a program: as many faces and corners, and numbers, as it takes (" +
               std::string("physx, physx-gpu, unity, mujoco, jolt, bullet, ...)"),
           [&profile = options->profile](const auto&, const auto& text) { profile = text; })
      ->type_name("NAME");
  add_text(command, "--weld",
           "join corners of faces that are so near, each moved once: 1e-6, or 1e-6d of the "
           "diameter; the parts hold the joined faces, and all corners as they were",
           [&weld = options->weld](const auto&, const auto& text) { weld = parse_tolerance(text); })
      ->type_name("LENGTH");
  add_decompose_files(command, options->files);
  add_robot_options(command, *options);
  add_measures_options(command, options->measures, "");
  add_scene_options(command, options->scene);
  add_stdio_options(command, options->stdio, "one decomposition");
  finish_command(command, options, exit_code, run_decompose);
  add_stages_option(command, options->global);
  command.show_first({"--method",      "--distance",   "--effort",
                      "--max-parts",   "--max-excess", "--disjoint",
                      "--profile",     "--faces",      "--max-part-vertices",
                      "--total-faces", "--concavity",  "--guard",
                      "--merge",       "--output",     "--names",
                      "--picture",     "--proof",      "--precision",
                      "--measures",    "--parts",      "--up",
                      "--scale",       "--density",    "--json"});
}

}  // namespace convexact::cli
