// SPDX-License-Identifier: MIT
// convexact simplify: the main job.
#include <memory>

#include "cli/keep_option.hpp"
#include "cli/outputs.hpp"
#include "convexact/scene.hpp"
#include "io/json.hpp"
#include "scene/result_json.hpp"
#include "simplify/trace_json.hpp"

namespace convexact::cli {
namespace {

constexpr const char* kSimplifyFooter =
    "Examples:\n"
    "  convexact simplify bunny.obj --faces 18 -o proxy.obj --picture proxy.html\n"
    "  convexact simplify bunny.obj --max-growth 5% -o planes.json --precision 64\n"
    "  convexact simplify bunny.obj --max-growth 5% --growth-of area -o proxy.obj\n"
    "  convexact simplify bunny.obj --faces 18 --cost area -o fewer-ray-hits.obj\n"
    "  convexact simplify bunny.obj --faces 18 --cost mean-width --tie-bits 8192\n"
    "  convexact simplify hammer.obj --faces 12 --keep normal:0,0,-1 --keep group:head -o "
    "proxy.obj\n"
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
  std::vector<std::string> keep;
  std::string max_growth;
  std::optional<CostMeasure> growth_of;
  CostMeasure cost = CostMeasure::Volume;
  long tie_bits = CompareLimits{}.bits;
  std::string center = "chebyshev";
  Engine engine = Engine::Filtered;
  VerifyLevel verify = VerifyLevel::Local;
  bool exact_values = false;
};

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
  if (!options.max_growth.empty())
    request.max_growth = parse_share("--max-growth", options.max_growth);
  if (options.growth_of) {
    if (!request.max_growth) {
      throw Error(ErrorCode::InvalidArgument,
                  "--growth-of says what --max-growth limits: give --max-growth as well");
    }
    request.growth_of = options.growth_of;
  }
  request.cost = options.cost;
  request.compare.bits = options.tie_bits;
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

std::string answer_of(const std::vector<FoundObject<SimplifyResult>>& objects,
                      const std::vector<Stage>& stages, const SimplifyArguments& options) {
  if (options.global.json) {
    nlohmann::ordered_json document =
        objects.size() == 1
            ? result_json(objects[0].result)
            : nlohmann::ordered_json{{"objects", objects_json(objects, result_json)}};
    document["stages"] = stages_json(stages);
    return write_json(document, 2) + "\n";
  }
  std::string text;
  for (const auto& [source, result] : objects) text += source.name + "\n" + summary(result);
  text += written_lines(options.output);
  if (options.output.all_paths().empty()) {
    text += "  written     nothing; -o proxy.obj keeps the solid, --picture proxy.html shows it\n";
  }
  return text + stage_text(stages, options.global.stages);
}

int run_simplify(const SimplifyArguments& options) {
  const SimplifyRequest request = request_of(options);
  const auto requests = [&](const std::vector<SceneObject>& scene) {
    std::vector<SimplifyRequest> each(scene.size(), request);
    const auto keep = keep_selectors(options.keep, scene);
    for (std::size_t k = 0; k < scene.size(); ++k) each[k].keep = keep[k];
    return each;
  };
  return run_on_inputs<SimplifyResult>(
      options, requests, simplify,
      [&](const auto& objects, const auto& stages) { return answer_of(objects, stages, options); });
}

}  // namespace

void add_simplify_command(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<SimplifyArguments>();
  CLI::App& command = *program.add_subcommand("simplify",
                                              "enclose a shape in few halfspaces, adding as little "
                                              "volume as possible, or area, or mean width");
  command.footer(kSimplifyFooter);
  add_input_argument(command, options->inputs);
  add_faces(command, options->faces, "how many halfspaces to keep, at least 4");
  add_keep_option(command, options->keep);
  command.add_option("--max-growth", options->max_growth,
                     "stop before what --cost names grows by more, e.g. 5% or 0.05");
  add_choice(command, "--growth-of", options->growth_of, kCostMeasureNames,
             "what --max-growth limits, if not what --cost names");
  add_choice(command, "--cost", options->cost, kCostMeasureNames,
             "what the solid shall gain least of: for fewer false hits of points, of rays, or of "
             "planes");
  add_tie_bits(command, options->tie_bits,
               "mean widths that so many bits do not tell apart, and no proof, count as equal; the "
               "result says so");
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
  finish_command(command, options, exit_code, run_simplify);
  add_stages_option(command, options->global);
}

}  // namespace convexact::cli
