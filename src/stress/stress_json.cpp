// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include "convexact/error.hpp"
#include "io/json.hpp"
#include "simplify/run_names.hpp"
#include "simplify/trace_json.hpp"
#include "stress/answer.hpp"

namespace convexact {
namespace {

using Json = nlohmann::ordered_json;

constexpr auto kFormNames = name_table<StressStored::Form>(
    {{StressStored::Form::Planes, "planes"}, {StressStored::Form::Mesh, "mesh"}});
constexpr auto kOutcomeNames =
    name_table<StressStored::Outcome>({{StressStored::Outcome::Holds, "holds"},
                                       {StressStored::Outcome::Refused, "refused"},
                                       {StressStored::Outcome::Wrong, "wrong"}});

template <class E, std::size_t N>
E enumerator_in(const NameTable<E, N>& table, const Json& json) {
  const std::optional<E> value = value_in(table, json.get_ref<const std::string&>());
  if (!value) throw Error(ErrorCode::Malformed, "no name of an enumerator: " + json.dump());
  return *value;
}

// JSON has no infinity.
Json number_json(double x) { return std::isfinite(x) ? Json(x) : Json("infinite"); }

double number_in(const Json& json) {
  return json.is_string() ? std::numeric_limits<double>::infinity() : json.get<double>();
}

template <class Value>
Json optional_json(const std::optional<Value>& x) {
  if (!x) return nullptr;
  if constexpr (std::is_floating_point_v<Value>) {
    return number_json(*x);
  } else {
    return *x;
  }
}

template <class Value>
void take(std::optional<Value>& x, const Json& json) {
  if (json.is_null()) return;
  if constexpr (std::is_floating_point_v<Value>) {
    x = number_in(json);
  } else {
    x = json.get<Value>();
  }
}

Json stored_json(const StressStored& stored) {
  Json json = {{"form", name_in(kFormNames, stored.form)},
               {"precision", stored.precision == Precision::Binary64 ? 64 : 32},
               {"of", stored.whole ? "hull" : "result"},
               {"outcome", name_in(kOutcomeNames, stored.outcome)}};
  if (stored.outcome != StressStored::Outcome::Refused) {
    json["violations"] = stored.violations;
    json["push"] = number_json(stored.push);
    json["volume_ratio"] = number_json(stored.volume_ratio);
  }
  if (!stored.why.empty()) json["why"] = stored.why;
  return json;
}

StressStored stored_in(const Json& json) {
  StressStored stored;
  stored.form = enumerator_in(kFormNames, json.at("form"));
  stored.precision = json.at("precision") == 64 ? Precision::Binary64 : Precision::Binary32;
  stored.whole = json.at("of") == "hull";
  stored.outcome = enumerator_in(kOutcomeNames, json.at("outcome"));
  if (stored.outcome != StressStored::Outcome::Refused) {
    stored.violations = json.at("violations");
    stored.push = number_in(json.at("push"));
    stored.volume_ratio = number_in(json.at("volume_ratio"));
  }
  stored.why = json.value("why", "");
  return stored;
}

Json claim_json(const std::optional<StressClaim>& claim) {
  if (!claim) return nullptr;
  return {{"vouched", claim->vouched},
          {"cost", number_json(claim->cost)},
          {"regret", number_json(claim->regret)},
          {"doubtful", claim->doubtful},
          {"end_proven", claim->end_proven}};
}

std::optional<StressClaim> claim_in(const Json& json) {
  if (json.is_null()) return std::nullopt;
  return StressClaim{.cost = number_in(json.at("cost")),
                     .regret = number_in(json.at("regret")),
                     .doubtful = json.at("doubtful"),
                     .end_proven = json.at("end_proven"),
                     .vouched = json.at("vouched")};
}

Json volume_json(const ReportedVolume& volume) {
  return {optional_json(volume.low), optional_json(volume.high)};
}

ReportedVolume volume_in(const Json& json) {
  ReportedVolume volume;
  take(volume.low, json.at(0));
  take(volume.high, json.at(1));
  return volume;
}

Json steps_json(const std::vector<Step>& steps) {
  Json list = Json::array();
  for (const Step& step : steps) {
    const Json cost = step.cost ? cost_json(*step.cost) : Json(nullptr);
    list.push_back({{"removed", step.removed}, {"cost", cost}, {"tie", step.tie}});
  }
  return list;
}

Json lean_json(const std::vector<LeanStep>& steps) {
  Json list = Json::array();
  for (const LeanStep& step : steps) {
    list.push_back(
        {{"removed", step.removed}, {"cost", volume_json(step.cost)}, {"tied", step.tied}});
  }
  return list;
}

Json run_json(const StressRun& run) {
  Json json = {{"family", run.family}, {"parameter", run.parameter},    {"value", run.value},
               {"seed", run.seed},     {"engine", name_of(run.engine)}, {"end", name_of(run.end)}};
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
  if (run.undecided > 0) json["undecided"] = run.undecided;
  if (run.moves) json["moves"] = *run.moves;
  json["regret"] = optional_json(run.regret);
  json["claim"] = claim_json(run.claim);
  json["stored"] = Json::array();
  for (const StressStored& stored : run.stored) json["stored"].push_back(stored_json(stored));
  json["faults"] = run.faults;
  return json;
}

StressRun run_in(const Json& json) {
  StressRun run;
  run.family = json.at("family");
  run.parameter = json.at("parameter");
  run.value = json.at("value");
  run.seed = json.at("seed");
  run.engine = enumerator_in(kEngineNames, json.at("engine"));
  run.end = enumerator_in(kStressEndNames, json.at("end"));
  run.why = json.value("why", "");
  run.input = json.at("input");
  run.at_start = json.at("halfspaces");
  run.steps = json.at("steps");
  run.compared = json.at("compared");
  run.seconds = json.at("seconds");
  run.memory = json.at("memory");
  take(run.volume_error, json.at("volume_error"));
  take(run.cost_error, json.at("cost_error"));
  take(run.first_difference, json.at("first_difference"));
  run.other_ties = json.at("other_ties");
  run.undecided = json.value("undecided", std::size_t(0));
  if (json.contains("moves")) run.moves = json.at("moves").get<std::size_t>();
  take(run.regret, json.at("regret"));
  run.claim = claim_in(json.at("claim"));
  for (const Json& stored : json.at("stored")) run.stored.push_back(stored_in(stored));
  run.faults = json.at("faults");
  return run;
}

}  // namespace

Json stress_json(const StressReport& report) {
  Json runs = Json::array();
  for (const StressRun& run : report.runs) runs.push_back(run_json(run));
  Json json = {{"passes", report.passes()}, {"seconds", report.seconds}};
  if (report.cost != CostMeasure::Volume) json["cost"] = name_of(report.cost);
  json["runs"] = runs;
  return json;
}

std::vector<StressRun> stress_runs_in(const Json& json) {
  std::vector<StressRun> runs;
  for (const Json& run : json.at("runs")) runs.push_back(run_in(run));
  return runs;
}

Json search_json(const std::optional<SearchAnswer>& search) {
  if (!search) return nullptr;
  return {{"moves", moves_json(search->moves)}, {"left", search->left}};
}

std::optional<SearchAnswer> search_in(const Json& json, CostMeasure measure) {
  if (json.is_null()) return std::nullopt;
  SearchAnswer search;
  for (const Json& entry : json.at("moves")) {
    search.moves.push_back({entry.at("removed").get<std::vector<HalfspaceId>>(),
                            entry.at("inserted").get<std::vector<HalfspaceId>>(),
                            cost_in_json(nlohmann::json(entry.at("measure")), measure)});
  }
  search.left = json.at("left").get<std::vector<Halfspace>>();
  return search;
}

Json answer_json(const EngineAnswer& answer) {
  Json stored = Json::array();
  for (const StoredBytes& kept : answer.stored) {
    stored.push_back({{"stored", stored_json(kept.stored)}, {"bytes", kept.bytes}});
  }
  Json measure = nullptr;
  if (answer.measure) {
    measure = Json::array({volume_json((*answer.measure)[0]), volume_json((*answer.measure)[1])});
  }
  return {{"engine", name_of(answer.engine)},
          {"end", name_of(answer.end)},
          {"why", answer.why},
          {"cost", name_of(answer.run.measure)},
          {"measure", measure},
          {"halfspaces", answer.run.halfspaces},
          {"steps", steps_json(answer.run.steps)},
          {"lean", lean_json(answer.lean)},
          {"left", answer.left},
          {"input_volume", volume_json(answer.input_volume)},
          {"output_volume", volume_json(answer.output_volume)},
          {"claim", claim_json(answer.claim)},
          {"search", search_json(answer.search)},
          {"stored", stored},
          {"seconds", answer.seconds}};
}

EngineAnswer answer_in(const Json& json) {
  EngineAnswer answer;
  answer.engine = enumerator_in(kEngineNames, json.at("engine"));
  answer.end = enumerator_in(kStressEndNames, json.at("end"));
  answer.why = json.at("why");
  answer.run.measure = enumerator_in(kCostMeasureNames, json.at("cost"));
  if (const Json& measure = json.at("measure"); !measure.is_null()) {
    answer.measure = {volume_in(measure.at(0)), volume_in(measure.at(1))};
  }
  answer.run.halfspaces = json.at("halfspaces").get<std::vector<Halfspace>>();
  for (const Json& entry : json.at("steps")) {
    Step& step = answer.run.steps.emplace_back();
    step.removed = entry.at("removed").get<HalfspaceId>();
    step.cost = cost_in_json(nlohmann::json(entry.at("cost")), answer.run.measure);
    step.tie = entry.at("tie").get<std::vector<HalfspaceId>>();
  }
  for (const Json& entry : json.at("lean")) {
    answer.lean.push_back({.removed = entry.at("removed").get<HalfspaceId>(),
                           .cost = volume_in(entry.at("cost")),
                           .tied = entry.at("tied")});
  }
  answer.left = json.at("left").get<std::vector<Halfspace>>();
  answer.input_volume = volume_in(json.at("input_volume"));
  answer.output_volume = volume_in(json.at("output_volume"));
  answer.claim = claim_in(json.at("claim"));
  answer.search = search_in(json.at("search"), answer.run.measure);
  for (const Json& entry : json.at("stored")) {
    answer.stored.push_back({stored_in(entry.at("stored")), entry.at("bytes")});
  }
  answer.seconds = json.at("seconds");
  return answer;
}

}  // namespace convexact
