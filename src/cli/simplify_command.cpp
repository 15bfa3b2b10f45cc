// SPDX-License-Identifier: MIT
// convexact simplify: the main job.
#include <fmt/format.h>

#include <memory>

#include "cli/inner_run.hpp"
#include "cli/outputs.hpp"
#include "convexact/scene.hpp"
#include "convexact/simplify.hpp"
#include "io/json.hpp"
#include "wire/keep_selectors.hpp"
#include "wire/simplify_options.hpp"
#include "wire/simplify_report.hpp"
#include "wire/stage_report.hpp"

namespace convexact::cli {
namespace {

constexpr const char* kSimplifyFooter =
    "Examples:\n"
    "  convexact simplify bunny.obj --faces 18 -o proxy.obj --picture proxy.html\n"
    "  convexact simplify bunny.obj --max-growth 5% -o planes.json --precision 64\n"
    "  convexact simplify bunny.obj --max-growth 5% --growth-of area -o proxy.obj\n"
    "  convexact simplify bunny.obj --faces 18 --cost area -o fewer-ray-hits.obj\n"
    "  convexact simplify bunny.obj --faces 18 --cost mean-width --tie-bits 8192\n"
    "  convexact simplify bunny.obj --faces 18 --search local --moves 1000 -o tighter.obj\n"
    "  convexact simplify crystal.obj --faces 6 --search optimal -o tightest.obj\n"
    "  convexact simplify hammer.obj --faces 12 --keep normal:0,0,-1 --keep group:head -o "
    "proxy.obj\n"
    "  convexact simplify room.obj --parts --faces 12 -o proxies.obj\n"
    "  convexact simplify room.obj --parts --total-faces 144 -o proxies.obj\n"
    "  convexact simplify planes.ine --faces 6 --json --trace steps.json\n"
    "  convexact simplify bunny.obj --inner --vertices 32 -o inside.obj\n"
    "  convexact simplify --implicit capsule.json --box -2,-2,-2,4 --depth 7 --faces 18\n"
    "\n"
    "Without --precision, planes are written as exact integers and meshes in binary64 (STL: 32).\n"
    "Every result that is written was tested, on the stored numbers, to hold every input point;\n"
    "those of --inner, to lie inside the hull of the input.";

// --total-faces is for several parts. How many there are, the files say.
void require_scene(const SimplifyArguments& options, const SimplifyRequest& request) {
  const auto reject = [](const std::string& why) {
    throw Error(ErrorCode::InvalidArgument, "--total-faces " + why);
  };
  if (request.faces) reject("is for all parts together and --faces for each: name one");
  if (!options.scene.parts && options.inputs.size() < 2) {
    reject("is for several parts: give --parts, or several inputs");
  }
  if (request.center) reject("has a center for each part: leave --center out");
  if (request.search.kind != SearchKind::None) {
    reject("distributes halfspaces by removals: give --faces for each part to --search");
  }
}

SimplifyRequest request_of(const SimplifyArguments& options) {
  SimplifyRequest request = simplify_request(options.given);
  if (options.total_faces) require_scene(options, request);
  request.exact_volumes = options.exact_values;
  request.trace = !options.output.trace.empty();
  request.record = !options.output.proof.empty();
  request.seed = options.global.seed;
  request.store = options.output.store_request();
  return request;
}

using FoundSolids = std::vector<FoundObject<SimplifyResult>>;

/// The results for all objects of a scene together.
struct FoundTotals {
  SceneTotals totals;
  Gaps gaps;
};

Json document_of(const FoundSolids& objects, const std::optional<FoundTotals>& together,
                 const SimplifyArguments& options) {
  Json document = objects.size() == 1 && !together
                      ? result_json(objects[0].result)
                      : Json{{"objects", objects_json(objects, result_json)}};
  if (options.implicit.is_given()) document["implicit"] = implicit_json(*options.implicit.found);
  if (together) document["total"] = totals_json(together->totals, together->gaps);
  return document;
}

std::string summary_of(const FoundSolids& objects, const std::optional<FoundTotals>& together,
                       const SimplifyArguments& options) {
  std::string text;
  for (const auto& [source, result] : objects)
    text += source.name + "\n" + summary(result, options.global.verbose);
  if (options.implicit.is_given()) text += implicit_summary(*options.implicit.found);
  if (together) text += summary(together->totals, together->gaps);
  text += written_lines(options.output);
  if (options.output.all_paths().empty()) {
    text += "  written     nothing; -o proxy.obj keeps the solid, --picture proxy.html shows it\n";
  }
  return text;
}

CommandAnswer answer_of(const FoundSolids& objects, const std::optional<FoundTotals>& together,
                        const SimplifyArguments& options) {
  return {[&] { return document_of(objects, together, options); },
          [&] { return summary_of(objects, together, options); }};
}

int run_each(const SimplifyArguments& options, const SimplifyRequest& request) {
  const auto requests = [&](const std::vector<SceneObject>& scene) {
    std::vector<SimplifyRequest> each(scene.size(), request);
    const auto keep = keep_selectors("--keep", options.keep, scene);
    for (std::size_t k = 0; k < scene.size(); ++k) each[k].keep = keep[k];
    return each;
  };
  const std::optional<FoundTotals> none;
  // One search after another, as an interrupt ends the one that is going on with the best so far.
  const auto jobs = request.search.kind == SearchKind::None ? request.jobs : 1;
  return run_on_inputs<SimplifyResult>(options, jobs, requests, simplify, [&](const auto& objects) {
    return answer_of(objects, none, options);
  });
}

// The parts of a scene with one budget, and their gaps.
std::variant<FoundSolids, FlatObject> simplify_together(std::vector<SceneObject> scene,
                                                        const SceneRequest& request, StageLog& log,
                                                        std::optional<FoundTotals>& together) {
  std::vector<Shape> shapes;
  for (SceneObject& object : scene) shapes.push_back(std::move(object.shape));
  SceneOutcome outcome = simplify_scene(shapes, request);
  for (std::size_t k = 0; k < scene.size(); ++k) scene[k].shape = std::move(shapes[k]);
  if (const auto* flat = std::get_if<NotSolidPart>(&outcome)) {
    const SceneObject& object = scene[flat->part];
    return FlatObject{object.name, of_typed_rows(flat->reason, object.rows)};
  }
  auto& result = std::get<SceneResult>(outcome);
  together.emplace();
  together->gaps = log.run("gaps", [&] {
    std::vector<std::vector<Halfspace>> solids;
    for (const SimplifyResult& part : result.parts) solids.push_back(part.solid.exact.planes);
    return find_gaps(scene, solids, request.each.watch.stop);
  });
  FoundSolids found;
  for (std::size_t k = 0; k < scene.size(); ++k) {
    log.add(result.parts[k].stages);
    found.push_back({std::move(scene[k]), std::move(result.parts[k])});
  }
  log.add(result.stages);
  together->totals = std::move(static_cast<SceneTotals&>(result));
  return found;
}

int run_together(const SimplifyArguments& options, const SimplifyRequest& each) {
  std::optional<FoundTotals> together;
  const auto find = [&](std::vector<SceneObject> scene, StageLog& log, const StageWatch& watch) {
    if (*options.total_faces / 4 < scene.size()) {
      throw Error(ErrorCode::InvalidArgument,
                  fmt::format("--total-faces {}: {} parts need 4 each, so at least {}",
                              *options.total_faces, scene.size(), 4 * scene.size()));
    }
    SceneRequest request{each, *options.total_faces, keep_selectors("--keep", options.keep, scene)};
    request.each.watch = watch;
    return simplify_together(std::move(scene), request, log, together);
  };
  return run_on_scene<SimplifyResult>(
      options, find, [&](const auto& objects) { return answer_of(objects, together, options); });
}

// The corners of cells have no parts, and a hull inside theirs says nothing about the shape.
void require_plain(const SimplifyArguments& options) {
  options.implicit.require_complete(options.inputs);
  if (!options.implicit.is_given()) return;
  require_outputs(options.output.all_paths(), {options.implicit.file});
  const char* option = options.inner         ? "--inner"
                       : options.scene.parts ? "--parts"
                       : options.total_faces ? "--total-faces"
                                             : nullptr;
  if (option == nullptr) return;
  throw Error(ErrorCode::InvalidArgument,
              std::string(option) + " is for meshes: leave it out with --implicit");
}

int run_simplify(const SimplifyArguments& options) {
  options.stdio.require_sensible();
  if (options.stdio.is_asked) return answer_lines(options.stdio, "simplify");
  require_plain(options);
  require_inner(options);
  if (options.inner) return run_inner(options);
  const SimplifyRequest request = request_of(options);
  return options.total_faces ? run_together(options, request) : run_each(options, request);
}

}  // namespace

void add_simplify_command(Command& program, int& exit_code) {
  auto options = std::make_shared<SimplifyArguments>();
  Command& command = *program.add_subcommand("simplify",
                                             "enclose a shape in few halfspaces, adding as little "
                                             "volume as possible, or area, or mean width");
  command.footer(kSimplifyFooter);
  add_input_argument(command, options->inputs);
  const SimplifyRequest usual;
  const auto add_options = [&](const std::vector<std::string_view>& names) {
    add_fields(command, options->given.bound(simplify_fields(), names, &usual));
  };
  add_options({"faces"});
  add_count(command, "--total-faces", options->total_faces, {4, std::uint64_t(1) << 32},
            "how many halfspaces to keep in all parts together, at least 4 for each: the cheapest "
            "removal of all parts goes first");
  add_keep_option(command, options->keep);
  add_options({"max_growth", "growth_of", "cost", "tie_bits"});
  add_output_options(command, options->output);
  command.add_option("--trace", options->output.trace,
                     "every step as JSON, for a program that replays it");
  command.add_option("--proof", options->output.proof,
                     "the run as a text that convexact-check proves again, independently");
  add_scene_options(command, options->scene);
  add_options({"engine", "search", "moves", "nodes", "verify", "center"});
  command.add_flag("--exact-values", options->exact_values,
                   "with --json: volumes as fractions too");
  add_options({"jobs"});
  add_inner_options(command, *options);
  add_implicit_options(command, options->implicit);
  add_stdio_options(command, options->stdio, "one result");
  finish_command(command, options, exit_code, run_simplify);
  add_verbose_option(command, options->global);
  command.show_first({"--faces", "--max-growth", "--cost", "--keep", "--output", "--picture",
                      "--precision", "--parts", "--engine", "--search", "--inner", "--vertices",
                      "--json"});
}

}  // namespace convexact::cli
