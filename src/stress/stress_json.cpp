// SPDX-License-Identifier: MIT
#include <cmath>
#include <nlohmann/json.hpp>

#include "stress/stress_report.hpp"
#include "stress/words.hpp"

namespace convexact {
namespace {

using Json = nlohmann::ordered_json;

Json number_json(double x) { return std::isfinite(x) ? Json(x) : Json("infinite"); }

template <class Value>
Json optional_json(const std::optional<Value>& x) {
  if (!x) return nullptr;
  if constexpr (std::is_floating_point_v<Value>) {
    return number_json(*x);
  } else {
    return *x;
  }
}

Json stored_json(const StressStored& stored) {
  Json json = {{"form", words::name_of(stored.form)},
               {"precision", stored.precision == Precision::Binary64 ? 64 : 32},
               {"of", stored.whole ? "hull" : "result"},
               {"outcome", words::name_of(stored.outcome)}};
  if (stored.outcome != StressStored::Outcome::Refused) {
    json["violations"] = stored.violations;
    json["push"] = number_json(stored.push);
    json["volume_ratio"] = number_json(stored.volume_ratio);
  }
  if (!stored.why.empty()) json["why"] = stored.why;
  return json;
}

Json claim_json(const std::optional<StressClaim>& claim) {
  if (!claim) return nullptr;
  return {{"vouched", claim->vouched},
          {"cost", number_json(claim->cost)},
          {"regret", number_json(claim->regret)},
          {"doubtful", claim->doubtful},
          {"end_proven", claim->end_proven}};
}

Json run_json(const StressRun& run) {
  Json json = {{"family", run.family},
               {"parameter", run.parameter},
               {"value", run.value},
               {"seed", run.seed},
               {"engine", words::name_of(run.engine)},
               {"end", words::name_of(run.end)}};
  if (!run.why.empty()) json["why"] = run.why;
  json["input"] = run.input;
  json["halfspaces"] = run.at_start;
  json["steps"] = run.steps;
  json["compared"] = run.compared;
  json["seconds"] = run.seconds;
  json["memory"] = run.memory;
  json["volume_error"] = optional_json(run.volume_error);
  json["cost_error"] = optional_json(run.cost_error);
  json["first_difference"] = optional_json(run.first_difference);
  json["other_ties"] = run.other_ties;
  json["regret"] = optional_json(run.regret);
  json["claim"] = claim_json(run.claim);
  json["stored"] = Json::array();
  for (const StressStored& stored : run.stored) json["stored"].push_back(stored_json(stored));
  json["faults"] = run.faults;
  return json;
}

}  // namespace

nlohmann::ordered_json stress_json(const StressReport& report) {
  Json runs = Json::array();
  for (const StressRun& run : report.runs) runs.push_back(run_json(run));
  return {{"passes", report.passes()}, {"seconds", report.seconds}, {"runs", runs}};
}

}  // namespace convexact
