// SPDX-License-Identifier: MIT
#include "cli/decomposed_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "cli/model_files.hpp"
#include "cli/part_files.hpp"
#include "convexact/error.hpp"
#include "io/json_document.hpp"
#include "pages/parts_picture.hpp"
#include "proof/decomposition_proof.hpp"
#include "wire/tree_report.hpp"
#include "wire/written_parts.hpp"

namespace convexact::cli {
namespace {

namespace fs = std::filesystem;

// ---- Files and folders of parts

// Which files a run writes to a folder is known when it ends, and too late for a refusal.
void require_other_names(const DecomposeFiles& files, const PartNames& names,
                         const std::string& input_path) {
  const fs::path input(input_path);
  if (input.extension() != ".obj" || !names.may_end(input.stem().string())) return;
  const auto folder = input.has_parent_path() ? input.parent_path() : fs::path(".");
  for (const std::string& path : files.results) {
    std::error_code missing;
    if (parts_output_of(path) != PartsOutput::Folder || !fs::equivalent(folder, path, missing)) {
      continue;
    }
    throw Error(ErrorCode::InvalidArgument,
                "-o " + path +
                    ": the input is in this folder, under a name that a part may get; name "
                    "another folder, or other --names");
  }
}

std::string in_folder(const std::string& folder, const std::string& file) {
  return (fs::path(folder) / file).string();
}

void add_folder(FilesOfParts& out, const std::string& folder, Json document,
                const std::vector<WrittenPart>& parts, const std::string& input,
                std::optional<std::size_t> jobs) {
  out.folders.push_back(folder);
  std::set<std::string> written;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const std::string file = part_file_name(parts[k].name), path = in_folder(folder, file);
    document["parts"][k]["file"] = file;
    written.insert(file);
    out.files.emplace_back(
        path, proven_parts_mesh(std::span(parts).subspan(k, 1), MeshFormat::Obj, path));
    require_other_files({path}, {input});
  }
  const std::string path = in_folder(folder, kPartsDocument);
  require_other_files({path}, {input});
  out.files.emplace_back(path, proven_parts_json(document, parts, path, jobs));
  const LeftInFolder left = left_in_folder(folder, written, {input});
  out.removed.insert(out.removed.end(), left.stale.begin(), left.stale.end());
  for (const std::string& file : left.foreign) {
    out.notes.push_back(file + " is not one of these parts, but verify would read it as one");
  }
}

// The files that show a single object.
void add_files_of_one(FilesOfParts& out, const DecomposedObject& object,
                      const DecomposeFiles& files) {
  if (!files.trace.empty()) {
    out.files.emplace_back(files.trace, write_decompose_trace(object.result, object.request));
  }
  if (!files.proof.empty()) {
    std::string proof = write_decomposition_proof(object.result, object.request);
    const auto& reach = object.result.reach;
    if (reach && reach->farther.empty() && !claims_reach(proof)) {
      out.notes.push_back(
          files.proof + (reach->squared_distance == 0
                             ? " does not claim the distance of 0, which this run proves by volumes"
                             : " does not claim the distance: this run proves it, but cells alone "
                               "do not, or too many of them; with a larger --distance they may"));
    }
    out.files.emplace_back(files.proof, std::move(proof));
  }
  Picture picture;
  if (!files.picture.empty()) {
    picture = decomposition_picture(object.result, fs::path(object.name).filename().string());
  }
  if (!files.tree.empty()) {
    TreeOfParts tree = tree_of_parts(object, object.request, files.tree_faces, files.tree);
    out.files.emplace_back(files.tree, std::move(tree.file));
    out.tree_summary = std::move(tree.summary);
    for (PictureLayer& layer : tree_layers(tree.built)) picture.layers.push_back(std::move(layer));
  }
  if (!files.picture.empty()) out.files.emplace_back(files.picture, picture_html(picture));
}

}  // namespace

std::vector<std::string> DecomposeFiles::all_paths() const {
  std::vector<std::string> paths = results;
  for (const std::string& path : {tree, trace, proof, picture}) {
    if (!path.empty()) paths.push_back(path);
  }
  return paths;
}

bool DecomposeFiles::need_binary32() const {
  return std::any_of(results.begin(), results.end(),
                     [](const std::string& path) { return is_binary32(parts_output_of(path)); });
}

bool DecomposeFiles::have_model() const {
  return std::any_of(results.begin(), results.end(),
                     [](const std::string& path) { return is_model(parts_output_of(path)); });
}

std::string DecomposeFiles::add_missing_folder() {
  const auto needs_folder = [](const std::string& path) {
    return names_files(parts_output_of(path));
  };
  const auto model = std::find_if(results.begin(), results.end(), needs_folder);
  if (model == results.end() || std::any_of(results.begin(), results.end(), is_folder)) return "";
  const std::string name = model_name(*model, parts_output_of(*model)) + "_parts/";
  const std::string folder = (fs::path(*model).parent_path() / name).string();
  std::string said = *model + " names the files of the parts, which are in " + folder;
  results.push_back(folder);
  return said;
}

