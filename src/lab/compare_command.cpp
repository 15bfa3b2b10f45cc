// SPDX-License-Identifier: MIT
// convexact compare: solids of few planes, or inside of few vertices, by other methods, refitted
// and measured exactly.
#include <algorithm>
#include <memory>
#include <span>

#include "cli/outputs.hpp"
#include "cli/progress.hpp"
#include "convexact/scene.hpp"
#include "io/json.hpp"
#include "lab/commands.hpp"
#include "lab/compare/compare.hpp"

namespace convexact::cli {
namespace {

constexpr const char* kCompareFooter =
    "Examples:\n"
    "  convexact compare bunny.obj --faces 18\n"
    "  convexact compare bunny.obj spot.obj --faces 12 --methods greedy,mck,stl --csv out.csv\n"
    "  convexact compare bunny.obj --inner --vertices 32\n"
    "  convexact compare --list\n"
    "\n"
    "A method proposes directions. Each gets the plane that touches the hull, exactly; the solid\n"
    "is proven to be bounded and to hold every point. Volume, area and mean width are ratios to\n"
    "those of the hull; distance is the Hausdorff distance over the diameter of its box; seconds\n"
    "are those of the proposal. A method of more than K planes is shown and not ranked.\n"
    "With --inner a method proposes vertices of the hull; their own hull is proven to lie inside.";

struct CompareArguments {
  GlobalOptions global;
  std::vector<std::string> inputs;
  SceneOptions scene;
  std::string csv;
  bool list = false;
  CompareRequest request;
};

std::vector<const Method*> methods_named(const std::string& option, const std::string& text) {
  std::vector<const Method*> chosen;
  for (const std::string& word : words_of(text)) {
    const Method* found = nullptr;
    std::string names;
    for (const std::span<const Method> table : {methods(), inner_methods()}) {
      for (const Method& method : table) {
        names += (names.empty() ? "" : ",") + std::string(method.name);
        if (method.name == word) found = &method;
      }
    }
    if (found == nullptr) {
      throw Error(ErrorCode::InvalidArgument,
                  option + ": expected names out of " + names + ", found " + in_quotes(word));
    }
    if (std::find(chosen.begin(), chosen.end(), found) == chosen.end()) chosen.push_back(found);
  }
  return chosen;
}

void require_kind(const std::vector<const Method*>& chosen, bool inner) {
  for (const Method* method : chosen) {
    if (method->is_inner() == inner) continue;
    throw Error(ErrorCode::InvalidArgument,
                "--methods: " + in_quotes(std::string(method->name)) +
                    (inner ? " encloses the hull; --inner compares solids inside"
                           : " makes a solid inside; give --inner as well"));
  }
}

int run_compare(const CompareArguments& options) {
  if (options.list) {
    options.global.json ? print(methods_json()) : print(methods_text());
    return 0;
  }
  if (options.inputs.empty()) throw Error(ErrorCode::InvalidArgument, "INPUT is required");
  if (!options.csv.empty()) require_outputs({options.csv}, options.inputs);
  CompareRequest request = options.request;
  request.seed = options.global.seed;
  require_kind(request.methods, request.inner);
  if (request.methods.empty()) {
    for (const Method& method : request.inner ? inner_methods() : methods()) {
      request.methods.push_back(&method);
    }
  }
  Progress progress;
  request.watch = progress.watch();
  std::vector<MethodComparison> comparisons;
  for (const SceneObject& object : read_scene(options.inputs, options.scene)) {
    auto compared = compare_methods(object.name, object.shape, request);
    if (const auto* reason = std::get_if<NotSolid>(&compared)) {
      progress.clear();
      return report_not_solid(options.global, object.name, of_typed_rows(*reason, object.rows));
    }
    comparisons.push_back(std::get<MethodComparison>(std::move(compared)));
  }
  progress.clear();
  OutputFiles files;
  if (!options.csv.empty()) files.emplace_back(options.csv, compare_csv(comparisons));
  write_together(files, options.global.json
                            ? write_json(compare_json(comparisons, request), 2) + "\n"
                            : compare_text(comparisons));
  return 0;
}

}  // namespace

void add_compare_command(Command& program, int& exit_code) {
  auto options = std::make_shared<CompareArguments>();
  Command& command = *program.add_subcommand(kCompareCommand.name, kCompareCommand.description);
  command.footer(kCompareFooter);
  command.add_option("INPUT", options->inputs, "meshes or halfspaces");
  Option faces = add_faces(command, options->request.size, "planes of each solid, at least 4");
  Option inner = command.add_flag("--inner", options->request.inner,
                                  "compare solids inside the inputs, of few vertices");
  inner->excludes(faces);
  add_count(command, "--vertices", options->request.size, {4, std::uint64_t(1) << 32},
            "with --inner: vertices of each solid, at least 4")
      ->needs(inner);
  add_text(command, "--methods", "names between commas (default: all of the kind)",
           [options](const auto& option, const auto& text) {
             options->request.methods = methods_named(option, text);
           })
      ->type_name("NAME,...");
  command.add_flag("--list", options->list, "name every method with its source, and end");
  command.add_option("--csv", options->csv, "write a row for each input and method to this file");
  add_scene_options(command, options->scene);
  finish_command(command, options, exit_code, run_compare);
  command.get_option("--seed")->description("seed of the methods that choose at random");
}

}  // namespace convexact::cli
