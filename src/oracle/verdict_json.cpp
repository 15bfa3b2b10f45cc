// SPDX-License-Identifier: MIT
#include <algorithm>
#include <nlohmann/json.hpp>

#include "convexact/number.hpp"
#include "io/json.hpp"
#include "number/precision.hpp"
#include "oracle/verdict_text.hpp"
#include "scene/result_json.hpp"

namespace convexact {
namespace {

using Json = nlohmann::ordered_json;

std::string root_decimal(const Rational& squared) {
  return to_decimal(sqrt(Enclosure(squared, kMeasureBits)), kDigits).value_or("");
}

Json distance_json(const Rational& squared, const Rational& squared_diameter) {
  return {{"squared", to_string(squared)},
          {"decimal", root_decimal(squared)},
          {"relative", root_decimal(squared / squared_diameter)}};
}

Json witness_json(const Witness& w, const Rational& squared_diameter) {
  Json json = Json::object();
  if (w.input_point) json["input_point"] = *w.input_point;
  if (!w.vertices.empty()) json["vertices"] = w.vertices;
  if (!w.faces.empty()) json["faces"] = w.faces;
  if (!w.rows.empty()) json["rows"] = w.rows;
  if (w.line) json["line"] = *w.line;
  if (w.plane) json["plane"] = plane_json(*w.plane);
  if (w.point) json["point"] = vector_json(*w.point);
  if (w.nearest) json["nearest"] = vector_json(*w.nearest);
  if (w.direction) json["direction"] = vector_json(*w.direction);
  if (w.squared_distance) json["distance"] = distance_json(*w.squared_distance, squared_diameter);
  if (w.count) json["count"] = *w.count;
  return json;
}

Json slack_json(const Slack& slack) {
  const bool is_own = slack.ulps_of_largest == 0;
  return {{"ulps", is_own ? 0.5 : slack.ulps_of_largest},
          {"of", is_own ? "each" : "largest"},
          {"numbers", slack.precision == Precision::Binary64 ? "binary64" : "binary32"}};
}

Json size_json(const CandidateSize& size) {
  Json json = {{"stored_faces", size.stored_faces}, {"stored_vertices", size.stored_vertices}};
  const auto add = [&](const char* key, std::optional<std::size_t> count) {
    if (count) json[key] = *count;
  };
  add("facets", size.facets);
  add("vertices", size.vertices);
  add("most_facet_vertices", size.most_facet_vertices);
  add("facets_as_meant", size.facets_as_meant);
  if (size.facets_as_meant) json["u"] = slack_json(size.slack);
  add("planes_of_the_input", size.planes_of_the_input);
  return json;
}

Json outside_json(const Outside& outside) {
  Json json = {{"points", outside.points}, {"tested", outside.tested}};
  if (outside.relative_squared_distance) {
    json["worst_relative"] = root_decimal(*outside.relative_squared_distance);
  }
  return json;
}

Json tightness_json(const Tightness& tightness, const Rational& squared_diameter) {
  return {{"volume_ratio", measured_json({tightness.volume_ratio, {}}, kDigits)},
          {"area_ratio", measured_json({tightness.area_ratio, {}}, kDigits)},
          {"mean_width_ratio", measured_json({tightness.mean_width_ratio, {}}, kDigits)},
          {"hausdorff", distance_json(tightness.squared_hausdorff, squared_diameter)}};
}

}  // namespace

Json claim_json(const Claim& claim, const Rational& squared_diameter) {
  Json json = {{"code", name_of(claim.code)}, {"status", name_of(claim.status)}};
  if (!claim.sentence.empty()) json["sentence"] = claim.sentence;
  Json witness = witness_json(claim.witness, squared_diameter);
  if (!witness.empty()) json["witness"] = std::move(witness);
  return json;
}

Json verdict_json(const Verdict& verdict) {
  Json claims = Json::array();
  for (const Claim& claim : verdict.claims) {
    claims.push_back(claim_json(claim, verdict.squared_diameter));
  }
  const bool is_violated =
      std::any_of(verdict.claims.begin(), verdict.claims.end(),
                  [](const Claim& claim) { return claim.status == Status::Violated; });
  Json json = {{"verdict", verdict.holds() ? "holds"
                           : is_violated   ? "violated"
                                           : "undecided"},
               {"claims", claims},
               {"candidate", size_json(verdict.size)}};
  if (verdict.outside) json["outside"] = outside_json(*verdict.outside);
  if (verdict.tightness) {
    json["tightness"] = tightness_json(*verdict.tightness, verdict.squared_diameter);
  }
  if (const auto& least = verdict.smallest_tolerance) {
    json["smallest_tolerance"] = {{"value", least->decimal}, {"rounding", least->is_rounding}};
  }
  if (!verdict.notes.empty()) json["notes"] = verdict.notes;
  return json;
}

}  // namespace convexact
