// SPDX-License-Identifier: MIT
#include <algorithm>
#include <nlohmann/json.hpp>

#include "convexact/format/trace_verdict.hpp"
#include "json_parts.hpp"
#include "words.hpp"

namespace convexact {
namespace {

using Json = nlohmann::ordered_json;

Json optional_json(const std::optional<std::size_t>& x) { return x ? Json(*x) : Json(nullptr); }

Json ids_json(const std::vector<HalfspaceId>& ids) {
  Json list = Json::array();
  for (const HalfspaceId id : ids) list.push_back(id.index());
  return list;
}

Json step_json(const JudgedStep& step, std::size_t number) {
  return {{"step", number},
          {"row", step.row},
          {"removed", step.removed.index()},
          {"cost", quantity_json(step.cost)},
          {"minimum", quantity_json(step.minimum)},
          {"tie", ids_json(step.tie)},
          {"regret", quantity_json(step.regret)}};
}

Json claim_json(const TraceClaim& claim) {
  Json json = {{"code", claim.code}, {"status", name_of(claim.status)}};
  if (!claim.witness) return json;
  const TraceWitness& witness = *claim.witness;
  json["witness"] = {{"step", optional_json(witness.step)},
                     {"row", optional_json(witness.row)},
                     {"found", witness.found},
                     {"expected", witness.expected}};
  return json;
}

Json notes_json(const TraceVerdict& verdict) {
  Json notes = Json::array();
  if (verdict.other_ties == 0) return notes;
  const auto first = std::find_if(verdict.steps.begin(), verdict.steps.end(),
                                  [](const JudgedStep& step) { return step.is_other_tie(); });
  notes.push_back({{"code", "tie-order"},
                   {"steps", verdict.other_ties},
                   {"first", first - verdict.steps.begin()}});
  return notes;
}

}  // namespace

Json trace_verdict_json(const TraceVerdict& verdict) {
  Json claims = Json::array(), steps = Json::array();
  for (const TraceClaim& claim : verdict.claims) claims.push_back(claim_json(claim));
  for (const JudgedStep& step : verdict.steps) steps.push_back(step_json(step, steps.size()));
  Json worst = nullptr;
  if (verdict.worst) {
    worst = {{"step", *verdict.worst},
             {"regret", quantity_json(verdict.steps[*verdict.worst].regret)}};
  }
  return {{"verdict", verdict_line(verdict)},
          {"rating", words::name_of(verdict.rating)},
          {"at", optional_json(verdict.at)},
          {"holds", verdict.holds()},
          {"max_regret", quantity_json(verdict.max_regret)},
          {"worst", worst},
          {"halfspaces", verdict.halfspaces.size()},
          {"removals", verdict.removals},
          {"judged", verdict.steps.size()},
          {"claims", claims},
          {"notes", notes_json(verdict)},
          {"steps", steps}};
}

}  // namespace convexact