bool DecomposeFiles::have_document() const {
  return std::any_of(results.begin(), results.end(),
                     [](const std::string& path) { return path.ends_with(".json"); });
}

bool DecomposeFiles::show_merges() const {
  return !trace.empty() || !picture.empty() || have_document();
}

void DecomposeFiles::require_sensible(const std::string& input,
                                      const DecomposeRequest& request) const {
  const PartNames part_names(names);
  if (!tree.empty() && !tree.ends_with(".json")) {
    throw Error(ErrorCode::InvalidArgument, "--tree: expected a name that ends in .json");
  }
  if (tree_faces && tree.empty()) {
    throw Error(ErrorCode::InvalidArgument,
                "--tree-faces applies to a tree: name its file with --tree");
  }
  require_sensible_models(results, request);
  require_outputs({tree, trace, proof, picture}, {input});
  for (const std::string& path : results) {
    if (is_folder(path)) {
      require_folder(path);
    } else {
      require_outputs({path}, {input});
    }
  }
  require_other_names(*this, part_names, input);
}

void DecomposeFiles::require_room_for(std::size_t objects) const {
  for (const auto& [option, path] :
       {std::pair("--tree", &tree), std::pair("--trace", &trace), std::pair("--proof", &proof),
        std::pair("--picture", &picture)}) {
    if (objects > 1 && !path->empty()) {
      throw Error(ErrorCode::InvalidArgument,
                  std::string(option) + ": it shows one object, but there are several");
    }
  }
}

void add_decompose_files(Command& command, DecomposeFiles& files) {
  command
      .add_option(
          "-o,--output", files.results,
          "file for the parts: .obj or .glb with an object for each, .json, or a folder (ends in "
          "/) with a file for each; or a model for simulators, in binary32: "
          ".mjcf.xml or .urdf beside a folder, .usda; may be repeated")
      ->expected(1)
      ->allow_extra_args(false)  // an INPUT that need not be there may follow
      ->take_all();
  command
      .add_option("--names", files.names,
                  "the name of a part: exactly one %d or %0Nd, which becomes its number")
      ->capture_default_str();
  command.add_option("--tree", files.tree,
                     "a tree of hulls over the parts (.json), as convexact bvh writes it");
  add_count(command, "--tree-faces", files.tree_faces, {4, std::uint64_t(1) << 32},
            "how many halfspaces to keep of each branch of the tree, at least 4");
  command.add_option("--trace", files.trace,
                     "every merge, or split, as JSON, for a program that replays it");
  command.add_option("--proof", files.proof,
                     "a text from which convexact-check proves owners, concavities, and that no "
                     "neighbours can be merged; of acd owners, and how deep corners lie");
  command.add_option("--picture", files.picture,
                     "a page (.html) that shows the parts, which a slider draws apart, and the "
                     "merges or splits step by step");
  add_model_options(command, files.model);
}

void name_parts(std::vector<DecomposedObject>& objects,
                const std::vector<std::string>& object_names, const std::string& pattern) {
  const PartNames names(pattern);
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

FilesOfParts decomposed_files(std::span<const DecomposedObject> objects,
                              const DecomposeRequest& request, const DecomposeFiles& files,
                              const std::string& input) {
  FilesOfParts out;
  const Watch watch(request.watch.stop);
  const std::vector<WrittenPart> parts = written_parts(objects);
  ModelOfParts model;
  if (files.have_model()) {
    model = model_of(objects, parts, files.results, files.model, watch);
    out.notes = std::move(model.notes);
    out.mass = std::move(model.mass);
    out.mass_summary = std::move(model.summary);
  }
  for (const std::string& path : files.results) {
    watch.ask();
    const PartsOutput kind = parts_output_of(path);
    if (kind == PartsOutput::Obj || kind == PartsOutput::Glb) {
      const MeshFormat format = kind == PartsOutput::Obj ? MeshFormat::Obj : MeshFormat::Gltf;
      out.files.emplace_back(path, proven_parts_mesh(parts, format, path, request.jobs));
    } else if (is_model(kind)) {
      out.files.emplace_back(path, model_bytes(path, files.results, model.body, parts, input));
    } else {
      auto document = decomposition_json(objects, DecompositionDetail::All);
      if (kind == PartsOutput::Json) {
        out.files.emplace_back(path, proven_parts_json(document, parts, path, request.jobs));
      } else {
        add_folder(out, path, std::move(document), parts, input, request.jobs);
      }
    }
  }
  watch.ask();
  add_files_of_one(out, objects[0], files);
  watch.ask();
  return out;
}

}  // namespace convexact::cli
