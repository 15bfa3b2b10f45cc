// SPDX-License-Identifier: MIT
#include "wire/scene_report.hpp"

#include <fmt/format.h>

#include "io/json.hpp"
#include "wire/simplify_report.hpp"
#include "wire/stage_report.hpp"
#include "wire/verdict_report.hpp"

namespace convexact {

Json scene_verdict_json(const SceneVerdict& verdict) {
  Json parts = Json::array();
  bool violated = verdict.gaps && verdict.gaps->witness;
  for (const PartVerdict& part : verdict.parts) {
    Json json = {{"part", part.part}, {"candidate_part", part.candidate}};
    json.update(verdict_json(part.verdict));
    json["stages"] = stages_json(part.verdict.stages);
    violated = violated || is_violated(part.verdict.claims);
    parts.push_back(std::move(json));
  }
  Json document = {{"verdict", verdict.holds() ? "holds"
                               : violated      ? "violated"
                                               : "undecided"},
                   {"parts", std::move(parts)}};
  if (!verdict.gaps) return document;
  const auto& [gaps, sentence, witness] = *verdict.gaps;
  Json& json = document["gaps"] = {
      {"code", "no-gaps"}, {"status", witness ? "violated" : "holds"}, {"sentence", sentence}};
  json.update(gaps_json(gaps));
  if (witness) {
    json["witness"] = {{"part", witness->part},
                       {"face", witness->face.face},
                       {"point", vector_json(witness->point)}};
    if (witness->plane) json["witness"]["plane"] = plane_json(*witness->plane);
  }
  return document;
}

std::string scene_verdict_text(const SceneVerdict& verdict) {
  std::string text;
  for (const PartVerdict& part : verdict.parts) {
    text += "part " + part.part + "\n" + verdict_table(part.verdict, true);
  }
  if (!verdict.gaps) return text;
  return text + fmt::format("all parts\n  {:<19} {:<15} {}\n", "no-gaps",
                            verdict.gaps->witness ? "violated" : "holds", verdict.gaps->sentence);
}

}  // namespace convexact
