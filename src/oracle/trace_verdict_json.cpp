// SPDX-License-Identifier: MIT
#include <algorithm>
#include <nlohmann/json.hpp>

#include "io/json.hpp"
#include "oracle/trace_verdict.hpp"

namespace convexact {
namespace {

using Json = nlohmann::ordered_json;

Json optional_json(const std::optional<std::size_t>& x) { return x ? Json(*x) : Json(nullptr); }

Json ids_json(const std::vector<HalfspaceId>& ids) {
  Json list = Json::array();
  for (const HalfspaceId id : ids) list.push_back(id.index());
  return list;
}

Json cost_json(const std::optional<Cost>& cost) {
  return cost ? quantity_json(cost->rational()) : Json(nullptr);
}

Json step_json(const JudgedStep& step, std::size_t number) {
  return {{"step", number},
          {"row", step.row},
          {"removed", step.removed.index()},
          {"cost", cost_json(step.cost)},
          {"minimum", cost_json(step.minimum)},
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

Json worst_json(std::optional<std::size_t> step, const std::optional<Rational>& regret) {
  if (!step) return nullptr;
  return {{"step", *step}, {"regret", quantity_json(regret)}};
}

Json notes_json(const TraceVerdict& verdict) {
  Json notes = Json::array();
  if (const auto& left_out = verdict.never_removed) {
    notes.push_back({{"code", "left-out"},
                     {"text", sentence(*left_out, verdict)},
                     {"facets", ids_json(left_out->facets)},
                     {"unlisted", left_out->unlisted},
                     {"steps", left_out->steps},
                     {"verdict", verdict_line(*left_out)},
                     {"rating", name_of(left_out->rating)},
                     {"at", optional_json(left_out->at)},
                     {"worst", worst_json(left_out->worst, left_out->worst_regret)}});
  }
  if (verdict.listed.rounded + verdict.listed.unknown > 0) {
    notes.push_back({{"code", "facet-list"},
                     {"text", sentence(verdict.listed)},
                     {"rounded", verdict.listed.rounded},
                     {"unknown", verdict.listed.unknown}});
  }
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
  const auto regret = verdict.worst ? verdict.steps[*verdict.worst].regret : std::nullopt;
  return {{"verdict", verdict_line(verdict)},
          {"rating", name_of(verdict.rating)},
          {"at", optional_json(verdict.at)},
          {"holds", verdict.holds()},
          {"max_regret", quantity_json(verdict.max_regret)},
          {"worst", worst_json(verdict.worst, regret)},
          {"left_out", ids_json(verdict.left_out)},
          {"halfspaces", verdict.halfspaces.size()},
          {"removals", verdict.removals},
          {"judged", verdict.steps.size()},
          {"claims", claims},
          {"notes", notes_json(verdict)},
          {"steps", steps}};
}

}  // namespace convexact
