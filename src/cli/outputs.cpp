// SPDX-License-Identifier: MIT
#include "cli/outputs.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

#include "convexact/error.hpp"
#include "convexact/io.hpp"
#include "convexact/stored.hpp"
#include "io/json.hpp"
#include "io/used_points.hpp"
#include "pages/picture.hpp"
#include "proof/proof.hpp"
#include "wire/decompose_options.hpp"
#include "wire/simplify_report.hpp"
#include "wire/trace_json.hpp"

namespace convexact::cli {
namespace {

bool is_binary32_only(const std::string& path) {
  const auto format = mesh_format_of_path(path);
  return format && holds_binary32_only(*format);
}

Precision precision_of(int bits) { return bits == 32 ? Precision::Binary32 : Precision::Binary64; }

const PointSet* points_of(const SceneObject& object) {
  return std::get_if<PointSet>(&object.shape);
}

// The file's name without its folder and without the part that may follow.
std::string file_of(const SceneObject& object) {
  std::string path = object.name;
  const std::string part = ": " + object.part;
  if (path.ends_with(part)) path.resize(path.size() - part.size());
  return std::filesystem::path(path).filename().string();
}

// A scan has many points that no face uses; over its surface they would look like cracks.
PictureLayer points_of_no_face(const PictureLayer& input) {
  PictureLayer loose{.name = "points that no face uses", .color = "#009e73", .shown = false};
  const std::vector<bool> is_used = used_points(input.points.size(), input.polygons);
  for (std::size_t k = 0; k < is_used.size(); ++k) {
    if (!is_used[k]) loose.points.push_back(input.points[k]);
  }
  return loose;
}

// Of all objects together.
std::string growth_of(const std::vector<OutputObject>& objects) {
  std::optional<std::array<Enclosure, 2>> sum;
  for (const OutputObject& object : objects) {
    if (!object.volumes) return "";
    const auto& [before, after] = *object.volumes;
    sum = sum ? std::array{(*sum)[0] + before, (*sum)[1] + after} : object.volumes;
  }
  if (!sum) return "";
  const bool is_changed =
      std::any_of(objects.begin(), objects.end(),
                  [](const OutputObject& object) { return object.is_simplified; });
  return is_changed ? "; volume " + growth_percent((*sum)[0], (*sum)[1]) : "; nothing was removed";
}

std::string picture_bytes(const std::vector<OutputObject>& objects) {
  PictureLayer input{.name = "input", .color = "#e69f00"};
  PictureLayer solids{
      .name = "enclosing solid", .color = "#56b4e9", .opacity = 0.25, .edges = true, .right = true};
  PictureLayer kept{.name = "kept faces", .color = "#d55e00", .edges = true, .right = true};
  std::set<std::string> files;
  for (const OutputObject& object : objects) {
    files.insert(file_of(object.source));
    if (const PointSet* points = points_of(object.source)) {
      input.add(points->doubles(), object.source.polygons);
    }
    solids.add_to_pick(object.solid.exact,
                       objects.size() > 1 ? as_utf8(object.source.name) : "enclosing solid");
    for (const std::size_t plane : object.kept) kept.add_facet(object.solid.exact, plane);
  }
  Picture picture;
  picture.title = as_utf8(file_of(objects[0].source));
  if (files.size() > 1) picture.title += " and " + std::to_string(files.size() - 1) + " more";
  picture.answer =
      with_separators(solids.polygons.size()) + " halfspaces hold " +
      (objects.size() > 1 ? counted(objects.size(), "object", "objects") : "every point") +
      growth_of(objects);
  if (!input.points.empty()) {
    PictureLayer loose = points_of_no_face(input);
    const bool is_surface = !input.polygons.empty();
    picture.layers.push_back(std::move(input));
    if (is_surface && !loose.points.empty()) picture.layers.push_back(std::move(loose));
  }
  if (!kept.polygons.empty()) picture.layers.push_back(std::move(kept));
  picture.layers.push_back(std::move(solids));
  return picture_html(picture);
}

}  // namespace

std::vector<std::string> OutputOptions::all_paths() const {
  std::vector<std::string> paths = results;
  if (!picture.empty()) paths.push_back(picture);
  if (!trace.empty()) paths.push_back(trace);
  if (!proof.empty()) paths.push_back(proof);
  return paths;
}

StoreRequest OutputOptions::store_request() const {
  StoreRequest request;
  const bool needs_32 = std::any_of(results.begin(), results.end(), is_binary32_only);
  for (const std::string& path : results) {
    if (mesh_format_of_path(path)) {
      request.mesh = precision_of(precision != 0 ? precision : needs_32 ? 32 : 64);
    } else if (precision != 0) {
      request.planes = precision_of(precision);
    }
  }
  // A proof has planes in a format, whether or not they are written to a file.
  if (!proof.empty() && precision != 0) request.planes = precision_of(precision);
  return request;
}

void OutputOptions::require_sensible() const {
  std::string floats;  // a file of binary32
  bool other_mesh = false;
  for (const std::string& path : results) {
    if (!mesh_format_of_path(path) && !halfspace_format_of_path(path)) {
      reject_argument(
          "-o " + path +
          ": expected an extension .obj, .off, .ply, .stl, .glb, .xyz, .json, .ine or .txt");
    }
    if (is_binary32_only(path)) floats = path;
    other_mesh = other_mesh || (mesh_format_of_path(path) && !is_binary32_only(path));
  }
  if (!floats.empty() && (precision == 64 || (other_mesh && precision == 0))) {
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
  if (!options.picture.empty()) files.emplace_back(options.picture, picture_bytes(objects));
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
