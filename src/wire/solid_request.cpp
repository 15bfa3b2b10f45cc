// SPDX-License-Identifier: MIT
#include "wire/solid_request.hpp"

#include <nlohmann/json.hpp>

#include "io/json.hpp"
#include "io/json_text.hpp"
#include "number/text.hpp"
#include "proof/proof.hpp"
#include "scene/objects.hpp"
#include "scene/time_limit.hpp"
#include "wire/request_line.hpp"
#include "wire/result_files.hpp"
#include "wire/simplify_options.hpp"
#include "wire/simplify_report.hpp"

namespace convexact {
namespace {

using nlohmann::json;

SceneObject input_of(const json& request) {
  if (request.contains("points") == request.contains("planes")) {
    reject_request("a request with 'points' or with 'planes'");
  }
  const Decimal decimal = decimal_of(request);
  const std::string name = word_in(request, "name").value_or("input");
  if (request.contains("planes")) {
    if (request.contains("triangles")) reject_request("triangles with 'points' only");
    return halfspace_object(name, halfspaces_of_json(request["planes"], [&](const json& x) {
                              return coefficient_of_json(x, decimal);
                            }));
  }
  SceneObject input{.name = name, .part = name, .shape = PointSet(), .polygons = {}};
  PointSet points = points_of_request(request, decimal);
  if (request.contains("triangles")) {
    input.polygons = polygons_of_json(request["triangles"], points.size());
  }
  input.shape = std::move(points);
  return input;
}

std::vector<std::string> files_in(const json& request) {
  std::vector<std::string> names;
  for (const json& name : request.value("files", json::array())) {
    if (!name.is_string() || !is_result_file(name.get<std::string>())) {
      reject_request(
          "files as names that end in .obj, .off, .ply, .xyz, .json, .ine, .txt or "
          ".proof, found " +
          in_quotes(dump_json(name)));
    }
    names.push_back(name.get<std::string>());
  }
  return names;
}

int precision_in(const json& request) {
  const std::size_t bits = count_in(request, "precision").value_or(0);
  if (request.contains("precision") && bits != 64 && bits != 32) {
    reject_request("precision as 64 or 32");
  }
  return static_cast<int>(bits);
}

bool HullRequest::*measure_of(const json& name) {
  const auto measure =
      name.is_string() ? value_in(kHullMeasureNames, name.get<std::string>()) : std::nullopt;
  if (!measure) {
    reject_request("measures out of volume, area, mean-width and inertia, found " +
                   in_quotes(dump_json(name)));
  }
  return *measure;
}

void read_hull_options(const json& request, HullRequest& wanted) {
  require_known_keys(
      request,
      {"id", "name", "points", "planes", "triangles", "decimal", "numbers", "time_limit", "files",
       "precision", "picture", "seed", "digits", "measures", "exact_values"},
      "the request");
  if (const auto digits = count_in(request, "digits")) {
    if (*digits < 1 || *digits > 10000) reject_request("digits from 1 to 10000");
    wanted.digits = static_cast<int>(*digits);
  }
  if (request.contains("measures")) {
    if (!request["measures"].is_array()) reject_request("measures as an array of names");
    wanted.volume = wanted.area = wanted.mean_width = false;
    for (const json& name : request["measures"]) wanted.*measure_of(name) = true;
  }
  wanted.exact_volume = flag_in(request, "exact_values").value_or(false);
  if (wanted.exact_volume && !wanted.volume) {
    reject_request("exact_values with the volume among the measures");
  }
}

void read_simplify_options(const json& request, SimplifyRequest& wanted) {
  GivenFields given;
  const BoundFields fields = given.bound(simplify_fields());
  require_known_keys(request,
                     {"id", "name", "points", "planes", "triangles", "decimal", "numbers",
                      "time_limit", "files", "precision", "picture", "seed", "exact_values"},
                     "the request", fields);
  read_fields(request, fields);
  wanted = simplify_request(given);
  wanted.exact_volumes = flag_in(request, "exact_values").value_or(false);
}

Json files_json(const std::vector<std::string>& names, const SceneObject& input,
                const SimplifyResult& result) {
  Json files = Json::object();
  for (const std::string& name : names) {
    if (is_proof(name)) {
      files[name] =
          write_proof(*result.start, *result.run, result.solid.points, result.solid.planes);
    } else {
      const NamedSolid solid{input.part, &result.solid};
      files[name] = proven_bytes({&solid, 1}, name);
    }
  }
  return files;
}

Json files_json(const std::vector<std::string>& names, const SceneObject& input,
                const HullResult& result) {
  Json files = Json::object();
  const NamedSolid solid{input.part, &result.solid};
  for (const std::string& name : names) {
    if (is_proof(name)) reject_request("a proof of removals only");
    files[name] = proven_bytes({&solid, 1}, name);
  }
  return files;
}

// What both kinds of requests do. `find` makes the result, `report` its document.
template <class Result, class Request, class Find, class Report>
std::string answer_of(const json& request, std::optional<double> time_limit, Request wanted,
                      const PictureOf<Result>& picture, const Find& find, const Report& report) {
  const std::vector<std::string> files = files_in(request);
  const bool is_drawn = flag_in(request, "picture").value_or(false);
  if (is_drawn && !picture) reject_request("no picture here");
  if (request.contains("seed")) wanted.seed = *count_in(request, "seed");
  wanted.store = store_request_for(files, precision_in(request));
  if constexpr (requires { wanted.record; }) wanted.record = needs_record(files);
  const SceneObject input = input_of(request);
  return in_time(time_limit_of(request, time_limit), "result", [&](const StageWatch& watch) {
    wanted.watch = watch;
    std::variant<Result, NotSolid> outcome = find(input.shape, wanted);
    if (const auto* reason = std::get_if<NotSolid>(&outcome)) {
      return write_json(not_solid_answer(of_typed_rows(*reason, input.rows)));
    }
    auto& result = std::get<Result>(outcome);
    result.redundant = to_typed_rows(std::move(result.redundant), input.rows);
    Json answer = report(result, wanted);
    if (request.contains("files")) answer["files"] = files_json(files, input, result);
    if (is_drawn) answer["picture"] = picture(input, result);
    return write_json(answer);
  });
}

std::string answer_solid_line(std::string_view line,
                              const std::function<std::string(const json& request)>& answer) {
  return answer_line(line, {"id", "points", "planes", "max_growth", "center"}, answer);
}

}  // namespace

std::string answer_hull_request(std::string_view line, std::optional<double> time_limit,
                                const PictureOf<HullResult>& picture) {
  return answer_solid_line(line, [&](const json& request) {
    HullRequest wanted;
    read_hull_options(request, wanted);
    return answer_of<HullResult>(request, time_limit, wanted, picture, measure_hull,
                                 [](const HullResult& result, const HullRequest& asked) {
                                   return hull_json(result, asked.digits);
                                 });
  });
}

std::string answer_simplify_request(std::string_view line, std::optional<double> time_limit,
                                    const PictureOf<SimplifyResult>& picture) {
  return answer_solid_line(line, [&](const json& request) {
    SimplifyRequest wanted;
    read_simplify_options(request, wanted);
    return answer_of<SimplifyResult>(
        request, time_limit, wanted, picture, simplify,
        [](const SimplifyResult& result, const SimplifyRequest&) { return result_json(result); });
  });
}

}  // namespace convexact
