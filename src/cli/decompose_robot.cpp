// SPDX-License-Identifier: MIT
// A whole robot: each mesh that its collisions name is decomposed once, and the model is written
// again with the parts in their place.
#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <set>

#include "cli/decompose_arguments.hpp"
#include "cli/part_files.hpp"
#include "convexact/error.hpp"
#include "convexact/io.hpp"
#include "io/file_kind.hpp"
#include "io/mesh_readers.hpp"
#include "number/text.hpp"
#include "wire/decompose_report.hpp"

namespace convexact::cli {
namespace {

namespace fs = std::filesystem;

// A mesh of the robot, decomposed; or why not, of a run that keeps going.
struct RobotMesh {
  std::optional<DecomposedObject> object;
  FilesOfParts out;
  std::string folder;  // below that of the output
  double unit = 1;     // meters
  std::string failure;
};

std::vector<RobotPackage> packages_of(const DecomposeArguments& options) {
  std::vector<RobotPackage> packages;
  for (const std::string& text : options.packages) {
    const std::size_t middle = text.find('=');
    if (middle == text.npos || middle == 0 || middle + 1 == text.size()) {
      throw Error(ErrorCode::InvalidArgument,
                  "--package: expected NAME=DIR, found " + in_quotes(text));
    }
    packages.push_back({text.substr(0, middle), text.substr(middle + 1)});
  }
  return packages;
}

// The folder of the output.
std::string require_sensible(const DecomposeArguments& options) {
  const DecomposeFiles& files = options.files;
  const auto& results = files.results;
  if (results.size() != 1 || !is_folder(results[0]) || files.all_paths().size() != 1) {
    throw Error(ErrorCode::InvalidArgument,
                "a robot is written to one folder, with the meshes of its parts: -o FOLDER/, and "
                "no other output");
  }
  if (options.scene.parts) {
    throw Error(ErrorCode::InvalidArgument, "--parts: each mesh of a robot is one object");
  }
  if (options.precision->is_given() && options.request.precision != Precision::Binary32) {
    throw Error(ErrorCode::InvalidArgument,
                "simulators round to the nearest binary32 number, which cuts off points of the "
                "input; --precision 32, the default for robots, rounds outward before that");
  }
  require_folder(results[0]);
  return results[0];
}

class RobotRun {
 public:
  RobotRun(const DecomposeArguments& options, const DecomposeRequest& request)
      : options_(options),
        request_(request),
        folder_(require_sensible(options)),
        packages_(packages_of(options)),
        run_(options.global),
        model_(read_model()) {
    request_.watch = run_.watch();
    request_.precision = Precision::Binary32;
  }

  int run() {
    std::vector<RobotParts> parts;
    for (const RobotCollision& collision : model_.collisions()) {
      paths_.push_back(path_of(collision));
      parts.push_back(parts_of(decomposed(collision, paths_.back())));
    }
    FilesOfParts all;
    for (auto& [path, mesh] : meshes_) {
      append(all.files, mesh.out.files);
      append(all.folders, mesh.out.folders);
      append(all.removed, mesh.out.removed);
    }
    all.folders.insert(all.folders.begin(), folder_);
    const std::string path = (fs::path(folder_) / fs::path(options_.input).filename()).string();
    require_other_files({path}, {options_.input});
    all.files.emplace_back(path, model_.with_parts(parts));
    note_relative_visuals();
    return run_.end({.json = [&] { return document(path); },
                     .text = [&] { return summary(path); },
                     .files = all.files,
                     .write =
                         [&](const OutputFiles& files, const std::string& said) {
                           write_parts_together(files, all.folders, all.removed, said);
                         }});
  }

 private:
  RobotModel read_model() {
    try {
      return RobotModel(read_bytes(options_.input));
    } catch (const Error& error) {
      throw error.in_file(display_name(options_.input));
    }
  }

  template <class List>
  static void append(List& all, List& more) {
    for (auto& item : more) all.push_back(std::move(item));
  }

  // In the words of the user: which collision of the model an error is about.
  Error of_collision(const Error& error, const RobotCollision& collision) const {
    return Error(error.code(), fmt::format("link {}: {}", in_quotes(collision.link), error.what()),
                 collision.line)
        .in_file(options_.input);
  }

  // Empty of a run that keeps going past a path that cannot be.
  std::string path_of(const RobotCollision& collision) {
    try {
      return robot_mesh_path(options_.input, collision.mesh, packages_);
    } catch (const Error& error) {
      if (!options_.keep_going) throw of_collision(error, collision);
      run_.note(options_.input, of_collision(error, collision).what());
      return "";
    }
  }

  const RobotMesh& decomposed(const RobotCollision& collision, const std::string& path) {
    const auto [found, is_new] = meshes_.try_emplace(path);
    RobotMesh& mesh = found->second;
    if (!is_new || path.empty()) return mesh;
    try {
      decompose_file(path, mesh);
    } catch (const Error& error) {
      const bool is_about_mesh = exit_code(error.code()) == 3 || exit_code(error.code()) == 4 ||
                                 error.code() == ErrorCode::Unrepresentable;
      if (!options_.keep_going || !is_about_mesh) throw of_collision(error, collision);
      mesh = {};
      mesh.failure = error.what();
      run_.note(options_.input, std::string(of_collision(error, collision).what()) +
                                    "; the collision stays as it was");
    }
    return mesh;
  }

