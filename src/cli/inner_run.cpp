// SPDX-License-Identifier: MIT
#include "cli/inner_run.hpp"

#include "convexact/io.hpp"
#include "convexact/simplify.hpp"
#include "io/json.hpp"
#include "pages/solids_picture.hpp"
#include "wire/inner_report.hpp"
#include "wire/simplify_options.hpp"
#include "wire/trace_json.hpp"

namespace convexact::cli {
namespace {

void require_sensible(const SimplifyArguments& options) {
  if (!options.keep.empty() || options.total_faces) {
    reject_argument(std::string(options.keep.empty() ? "--total-faces" : "--keep") +
                    " does not apply to an inner run (--inner)");
  }
  if (!options.output.proof.empty()) {
    reject_argument(
        "--proof: convexact-check proves outer runs; --trace holds every step of an inner "
        "one");
  }
  options.output.require_sensible();
  if (options.output.precision == 32) {
    reject_argument(
        "--precision 32: an inner run keeps vertices of the input as they are, in "
        "binary64");
  }
  for (const std::string& path : options.output.results) {
    const auto format = mesh_format_of_path(path);
    if (format && holds_binary32_only(*format)) {
      reject_argument("-o " + path +
                      ": STL and GLB hold binary32; an inner run keeps vertices of the input "
                      "as they are, in binary64");
    }
    if (halfspace_format_of_path(path) && options.output.precision == 64) {
      throw Error(ErrorCode::Unrepresentable,
                  "-o " + path +
                      ": planes in binary64 would have to be pushed inward, which is not "
                      "proven; without --precision they are exact integers");
    }
  }
}

InnerRequest inner_request_of(const SimplifyArguments& options) {
  InnerRequest request = inner_request(options.given);
  request.seed = options.global.seed;
  request.costs = !options.output.trace.empty();
  for (const std::string& path : options.output.results) {
    request.mesh = request.mesh || mesh_format_of_path(path);
  }
  return request;
}

OutputFiles files_of(const std::vector<FoundObject<InnerResult>>& objects,
                     const OutputOptions& options) {
  OutputFiles files;
  std::vector<NamedInner> results;
  for (const auto& [source, result] : objects) results.push_back({source.part, &result});
  for (const std::string& path : options.results) {
    files.emplace_back(path, proven_inner_bytes(results, path));
  }
  if (!options.picture.empty()) {
    std::vector<DrawnInner> drawn;
    for (const auto& [source, result] : objects) drawn.push_back({source, result});
    files.emplace_back(options.picture, picture_html(inner_picture(drawn)));
  }
  if (!options.trace.empty()) {
    const InnerResult& result = objects[0].result;
    files.emplace_back(options.trace, write_inner_trace_json(result.start, result.run));
  }
  return files;
}

using InnerSolids = std::vector<FoundObject<InnerResult>>;

Json document_of(const InnerSolids& objects) {
  return objects.size() == 1 ? inner_json(objects[0].result)
                             : Json{{"objects", objects_json(objects, inner_json)}};
}

std::string summary_of(const InnerSolids& objects, const OutputOptions& output) {
  std::string text;
  for (const auto& [source, result] : objects) text += source.name + "\n" + summary(result);
  text += written_lines(output);
  if (output.all_paths().empty()) text += "  written     nothing; -o inner.obj keeps the solid\n";
  return text;
}

}  // namespace

void add_inner_options(Command& command, SimplifyArguments& options) {
  command.add_flag("--inner", options.inner,
                   "remove vertices of the hull instead: a solid inside, losing as little volume "
                   "as possible");
  add_fields(command, options.given.bound(inner_fields(), fields_of_inner_runs()));
}

void require_inner(const SimplifyArguments& options) {
  if (options.inner) return;
  for (const auto& [info, text] : options.given.all()) {
    if (!is_wanted(*info, fields_of_inner_runs())) continue;
    reject_argument(option_of(*info) + " applies only to an inner run; give --inner as well");
  }
}

int run_inner(const SimplifyArguments& options) {
  require_sensible(options);
  const InnerRequest wanted = inner_request_of(options);
  require_outputs(options.output.all_paths(), options.inputs);
  CommandRun run(options.global);
  std::vector<SceneObject> scene = read_objects(options, run);
  for (const SceneObject& object : scene) {
    if (std::holds_alternative<PointSet>(object.shape)) continue;
    reject_argument("--inner: " + object.name +
                    " is a list of halfspaces; an inner run removes vertices of points or a mesh");
  }
  options.output.require_room_for(scene.size());
  auto found = on_each_object<InnerResult>(
      std::move(scene), run.log(), wanted.jobs,
      [&](const Shape& shape, std::size_t, const StageWatch& watch, std::size_t jobs) {
        InnerRequest request = wanted;
        request.jobs = jobs;
        request.watch = watch;
        return simplify_inner(std::get<PointSet>(shape), request);
      });
  if (const auto* flat = std::get_if<FlatObject>(&found)) {
    return run.end_flat(flat->name, flat->reason);
  }
  auto& objects = std::get<std::vector<FoundObject<InnerResult>>>(found);
  if (!options.exact_values) {
    for (auto& object : objects) {
      object.result.input_volume.exact.reset();
      object.result.output_volume.exact.reset();
    }
  }
  OutputFiles files =
      run.log().run("write", StageKind::Io, [&] { return files_of(objects, options.output); });
  return run.end({[&] { return document_of(objects); },
                  [&] { return summary_of(objects, options.output); }, std::move(files)});
}

}  // namespace convexact::cli
