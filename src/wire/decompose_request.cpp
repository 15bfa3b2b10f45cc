// SPDX-License-Identifier: MIT
#include "wire/decompose_request.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "convexact/decompose.hpp"
#include "io/json.hpp"
#include "io/json_text.hpp"
#include "scene/time_limit.hpp"
#include "wire/decompose_options.hpp"
#include "wire/decompose_report.hpp"
#include "wire/request_line.hpp"
#include "wire/tree_report.hpp"
#include "wire/written_parts.hpp"

namespace convexact {
namespace {

using nlohmann::json;

// Each option by its name on the command line, with its meaning and default there; and those that
// stand for options of the whole command line or of its files.
DecomposeRequest decompose_request_of(const json& request) {
  DecomposeRequest wanted = default_decompose_request();
  const BoundFields fields = bound_fields(decompose_call_fields(), wanted);
  require_known_keys(request,
                     {"id", "points", "triangles", "decimal", "numbers", "time_limit", "tree_faces",
                      "name", "picture"},
                     "the request", fields);
  if (request.contains("seed") && !request["seed"].is_number_unsigned()) {
    reject_request("seed as a number from 0 to 2^64 - 1");
  }
  read_fields(request, fields);
  if (wanted.exact_volumes && wanted.measures == PartMeasures::None) {
    reject_request("exact_volumes or no_measures, not both");
  }
  return wanted;
}

// Line ends of a document are between its values only, as texts in JSON have none.
std::string on_one_line(std::string document) {
  std::erase(document, '\n');
  return document;
}

// With what --tree writes, if the request asks for it.
std::string answer_of(Decomposition made, const DecomposeRequest& request,
                      std::optional<std::size_t> tree_faces,
                      const std::function<std::string(const Decomposition&)>& page) {
  DecomposedObject object{"the request", std::move(made), {}, request};
  for (std::size_t k = 0; k < object.result.parts.size(); ++k) {
    object.part_names.push_back(fmt::format("part_{:03}", k));
  }
  const std::span objects(&object, 1);
  const auto document = decomposition_json(objects, DecompositionDetail::All);
  std::string line =
      on_one_line(proven_parts_json(document, written_parts(objects), "the answer", request.jobs));
  const auto add = [&line](const char* key, const std::string& value) {
    line.back() = ',';
    line += std::string("\"") + key + "\":" + value + "}";
  };
  if (request.for_tree) {
    const TreeOfParts tree = tree_of_parts(object, request, tree_faces, "the tree of the answer");
    add("tree_file", on_one_line(tree.file));
  }
  if (page) add("picture", write_json(page(object.result)));
  return line;
}

std::string decompose_answer(const json& request, std::optional<double> time_limit,
                             const DecompositionPicture& picture) {
  DecomposeRequest wanted = decompose_request_of(request);
  if (!request.contains("points") || !request.contains("triangles")) {
    reject_request("a request with 'points' and 'triangles'");
  }
  const std::optional<std::size_t> tree_faces = count_in(request, "tree_faces");
  if (tree_faces && !wanted.for_tree) reject_request("tree_faces with tree only");
  std::function<std::string(const Decomposition&)> page;
  if (flag_in(request, "picture").value_or(false)) {
    if (!picture) reject_request("no picture here");
    page = [&picture, name = word_in(request, "name").value_or("input")](const auto& parts) {
      return picture(name, parts);
    };
  }
  Mesh mesh{points_of_request(request, decimal_of(request)), {}, {}};
  mesh.polygons = polygons_of_json(request["triangles"], mesh.points.size());
  return in_time(
      time_limit_of(request, time_limit), "parts", [&](const StageWatch& watch) -> std::string {
        wanted.watch = watch;
        wanted = with_method(mesh, std::move(wanted));
        DecomposeOutcome outcome = decompose(mesh, wanted);
        if (const auto* reason = std::get_if<NotSolid>(&outcome)) {
          return write_json(not_solid_answer(*reason));
        }
        return answer_of(std::get<Decomposition>(std::move(outcome)), wanted, tree_faces, page);
      });
}

}  // namespace

std::string answer_decompose_request(std::string_view line, std::optional<double> time_limit,
                                     const DecompositionPicture& picture) {
  return answer_line(
      line, {"id", "points", "concavity", "distance", "coplanar"},
      [&](const json& request) { return decompose_answer(request, time_limit, picture); });
}

}  // namespace convexact
