// SPDX-License-Identifier: MIT
// convexact simplify: the main job.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "cli/command.hpp"
#include "cli/outputs.hpp"
#include "cli/progress.hpp"
#include "cli/quantity_option.hpp"
#include "convexact/scene.hpp"
#include "io/json.hpp"
#include "scene/result_json.hpp"
#include "scene/stage_log.hpp"
#include "scene/summary.hpp"

namespace convexact::cli {
namespace {

constexpr const char* kSimplifyFooter =
    "Examples:\n"
    "  convexact simplify bunny.obj --faces 18 -o proxy.obj --picture proxy.html\n"
    "  convexact simplify bunny.obj --max-growth 5% -o planes.json --precision 64\n"
    "  convexact simplify room.obj --parts --faces 12 -o proxies.obj\n"
    "  convexact simplify planes.ine --faces 6 --json --trace steps.json\n"
    "\n"
    "Without --precision, planes are written as exact integers and meshes in binary64 (STL: 32).\n"
    "Every result that is written was tested, on the stored numbers, to hold every input point.";

struct SimplifyArguments {
  GlobalOptions global;
  std::vector<std::string> inputs;
  SceneOptions scene;
  OutputOptions output;
  std::size_t faces = 0;
  std::string max_growth;
  std::string center = "chebyshev";
  Engine engine = Engine::Filtered;
  VerifyLevel verify = VerifyLevel::Local;
  bool exact_values = false;
};

// "5%" or "0.05".
Rational parse_growth(std::string text) {
  const bool percent = !text.empty() && text.back() == '%';
  if (percent) text.pop_back();
  try {
    const Rational growth = parse_rational(text);
    return percent ? Rational(growth / 100) : growth;
  } catch (const Error&) {
    throw Error(ErrorCode::InvalidArgument,
                "--max-growth: expected a share such as 5% or 0.05, found '" + text + "'");
  }
}

// "chebyshev" or "X,Y,Z".
std::optional<RationalPoint> parse_center(const std::string& text) {
  if (text == "chebyshev") return std::nullopt;
  const std::vector<std::string> words = CLI::detail::split(text, ',');
  if (words.size() == 3) {
    try {
      return RationalPoint(parse_rational(words[0]), parse_rational(words[1]),
                           parse_rational(words[2]));
    } catch (const Error&) {  // told below
    }
  }
  throw Error(ErrorCode::InvalidArgument,
              "--center: expected chebyshev or three numbers X,Y,Z, found '" + text + "'");
}

SimplifyRequest request_of(const SimplifyArguments& options) {
  SimplifyRequest request;
  if (options.faces != 0) request.faces = options.faces;
  if (!options.max_growth.empty()) request.max_growth = parse_growth(options.max_growth);
  request.engine = options.engine;
  request.trace = !options.output.trace.empty();
  request.record = !options.output.proof.empty();
  request.verify = options.verify;
  request.center = parse_center(options.center);
  request.seed = options.global.seed;
  request.store = options.output.store_request();
  request.exact_volumes = options.exact_values;
  return request;
}

struct SimplifiedObject {
  SceneObject source;
  SimplifyResult result;
};

nlohmann::ordered_json document_of(const std::vector<SimplifiedObject>& objects,
                                   const StageLog& log) {
  if (objects.size() == 1) {
    nlohmann::ordered_json document = result_json(objects[0].result);
    document["stages"] = stages_json(log.stages());
    return document;
  }
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const SimplifiedObject& object : objects) {
    nlohmann::ordered_json entry = {{"name", object.source.name}};
    entry.update(result_json(object.result));
    entry["stages"] = stages_json(object.result.stages);
    list.push_back(entry);
  }
  return {{"objects", list}, {"stages", stages_json(log.stages())}};
}

std::string summary_of(const std::vector<SimplifiedObject>& objects, const StageLog& log,
                       const OutputOptions& output, bool lists_stages) {
  std::string text;
  for (const SimplifiedObject& object : objects) {
    text += object.source.name + "\n" + summary(object.result);
  }
  for (const std::string& path : output.all_paths())
    text += fmt::format("  written     {}\n", path);
  if (output.all_paths().empty()) {
    text += "  written     nothing; -o proxy.obj keeps the solid, --picture proxy.html shows it\n";
  }
  return text + stage_text(log.stages(), lists_stages);
}

OutputFiles files_of(const std::vector<SimplifiedObject>& objects, const OutputOptions& options) {
  std::vector<OutputObject> outputs;
  for (const SimplifiedObject& object : objects) {
    outputs.push_back({object.source, object.result.solid,
                       object.result.run ? &*object.result.run : nullptr,
                       object.result.start ? &*object.result.start : nullptr});
  }
  return output_files(outputs, options);
}

int run_simplify(const SimplifyArguments& options) {
  Progress progress;
  StageLog log(progress.watch());
  SimplifyRequest request = request_of(options);
  options.output.require_sensible();
  require_other_files(options.output.all_paths(), options.inputs);
  std::vector<SceneObject> scene =
      log.run("read", StageKind::Io, [&] { return read_scene(options.inputs, options.scene); });
  options.output.require_room_for(scene.size());
  request.watch = progress.watch();
  std::vector<SimplifiedObject> objects;
  for (SceneObject& source : scene) {
    SimplifyOutcome outcome = simplify(source.shape, request);
    if (const auto* reason = std::get_if<NotSolid>(&outcome)) {
      progress.clear();
      return report_not_solid(options.global, source.name, of_typed_rows(*reason, source.rows));
    }
    auto& result = std::get<SimplifyResult>(outcome);
    log.add(result.stages);
    to_typed_rows(result.redundant, source.rows);
    objects.push_back({std::move(source), std::move(result)});
  }
  const OutputFiles files =
      log.run("write", StageKind::Io, [&] { return files_of(objects, options.output); });
  progress.clear();
  const std::string text = options.global.json
                               ? write_json(document_of(objects, log), 2) + "\n"
                               : summary_of(objects, log, options.output, options.global.stages);
  write_together(files, text);
  return 0;
}

}  // namespace

void add_simplify_command(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<SimplifyArguments>();
  CLI::App& command = *program.add_subcommand(
      "simplify", "enclose a shape in few halfspaces, adding as little volume as possible");
  command.footer(kSimplifyFooter);
  add_input_argument(command, options->inputs);
  add_faces(command, options->faces, "how many halfspaces to keep, at least 4");
  command.add_option("--max-growth", options->max_growth,
                     "stop before the volume grows by more, e.g. 5% or 0.05");
  add_output_options(command, options->output);
  command.add_option("--trace", options->output.trace,
                     "every step as JSON, for a program that replays it");
  command.add_option("--proof", options->output.proof,
                     "the run as a text that convexact-check proves again, independently");
  add_scene_options(command, options->scene);
  add_choice(
      command, "--engine", options->engine, kEngineNames,
      "rationals everywhere; the same answer, faster; or doubles that choose, the result still "
      "proven");
  add_choice(command, "--verify", options->verify, kVerifyLevelNames,
             "what is proven again at each step");
  command
      .add_option("--center", options->center,
                  "of the polar dual: chebyshev, or X,Y,Z strictly inside; the answer does not "
                  "depend on it")
      ->capture_default_str();
  command.add_flag("--exact-values", options->exact_values,
                   "with --json: volumes as fractions too");
  add_global_options(command, options->global);
  add_stages_option(command, options->global);
  command.callback([options, &exit_code] {
    exit_code = run_guarded(options->global, [&] { return run_simplify(*options); });
  });
}

}  // namespace convexact::cli
