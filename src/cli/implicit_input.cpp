// SPDX-License-Identifier: MIT
#include "cli/implicit_input.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "cli/options.hpp"
#include "convexact/error.hpp"
#include "convexact/io.hpp"
#include "io/json.hpp"
#include "number/precision.hpp"

namespace convexact::cli {
namespace {

ImplicitBox parse_box(const std::string& option, const std::string& text) {
  const std::vector<std::string> words = words_of(text);
  if (words.size() != 4) {
    reject_argument(option + ": expected x0,y0,z0,edge, found " + in_quotes(text));
  }
  const auto number = [&](std::size_t k) { return parse_decimal(option, words[k]); };
  ImplicitBox box{{number(0), number(1), number(2)}, number(3)};
  if (!(box.edge > 0)) reject_argument(option + ": expected an edge above 0, found " + words[3]);
  return box;
}

double rounded_up(const Enclosure& x) { return x.high_double(); }

}  // namespace

void ImplicitOptions::require_complete(const std::vector<std::string>& inputs) const {
  if (!is_given()) {
    const char* option = box ? "--box" : depth ? "--depth" : nullptr;
    if (option != nullptr) {
      reject_argument(std::string(option) + " is for an implicit shape: give --implicit as well");
    }
    if (inputs.empty()) reject_argument("INPUT is required, or --implicit SHAPE.json");
    return;
  }
  if (!inputs.empty()) reject_argument("--implicit takes the place of INPUT: leave INPUT out");
  if (!box) reject_argument("--implicit needs --box x0,y0,z0,edge");
  if (!depth) reject_argument("--implicit needs --depth");
}

void add_implicit_options(Command& command, ImplicitOptions& options) {
  command.get_option("INPUT")->required(false);
  command.add_option("--implicit", options.file,
                     "an implicit shape (JSON) in the place of INPUT: the corners of all cells "
                     "that may hold its surface");
  add_text(command, "--box", "with --implicit: x0,y0,z0,edge of the cube that holds the shape",
           [&options](const std::string& option, const std::string& text) {
             options.box = parse_box(option, text);
           });
  add_count(command, "--depth", options.depth, {0, kMostImplicitDepth},
            "with --implicit: how often the cube is halved");
}

SceneObject read_implicit_object(const ImplicitOptions& options, const SceneOptions& scene,
                                 const Watch& watch) {
  const auto bytes = std::make_shared<const std::string>(read_bytes(options.file));
  if (scene.on_read) scene.on_read(display_name(options.file), bytes);
  try {
    const ImplicitShape shape = read_implicit_bytes(*bytes);
    *options.found = {shape.bounds(), kept_cells(shape, *options.box, *options.depth, watch),
                      closed_measures(shape, kMeasureBits)};
  } catch (const Error& error) {
    throw error.in_file(display_name(options.file));
  }
  const std::string stem = std::filesystem::path(display_name(options.file)).stem().string();
  return {.name = display_name(options.file),
          .part = stem,
          .shape = PointSet(options.found->cells.corners),
          .polygons = {}};
}

Json implicit_json(const ImplicitFound& found) {
  const ImplicitCells& cells = found.cells;
  Json levels = Json::array();
  for (const auto& [tested, kept, undecided] : cells.levels) {
    levels.push_back({{"tested", tested}, {"kept", kept}, {"undecided", undecided}});
  }
  Json json = {{"levels", levels},
               {"leaf_edge", cells.leaf_edge},
               {"corners", cells.corners.size()},
               {"lipschitz", to_string(found.bounds.lipschitz)}};
  if (!cells.distance) return json;
  json["tightness"] = to_string(*found.bounds.tightness);
  json["distance"] = *cells.distance;
  if (const auto& measures = found.measures) {
    const double bound = steiner_bound(*measures, *cells.distance);
    json["solid_volume"] = measured_json({measures->volume, {}}, kDigits);
    json["volume_bound"] = bound;
    json["ratio_bound"] =
        rounded_up(Enclosure(to_rational(bound), kMeasureBits) / measures->volume);
  }
  return json;
}

std::string implicit_summary(const ImplicitFound& found) {
  const ImplicitCells& cells = found.cells;
  std::string text = "  level      tested        kept\n";
  for (std::size_t level = 0; level < cells.levels.size(); ++level) {
    const auto& [tested, kept, undecided] = cells.levels[level];
    text +=
        fmt::format("  {:>5}{:>12}{:>12}", level, with_separators(tested), with_separators(kept));
    if (undecided > 0) text += fmt::format(", {} of them undecided", with_separators(undecided));
    text += "\n";
  }
  text += fmt::format("  {:<12}L = {}", "bounds", to_string(found.bounds.lipschitz));
  if (!cells.distance) {
    return text + "; tightness not known: the only claim is that the result holds the shape\n";
  }
  text += fmt::format(", tightness {}: no corner is farther than {:.6g} from the shape\n",
                      to_string(*found.bounds.tightness), *cells.distance);
  if (const auto& measures = found.measures) {
    const double bound = steiner_bound(*measures, *cells.distance);
    text +=
        fmt::format("  {:<12}{:.6g}; by Steiner's formula, that of the hull is at most {:.6g}\n",
                    "volume", to_double(measures->volume.low(), Rounding::Nearest), bound);
  }
  return text;
}

}  // namespace convexact::cli
