// SPDX-License-Identifier: MIT
// outputs.hpp - the files that simplify writes: all of them, complete, or none.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "cli/command_run.hpp"
#include "cli/implicit_input.hpp"
#include "convexact/decompose.hpp"
#include "convexact/run.hpp"
#include "convexact/scene.hpp"
#include "convexact/simplify.hpp"
#include "io/json_document.hpp"
#include "pages/solids_picture.hpp"
#include "scene/each_object.hpp"
#include "solid/stage_log.hpp"
#include "wire/stage_report.hpp"

namespace convexact::cli {

struct OutputOptions {
  std::vector<std::string>
      results;          ///< -o: .obj .off .ply .stl are meshes, .json .ine .txt planes.
  std::string picture;  ///< An HTML page; empty for none.
  std::string trace;    ///< Every step as JSON; empty for none.
  std::string proof;    ///< For convexact-check; empty for none.
  int precision = 0;    ///< 64 or 32; 0 if not given.

  std::vector<std::string> all_paths() const;
  /// The formats that the result must be stored in; unset where no output needs them.
  StoreRequest store_request() const;
  /// @throws Error InvalidArgument for unknown extensions and for formats that contradict each
  /// other.
  void require_sensible() const;
  /// @throws Error InvalidArgument if an output cannot hold that many objects.
  void require_room_for(std::size_t objects) const;
};

/// Before the work that they are for: can the outputs be written? Empty names are none.
/// @throws Error InvalidArgument if an output is one of the inputs, under any name: the input would
/// be lost; Unwritable as AtomicOutput.
void require_outputs(const std::vector<std::string>& outputs,
                     const std::vector<std::string>& inputs);
/// A folder that exists and can be written to, or can be made. @throws Error Unwritable.
void require_folder(const std::string& folder);
/// The first half of require_outputs(), for files in a folder that is yet to be made.
void require_other_files(const std::vector<std::string>& outputs,
                         const std::vector<std::string>& inputs);

/// An object of a scene, and the result of a command for it.
template <class Result>
struct FoundObject {
  SceneObject source;
  Result result;
};

/// An object of a scene that encloses no volume.
struct FlatObject {
  std::string name;
  NotSolid reason;
};

/// The results of `work` for each object, from its shape, its number, a watch and the threads that
/// it may use, with its stages in the log; or the first object without volume. See on_each().
template <class Result, class Work>
std::variant<std::vector<FoundObject<Result>>, FlatObject> on_each_object(
    std::vector<SceneObject> scene, StageLog& log, std::optional<std::size_t> jobs,
    const Work& work) {
  auto outcome = on_each<Result>(
      scene.size(), jobs, log.watch(),
      [&](std::size_t k, const StageWatch& watch, std::size_t threads) {
        return std::variant<Result, NotSolid>(work(scene[k].shape, k, watch, threads));
      });
  if (const auto* flat = std::get_if<NotSolidPart>(&outcome)) {
    const SceneObject& object = scene[flat->part];
    return FlatObject{object.name, of_typed_rows(flat->reason, object.rows)};
  }
  std::vector<FoundObject<Result>> found;
  for (Result& result : std::get<std::vector<Result>>(outcome)) {
    log.add(result.stages);
    found.push_back({std::move(scene[found.size()]), std::move(result)});
  }
  return found;
}

/// A list of the objects: each with its name, the entries of `json` for its result, and its stages.
template <class Result, class Describe>
Json objects_json(const std::vector<FoundObject<Result>>& objects, Describe&& json) {
  Json list = Json::array();
  for (const auto& [source, result] : objects) {
    Json& entry = list.emplace_back();
    entry["name"] = source.name;
    entry.update(json(result));
    entry["stages"] = stages_json(result.stages);
  }
  return list;
}

void add_input_argument(Command& command, std::vector<std::string>& inputs);
void add_output_options(Command& command, OutputOptions& options);
/// --decimal: the meaning of decimals in text.
void add_decimal_option(Command& command, Decimal& decimal);
/// --skip-bad: whether numbers of INPUT that are not finite are left out.
void add_skip_bad_option(Command& command, bool& skip_bad);
/// --points: which points of an input with faces count.
void add_points_option(Command& command, MeshPoints& points);
void add_scene_options(Command& command, SceneOptions& options);

/// One object and the solid that encloses it.
struct OutputObject : DrawnSolid {
  const Run* run = nullptr;         ///< Set wherever a trace or a proof may be asked for.
  const RunStart* start = nullptr;  ///< Set wherever a proof may be asked for.
};

/// Every output, after reading each mesh and plane file back from its bytes and testing that the
/// result holds every input point.
/// @throws Error Unrepresentable; Internal if that test fails.
[[nodiscard]] OutputFiles output_files(const std::vector<OutputObject>& objects,
                                       const OutputOptions& options);

/// For each file a line of a summary that names it.
[[nodiscard]] std::string written_lines(const OutputOptions& options);

/// The objects of all inputs; of a command with --implicit, possibly the corners of its cells.
/// @param options  Their `needs_polygons()` says whether anything but the points of meshes counts.
template <class Arguments>
std::vector<SceneObject> read_objects(const Arguments& options, CommandRun& run) {
  if constexpr (requires { options.implicit; }) {
    if (options.implicit.is_given()) {
      return {run.log().run("cells", [&] {
        return read_implicit_object(options.implicit, options.scene, run.log().watch("cells"));
      })};
    }
  }
  SceneOptions scene = options.scene;
  scene.points_only = !options.needs_polygons();
  return run.read(options.inputs, scene);
}

/// Runs a subcommand that reads objects, computes results for them under a watch, and writes the
/// outputs and the answer; returns the exit code.
/// @param find    From all objects to the results for each, or to one without volume.
/// @param answer  The document and the summary, from the objects.
template <class Result, class Arguments, class Find, class Answer>
int run_on_scene(const Arguments& options, Find&& find, Answer&& answer) {
  options.output.require_sensible();
  require_outputs(options.output.all_paths(), options.inputs);
  CommandRun run(options.global);
  std::vector<SceneObject> scene = read_objects(options, run);
  options.output.require_room_for(scene.size());
  std::variant<std::vector<FoundObject<Result>>, FlatObject> found =
      find(std::move(scene), run.log(), run.watch());
  if (const auto* flat = std::get_if<FlatObject>(&found)) {
    return run.end_flat(flat->name, flat->reason);
  }
  std::vector<OutputObject> outputs;
  auto& objects = std::get<std::vector<FoundObject<Result>>>(found);
  for (FoundObject<Result>& object : objects) {
    Result& result = object.result;
    result.redundant = to_typed_rows(std::move(result.redundant), object.source.rows);
    OutputObject& output = outputs.emplace_back(OutputObject{drawn(object.source, result)});
    if constexpr (requires { result.run; }) {
      if (result.run) output.run = &*result.run;
      if (result.start) output.start = &*result.start;
    }
  }
  CommandAnswer said = answer(objects);
  said.files =
      run.log().run("write", StageKind::Io, [&] { return output_files(outputs, options.output); });
  return run.end(said);
}

/// The same with `work` on each object.
/// @param jobs      Of on_each().
/// @param requests  From all objects to a list with the request for each of them.
template <class Result, class Arguments, class Requests, class Work, class Answer>
int run_on_inputs(const Arguments& options, std::optional<std::size_t> jobs, Requests&& requests,
                  Work&& work, Answer&& answer) {
  const auto find = [&](std::vector<SceneObject> scene, StageLog& log, const StageWatch&) {
    const auto asked = requests(scene);
    return on_each_object<Result>(
        std::move(scene), log, jobs,
        [&](const Shape& shape, std::size_t k, const StageWatch& watch, std::size_t threads) {
          auto own = asked[k];
          own.watch = watch;
          own.jobs = threads;
          return work(shape, own);
        });
  };
  return run_on_scene<Result>(options, find, answer);
}

}  // namespace convexact::cli