  void decompose_file(const std::string& path, RobotMesh& mesh) {
    mesh.unit = collada_unit_of(path);
    SceneObject object = run_.read_one(path, options_.scene);
    const std::string stem = object.part;
    auto made = decompose_object(std::move(object), request_, options_, run_);
    if (const auto* flat = std::get_if<FlatMesh>(&made)) {
      throw Error(ErrorCode::NoInterior, "all its faces lie in one plane, or there is none")
          .in_file(flat->name);
    }
    std::vector<DecomposedObject> objects{std::get<DecomposedObject>(std::move(made))};
    mesh.folder = folder_for(is_plain_name(stem) ? stem : "mesh");
    name_parts(objects, {stem}, options_.files.names);
    // MuJoCo tells the meshes of a URDF apart by their names without folders.
    for (std::string& name : objects[0].part_names) name = mesh.folder + "_" + name;
    DecomposeFiles files;
    files.results = {(fs::path(folder_) / mesh.folder).string() + "/"};
    files.names = options_.files.names;
    mesh.out = decomposed_files(objects, request_, files, path);
    mesh.object = std::move(objects[0]);
  }

  static double collada_unit_of(const std::string& path) {
    const std::string bytes = read_bytes(path);
    return is_collada(bytes) ? collada_unit(bytes) : 1;
  }

  // Meshes of several packages may have the same name.
  std::string folder_for(const std::string& stem) {
    std::string name = stem;
    for (int number = 2; !folders_.insert(lower_case(name)).second; ++number) {
      name = fmt::format("{}-{}", stem, number);
    }
    return name;
  }

  static RobotParts parts_of(const RobotMesh& mesh) {
    RobotParts parts;
    parts.unit = mesh.unit;
    if (!mesh.object) return parts;
    for (const std::string& name : mesh.object->part_names) {
      parts.parts.push_back({name, mesh.folder + "/" + part_file_name(name)});
    }
    return parts;
  }

  // Their bytes stay, so a relative name would be looked for beside the new model.
  void note_relative_visuals() {
    for (const RobotCollision& collision : model_.collisions()) {
      if (collision.mesh.find("://") != std::string::npos) continue;
      run_.note(options_.input,
                "meshes of <visual> are named relative to the model, and stay where they are: copy "
                "them beside " +
                    folder_ + ", or use package://");
      return;
    }
  }

  Json document(const std::string& path) const {
    Json links = Json::array(), written = Json::array({path});
    for (std::size_t k = 0; k < paths_.size(); ++k) {
      const RobotCollision& collision = model_.collisions()[k];
      const RobotMesh& mesh = meshes_.at(paths_[k]);
      Json entry = {{"link", collision.link}, {"line", collision.line}, {"mesh", collision.mesh}};
      if (mesh.object) {
        entry["folder"] = mesh.folder;
        entry["parts"] = mesh.object->part_names.size();
        entry["covers"] = covered_name(mesh.object->result);
        entry["eps_holds"] = mesh.object->result.limit_holds;
      } else {
        entry["failure"] = mesh.failure;
      }
      links.push_back(std::move(entry));
    }
    return {{"robot", model_.name()},
            {"input", options_.input},
            {"links", model_.links()},
            {"collisions", links},
            {"files", written}};
  }

  std::string summary(const std::string& path) const {
    std::size_t parts = 0, replaced = 0;
    std::string lines;
    for (std::size_t k = 0; k < paths_.size(); ++k) {
      const RobotCollision& collision = model_.collisions()[k];
      const RobotMesh& mesh = meshes_.at(paths_[k]);
      const std::string name = fs::path(collision.mesh).filename().string();
      if (!mesh.object) {
        lines += fmt::format("  {}: {} stays as it was\n", collision.link, name);
        continue;
      }
      const Decomposition& result = mesh.object->result;
      ++replaced;
      parts += result.parts.size();
      lines += fmt::format("  {}: {}, {}, hold its {}{}\n", collision.link, name,
                           counted(result.parts.size(), "part", "parts"), covered_name(result),
                           result.limit_holds ? "" : ", but reach beyond the limit");
    }
    const std::size_t all = paths_.size();
    std::string text = options_.input + "\n";
    text += summary_line(
        "result", all == 0
                      ? "no collision names a mesh: nothing to decompose"
                      : fmt::format("{} of {} replaced by {}", with_separators(replaced),
                                    counted(all, "collision with a mesh", "collisions with meshes"),
                                    counted(parts, "part", "parts")));
    return text + lines + summary_line("written", path);
  }

  const DecomposeArguments& options_;
  DecomposeRequest request_;
  std::string folder_;
  std::vector<RobotPackage> packages_;
  CommandRun run_;
  RobotModel model_;
  std::vector<std::string> paths_;           // of the meshes of its collisions
  std::map<std::string, RobotMesh> meshes_;  // by path
  std::set<std::string> folders_;
};

}  // namespace

bool is_robot(const std::string& input) {
  const std::string name = lower_case(input);
  return name.ends_with(".urdf") || name.ends_with(".xacro");  // which says what to do
}

int run_robot(const DecomposeArguments& options, const DecomposeRequest& request) {
  return RobotRun(options, request).run();
}

}  // namespace convexact::cli
