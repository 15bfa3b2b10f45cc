// SPDX-License-Identifier: MIT
#include "wire/solid_request.hpp"

#include <nlohmann/json.hpp>

#include "convexact/io.hpp"
#include "io/base64.hpp"
#include "io/json.hpp"
#include "io/json_text.hpp"
#include "number/text.hpp"
#include "proof/proof.hpp"
#include "scene/objects.hpp"
#include "scene/time_limit.hpp"
#include "task/parallel.hpp"
#include "wire/inner_report.hpp"
#include "wire/keep_selectors.hpp"
#include "wire/request_line.hpp"
#include "wire/result_files.hpp"
#include "wire/simplify_options.hpp"
#include "wire/simplify_report.hpp"
#include "wire/trace_json.hpp"

namespace convexact {
namespace {

using nlohmann::json;

// What an answer is to have besides its document.
struct Extras {
  std::vector<std::string> files;
  int precision = 0;  // 64 or 32; 0 if it is open
  bool picture = false;
  bool trace = false;
};

std::vector<std::string> files_in(const json& request) {
  return texts_in(
      request, "files",
      "files as names that end in .obj, .off, .ply, .stl, .glb, .xyz, .json, .ine, .txt or .proof",
      is_result_file);
}

int precision_in(const json& request) {
  const std::size_t bits = count_in(request, "precision").value_or(0);
  if (request.contains("precision") && bits != 64 && bits != 32) {
    reject_request("precision as 64 or 32");
  }
  return static_cast<int>(bits);
}

Extras extras_in(const json& request) {
  Extras extras{files_in(request), precision_in(request),
                flag_in(request, "picture").value_or(false),
                flag_in(request, "trace").value_or(false)};
  const std::string narrow = file_of_less_precision(extras.files, extras.precision);
  if (!narrow.empty()) {
    reject_request("precision 32 with " + narrow + ", which holds binary32 only, or no other mesh");
  }
  return extras;
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
       "precision", "picture", "seed", "digits", "measures", "exact_values", "jobs"},
      "the request");
  wanted.jobs = count_in(request, "jobs");
  if (wanted.jobs && (*wanted.jobs < 1 || *wanted.jobs > kMostThreads)) {
    reject_request("jobs from 1 to " + std::to_string(kMostThreads));
  }
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

// The options of simplify, with and without `inner`.
GivenFields simplify_options_in(const json& request) {
  GivenFields given;
  BoundFields fields = given.bound(simplify_fields());
  for (BoundField& field : given.bound(inner_fields(), fields_of_inner_runs())) {
    fields.push_back(std::move(field));
  }
  require_known_keys(
      request,
      {"id", "name", "points", "planes", "triangles", "decimal", "numbers", "time_limit", "files",
       "precision", "picture", "trace", "seed", "exact_values", "keep", "inner"},
      "the request", fields);
  read_fields(request, fields);
  return given;
}

std::vector<KeepSelector> keep_in(const json& request, const SceneObject& input) {
  // The points and triangles of a request are in no groups, and have no name.
  const auto is_selector = [](const std::string& text) {
    return text.starts_with("id:") || text.starts_with("plane:") || text.starts_with("normal:");
  };
  const std::vector<std::string> texts =
      texts_in(request, "keep",
               "keep as texts id:N,..., plane:NX,NY,NZ,D or normal:X,Y,Z[:DEGREES]", is_selector);
  return keep_selectors("keep", texts, std::span(&input, 1))[0];
}

std::string file_bytes(const std::string& name, const SceneObject& input,
                       const SimplifyResult& result) {
  if (is_proof(name)) {
    return write_proof(*result.start, *result.run, result.solid.points, result.solid.planes);
  }
  const NamedSolid solid{input.part, &result.solid};
  return proven_bytes({&solid, 1}, name);
}

std::string file_bytes(const std::string& name, const SceneObject& input,
                       const HullResult& result) {
  const NamedSolid solid{input.part, &result.solid};
  return proven_bytes({&solid, 1}, name);
}

std::string file_bytes(const std::string& name, const SceneObject& input,
                       const InnerResult& result) {
  const NamedInner solid{input.part, &result};
  return proven_inner_bytes({&solid, 1}, name);
}

// Without a place for bytes in JSON, those of STL and GLB are in base64.
template <class Result>
Json files_json(const std::vector<std::string>& names, const SceneObject& input,
                const Result& result) {
  Json files = Json::object();
  for (const std::string& name : names) {
    const std::string bytes = file_bytes(name, input, result);
    if (is_binary32_only(name)) {
      files[name] = {{"base64", to_base64(bytes)}};
    } else {
      files[name] = bytes;
    }
  }
  return files;
}

// The input, and under a watch its result and the answer. `find` makes the result from the shape
// and a watch, `report` its document.
template <class Result, class Find, class Report>
std::string answer_of(const json& request, std::optional<double> time_limit, const Extras& extras,
                      const SceneObject& input, const PictureOf<Result>& picture, const Find& find,
                      const Report& report) {
  return in_time(time_limit_of(request, time_limit), "result", [&](const StageWatch& watch) {
    std::variant<Result, NotSolid> outcome = find(watch);
    if (const auto* reason = std::get_if<NotSolid>(&outcome)) {
      return write_json(not_solid_answer(of_typed_rows(*reason, input.rows)));
    }
    auto& result = std::get<Result>(outcome);
    if constexpr (requires { result.redundant; }) {
      result.redundant = to_typed_rows(std::move(result.redundant), input.rows);
    }
    Json answer = report(result);
    if (request.contains("files")) answer["files"] = files_json(extras.files, input, result);
    if (extras.picture) answer["picture"] = picture(input, result);
    return write_json(answer);
  });
}

std::uint64_t seed_in(const json& request, std::uint64_t usual) {
  return count_in(request, "seed").value_or(usual);
}

std::string hull_answer(const json& request, std::optional<double> time_limit,
                        const PictureOf<HullResult>& picture) {
  HullRequest wanted;
  read_hull_options(request, wanted);
  const Extras extras = extras_in(request);
  if (extras.picture && !picture) reject_request("no picture here");
  if (needs_record(extras.files)) reject_request("a proof of removals only");
  wanted.seed = seed_in(request, wanted.seed);
  wanted.store = store_request_for(extras.files, extras.precision);
  const SceneObject input = shape_in_request(request);
  return answer_of<HullResult>(
      request, time_limit, extras, input, picture,
      [&](const StageWatch& watch) {
        wanted.watch = watch;
        return measure_hull(input.shape, wanted);
      },
      [&](const HullResult& result) { return hull_json(result, wanted.digits); });
}

std::string outer_answer(const json& request, std::optional<double> time_limit,
                         const GivenFields& given, const PictureOf<SimplifyResult>& picture) {
  SimplifyRequest wanted = simplify_request(given);
  const Extras extras = extras_in(request);
  if (extras.picture && !picture) reject_request("no picture here");
  wanted.exact_volumes = flag_in(request, "exact_values").value_or(false);
  wanted.seed = seed_in(request, wanted.seed);
  wanted.store = store_request_for(extras.files, extras.precision);
  wanted.record = needs_record(extras.files);
  wanted.trace = extras.trace;
  const SceneObject input = shape_in_request(request);
  wanted.keep = keep_in(request, input);
  return answer_of<SimplifyResult>(
      request, time_limit, extras, input, picture,
      [&](const StageWatch& watch) {
        wanted.watch = watch;
        return simplify(input.shape, wanted);
      },
      [&](const SimplifyResult& result) {
        Json answer = result_json(result);
        if (extras.trace) answer["trace"] = trace_json(*result.run);
        return answer;
      });
}

// What an inner run has not: see the options that inner_request() rejects.
void require_inner(const json& request, const Extras& extras) {
  if (request.contains("planes")) reject_request("points for an inner run");
  if (request.contains("keep")) reject_request("keep without inner only");
  if (request.contains("precision")) {
    reject_request("no precision with inner, whose vertices are those of the input, in binary64");
  }
  if (needs_record(extras.files)) reject_request("a proof of removals of halfspaces only");
}

std::string inner_answer(const json& request, std::optional<double> time_limit,
                         const GivenFields& given, const PictureOf<InnerResult>& picture) {
  InnerRequest wanted = inner_request(given);
  const Extras extras = extras_in(request);
  if (extras.picture && !picture) reject_request("no picture here");
  require_inner(request, extras);
  wanted.seed = seed_in(request, wanted.seed);
  wanted.costs = extras.trace;
  for (const std::string& name : extras.files) {
    wanted.mesh = wanted.mesh || mesh_format_of_path(name);
  }
  const SceneObject input = shape_in_request(request);
  return answer_of<InnerResult>(
      request, time_limit, extras, input, picture,
      [&](const StageWatch& watch) {
        wanted.watch = watch;
        return simplify_inner(std::get<PointSet>(input.shape), wanted);
      },
      [&](InnerResult& result) {
        if (!flag_in(request, "exact_values").value_or(false)) {
          result.input_volume.exact.reset();
          result.output_volume.exact.reset();
        }
        Json answer = inner_json(result);
        if (extras.trace) answer["trace"] = inner_trace_json(result.start, result.run);
        return answer;
      });
}

std::string answer_solid_line(std::string_view line,
                              const std::function<std::string(const json& request)>& answer) {
  return answer_line(line, {"id", "points", "planes", "max_growth", "max_loss", "center"}, answer);
}

}  // namespace

SceneObject shape_in_request(const json& request) {
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

std::string answer_hull_request(std::string_view line, std::optional<double> time_limit,
                                const PictureOf<HullResult>& picture) {
  return answer_solid_line(
      line, [&](const json& request) { return hull_answer(request, time_limit, picture); });
}

std::string answer_simplify_request(std::string_view line, std::optional<double> time_limit,
                                    const SimplifyPictures& pictures) {
  return answer_solid_line(line, [&](const json& request) {
    const GivenFields given = simplify_options_in(request);
    if (flag_in(request, "inner").value_or(false)) {
      return inner_answer(request, time_limit, given, pictures.inner);
    }
    for (const std::string_view name : fields_of_inner_runs()) {
      if (given.has(name)) reject_request(std::string(name) + " with inner only");
    }
    return outer_answer(request, time_limit, given, pictures.outer);
  });
}

}  // namespace convexact
