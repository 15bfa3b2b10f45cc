// SPDX-License-Identifier: MIT
#include "wire/stdio_request.hpp"

#include <nlohmann/json.hpp>

#include "convexact/error.hpp"
#include "convexact/number.hpp"
#include "convexact/verify.hpp"
#include "convexact/verify_parts.hpp"
#include "io/json.hpp"
#include "io/json_text.hpp"
#include "io/used_points.hpp"
#include "number/text.hpp"
#include "scene/time_limit.hpp"
#include "wire/json_mesh.hpp"
#include "wire/judge_fields.hpp"
#include "wire/parts_verdict.hpp"
#include "wire/request_line.hpp"
#include "wire/verdict_report.hpp"

namespace convexact {
namespace {

using nlohmann::json;

// The oracle reports errors in the numbers of a candidate.
Candidate candidate(const json& object, Decimal decimal) {
  require_known_keys(object, {"planes", "vertices", "faces"}, "the candidate");
  if (object.contains("planes") == object.contains("vertices")) {
    reject_request("a candidate with 'planes', with 'vertices', or with 'parts'");
  }
  if (object.contains("planes") && object.contains("faces"))
    reject_request("faces with 'vertices' only");
  try {
    if (object.contains("planes")) {
      return halfspaces_of_json(object["planes"],
                                [&](const json& x) { return coefficient_of_json(x, decimal); });
    }
    return mesh_of_json(object, decimal);
  } catch (const Error& error) {
    return error;
  }
}

// The document of a decomposition or of a tree says more about itself and its parts than is judged.
CandidateParts candidate_parts(const json& object, Decimal decimal) {
  const bool has_tree = object.contains("hull_tree");
  const bool is_document = has_tree || object.contains("decomposition");
  if (!is_document) require_known_keys(object, {"parts"}, "a candidate with parts");
  if (!object["parts"].is_array()) reject_request("the parts as an array");
  try {
    std::vector<NamedPart> parts;
    for (const json& part : object["parts"]) {
      if (!is_document) require_known_keys(part, {"name", "vertices", "faces"}, "a part");
      parts.push_back(part_of_json(part, parts.size(), decimal));
    }
    if (has_tree) return HullTree{std::move(parts), nodes_of_json(object["hull_tree"], decimal)};
    return parts;
  } catch (const Error& error) {
    return error;
  }
}

std::vector<ClaimCode> claims(const json& names) {
  if (!names.is_array()) reject_request("claims as an array of names");
  std::vector<ClaimCode> codes;
  for (const json& name : names) {
    const auto code = name.is_string() ? claim_of_name(name.get<std::string>()) : std::nullopt;
    if (!code) reject_request("the name of a claim, found " + in_quotes(dump_json(name)));
    codes.push_back(*code);
  }
  return codes;
}

VerifyRequest questions(const json& request) {
  VerifyRequest asked;
  asked.tightness = false;
  if (request.contains("claims")) asked.claims = claims(request["claims"]);
  const bool is_inner = flag_in(request, "inner").value_or(false);
  if (is_inner) asked.asks = Asks::Inner;
  if (request.contains("tolerance") && !request["tolerance"].is_string()) {
    reject_request("the tolerance as a string, such as \"1e-9d\"");
  }
  read_fields(request, bound_fields(verify_fields(), asked));
  if (is_inner && asked.asks != Asks::Inner) reject_request("inner with asks inner only");
  if (request.contains("exact_facets") && !request.contains("max_facets")) {
    reject_request("exact_facets with max_facets only");
  }
  return asked;
}

// The same questions about parts, and how many parts there may be.
PartsRequest questions_to_parts(const json& request) {
  for (const char* key : {"inner", "asks"}) {
    if (request.contains(key)) reject_request(std::string(key) + " with a single solid only");
  }
  PartsRequest asked = parts_request(questions(request));
  read_fields(request, bound_fields(parts_fields(), asked));
  if (asked.exact_volumes && asked.measures == PartMeasures::None)
    reject_request("exact_volumes with tightness only");
  return asked;
}

Json answer_about_parts(const json& request, PointSet points, Decimal decimal,
                        std::optional<double> seconds) {
  PartsRequest asked = questions_to_parts(request);
  Mesh input{std::move(points), {}, {}};
  if (request.contains("triangles")) {
    input.polygons = polygons_of_json(request["triangles"], input.points.size());
  }
  const CandidateParts parts = candidate_parts(request["candidate"], decimal);
  PartsVerdict verdict = in_time(seconds, "verdict", [&](const StageWatch& watch) {
    asked.watch = watch;
    return verify_parts(input, parts, asked);
  });
  std::erase_if(verdict.claims, [](const Claim& c) { return c.status == Status::NotAsked; });
  return parts_verdict_json(verdict);
}

// The input as it is drawn, from what verify() has read.
SceneObject drawn_input(const json& request, PointSet points) {
  const std::string name = word_in(request, "name").value_or("input");
  SceneObject input{.name = name, .part = name, .shape = PointSet(), .polygons = {}};
  if (request.contains("triangles")) {
    input.polygons = polygons_of_json(request["triangles"], points.size());
  }
  input.shape = std::move(points);
  return input;
}

Json answer(const json& request, std::optional<double> time_limit, const VerdictPicture& picture) {
  VerifyRequest unused;
  PartsRequest of_parts;
  BoundFields fields = bound_fields(verify_fields(), unused);
  for (BoundField& field : bound_fields(parts_fields(), of_parts))
    fields.push_back(std::move(field));
  require_known_keys(request,
                     {"id", "points", "candidate", "claims", "decimal", "numbers", "inner",
                      "time_limit", "triangles", "name", "picture"},
                     "the request", fields);
  if (!request.contains("points") || !request.contains("candidate")) {
    reject_request("a request with 'points' and 'candidate'");
  }
  const Decimal decimal = decimal_of(request);
  VerifyRequest asked = questions(request);
  PointSet input = points_of_request(request, decimal);
  const std::optional<double> seconds = time_limit_of(request, time_limit);
  const bool is_drawn = flag_in(request, "picture").value_or(false);
  if (is_drawn && !picture) reject_request("no picture here");
  if (request["candidate"].is_object() && request["candidate"].contains("parts")) {
    if (is_drawn) reject_request("picture with a single solid only");
    return answer_about_parts(request, std::move(input), decimal, seconds);
  }
  for (const Field<PartsRequest>& field : parts_fields()) {
    if (request.contains(field.name))
      reject_request(field.name + " with a candidate that has 'parts' only");
  }
  if (request.contains("triangles")) {
    asked.used = used_points(input.size(), polygons_of_json(request["triangles"], input.size()));
  }
  const Candidate judged = candidate(request["candidate"], decimal);
  VerifyOutcome outcome = in_time(seconds, "verdict", [&](const StageWatch& watch) {
    asked.watch = watch;
    return verify(input, judged, asked);
  });
  if (auto* verdict = std::get_if<Verdict>(&outcome)) {
    std::erase_if(verdict->claims, [](const Claim& c) { return c.status == Status::NotAsked; });
    Json answer = verdict_json(*verdict);
    if (is_drawn)
      answer["picture"] = picture(drawn_input(request, std::move(input)), judged, *verdict);
    return answer;
  }
  return not_solid_answer(std::get<NotSolid>(outcome));
}

}  // namespace

std::string answer_request(std::string_view line, std::optional<double> time_limit,
                           const VerdictPicture& picture) {
  return answer_line(line, {"id", "points", "planes", "vertices"}, [&](const json& request) {
    return write_json(answer(request, time_limit, picture));
  });
}

}  // namespace convexact
