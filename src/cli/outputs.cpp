// SPDX-License-Identifier: MIT
#include "cli/outputs.hpp"

#include <algorithm>
#include <filesystem>

#include "convexact/error.hpp"
#include "convexact/io.hpp"
#include "convexact/stored.hpp"
#include "io/json.hpp"
#include "io/used_points.hpp"
#include "pages/solids_picture.hpp"
#include "proof/proof.hpp"
#include "wire/decompose_options.hpp"
#include "wire/result_files.hpp"
#include "wire/trace_json.hpp"

namespace convexact::cli {

std::vector<std::string> OutputOptions::all_paths() const {
  std::vector<std::string> paths = results;
  if (!picture.empty()) paths.push_back(picture);
  if (!trace.empty()) paths.push_back(trace);
  if (!proof.empty()) paths.push_back(proof);
  return paths;
}

StoreRequest OutputOptions::store_request() const {
  std::vector<std::string> stored = results;
  if (!proof.empty()) stored.push_back("run.proof");
  return store_request_for(stored, precision);
}

void OutputOptions::require_sensible() const {
  for (const std::string& path : results) {
    if (!mesh_format_of_path(path) && !halfspace_format_of_path(path)) {
      reject_argument(
          "-o " + path +
          ": expected an extension .obj, .off, .ply, .stl, .glb, .xyz, .json, .ine or .txt");
    }
  }
  const std::string floats = file_of_less_precision(results, precision);
  if (!floats.empty()) {
    reject_argument("-o " + floats + ": " +
                    (mesh_format_of_path(floats) == MeshFormat::Stl ? "STL" : "GLB") +
                    " holds binary32 only: use --precision 32, or write it in a run of its own");
  }
}

void OutputOptions::require_room_for(std::size_t objects) const {
  if (objects < 2) return;
  if (!trace.empty())
    reject_argument("--trace: a trace describes one object, but there are several");
  if (!proof.empty())
    reject_argument("--proof: a proof describes one object, but there are several");
  for (const std::string& path : results) {
    const auto format = mesh_format_of_path(path);
    if (format != MeshFormat::Obj && format != MeshFormat::Gltf) {
      reject_argument("-o " + path + ": only .obj and .glb hold several objects");
    }
  }
}

void require_other_files(const std::vector<std::string>& outputs,
                         const std::vector<std::string>& inputs) {
  for (const std::string& output : outputs) {
    for (const std::string& input : inputs) {
      std::error_code missing;  // a file that does not exist is none of the inputs
      if (std::filesystem::equivalent(output, input, missing)) {
        reject_argument("-o " + output +
                        ": this file is an input, which would be lost; name another file");
      }
    }
  }
}

void require_outputs(const std::vector<std::string>& outputs,
                     const std::vector<std::string>& inputs) {
  require_other_files(outputs, inputs);
  for (const std::string& output : outputs) {
    if (!output.empty()) AtomicOutput::require_writable(output);
  }
}

void require_folder(const std::string& folder) {
  std::error_code failed;
  std::filesystem::path made = std::filesystem::absolute(folder, failed);
  while (!std::filesystem::exists(made, failed) && made.has_relative_path()) {
    made = made.parent_path();
  }
  AtomicOutput::require_writable((made / "file").string());
}

void add_input_argument(Command& command, std::vector<std::string>& inputs) {
  command
      .add_option("INPUT", inputs,
                  "meshes or points (OBJ, OFF, PLY, STL, glTF, COLLADA, XYZ) or halfspaces (JSON, "
                  ".ine, rows); - "
                  "is standard input")
      ->required();
}

void add_output_options(Command& command, OutputOptions& options) {
  command
      .add_option("-o,--output", options.results,
                  "file for the result, by extension: .obj .off .ply .stl .xyz or .json .ine .txt; "
                  "may be repeated")
      ->expected(1)
      ->allow_extra_args(false)  // an INPUT that need not be there may follow
      ->take_all();
  command.add_option("--picture", options.picture, "a page (.html) that shows input and result");
  add_choice<int>(command, "--precision", options.precision, {{"64", 64}, {"32", 32}},
                  "round outward to binary64 or binary32");
}

void add_decimal_option(Command& command, Decimal& decimal) {
  add_choice<Decimal>(command, "--decimal", decimal,
                      {{"nearest", Decimal::Nearest}, {"exact", Decimal::Exact}},
                      "decimals in text mean the nearest double, or the number they spell");
}

void add_points_option(Command& command, MeshPoints& points) {
  add_choice(command, "--points", points, kMeshPointsNames,
             "of an INPUT with faces, all its points count, or only those that faces use; a file "
             "without faces is its points");
}

void add_skip_bad_option(Command& command, bool& skip_bad) {
  command.add_flag("--skip-bad", skip_bad,
                   "leave out points of clouds and corners of STL facets that are not finite, with "
                   "a note; otherwise they are an error");
}

void add_scene_options(Command& command, SceneOptions& options) {
  options.on_read = remember_input;
  command.add_flag("--parts", options.parts,
                   "treat each object (o or g line, STL solid) separately");
  add_points_option(command, options.points);
  add_decimal_option(command, options.decimal);
  add_skip_bad_option(command, options.skip_bad);
}

OutputFiles output_files(const std::vector<OutputObject>& objects, const OutputOptions& options) {
  OutputFiles files;
  std::vector<NamedSolid> solids;
  for (const OutputObject& object : objects) solids.push_back({object.source.part, &object.solid});
  for (const std::string& path : options.results) {
    files.emplace_back(path, proven_bytes(solids, path));
  }
  if (!options.picture.empty())
    files.emplace_back(options.picture,
                       picture_html(solids_picture({objects.begin(), objects.end()})));
  if (!options.trace.empty()) {
    files.emplace_back(options.trace, write_trace_json(*objects[0].run));
  }
  if (!options.proof.empty()) {
    const OutputObject& object = objects[0];
    files.emplace_back(options.proof, write_proof(*object.start, *object.run, object.solid.points,
                                                  object.solid.planes));
  }
  return files;
}

std::string written_lines(const OutputOptions& options) {
  std::string text;
  for (const std::string& path : options.all_paths()) text += "  written     " + path + "\n";
  return text;
}

}  // namespace convexact::cli
