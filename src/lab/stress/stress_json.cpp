// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "convexact/error.hpp"
#include "io/json.hpp"
#include "io/json_text.hpp"
#include "lab/stress/answer.hpp"
#include "simplify/cost_reader.hpp"
#include "simplify/run_names.hpp"
#include "wire/trace_json.hpp"

namespace convexact {
namespace {

constexpr auto kFormNames = name_table<StressStored::Form>(
    {{StressStored::Form::Planes, "planes"}, {StressStored::Form::Mesh, "mesh"}});
constexpr auto kOutcomeNames =
    name_table<StressStored::Outcome>({{StressStored::Outcome::Holds, "holds"},
                                       {StressStored::Outcome::Refused, "refused"},
                                       {StressStored::Outcome::Wrong, "wrong"}});

template <class E, std::size_t N>
E enumerator_in(const NameTable<E, N>& table, const nlohmann::json& read) {
  const std::optional<E> value = value_in(table, read.get_ref<const std::string&>());
  if (!value) throw Error(ErrorCode::Malformed, "no name of an enumerator: " + dump_json(read));
  return *value;
}

// JSON has no infinity.
Json number_json(double x) { return std::isfinite(x) ? Json(x) : Json("infinite"); }

double number_in(const nlohmann::json& read) {
  return read.is_string() ? std::numeric_limits<double>::infinity() : read.get<double>();
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
void take(std::optional<Value>& x, const nlohmann::json& read) {
  if (read.is_null()) return;
  if constexpr (std::is_floating_point_v<Value>) {
    x = number_in(read);
  } else {
    x = read.get<Value>();
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

StressStored stored_in(const nlohmann::json& read) {
  StressStored stored;
  stored.form = enumerator_in(kFormNames, read.at("form"));
  stored.precision = read.at("precision") == 64 ? Precision::Binary64 : Precision::Binary32;
  stored.whole = read.at("of") == "hull";
  stored.outcome = enumerator_in(kOutcomeNames, read.at("outcome"));
  if (stored.outcome != StressStored::Outcome::Refused) {
    stored.violations = read.at("violations");
    stored.push = number_in(read.at("push"));
    stored.volume_ratio = number_in(read.at("volume_ratio"));
  }
  stored.why = read.value("why", "");
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

std::optional<StressClaim> claim_in(const nlohmann::json& read) {
  if (read.is_null()) return std::nullopt;
  return StressClaim{.cost = number_in(read.at("cost")),
                     .regret = number_in(read.at("regret")),
                     .doubtful = read.at("doubtful"),
                     .end_proven = read.at("end_proven"),
                     .vouched = read.at("vouched")};
}

Json volume_json(const ReportedVolume& volume) {
  return {optional_json(volume.low), optional_json(volume.high)};
}

ReportedVolume volume_in(const nlohmann::json& read) {
  ReportedVolume volume;
  take(volume.low, read.at(0));
  take(volume.high, read.at(1));
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

StressRun run_in(const nlohmann::json& read) {
  StressRun run;
  run.family = read.at("family");
  run.parameter = read.at("parameter");
  run.value = read.at("value");
  run.seed = read.at("seed");
  run.engine = enumerator_in(kEngineNames, read.at("engine"));
  run.end = enumerator_in(kStressEndNames, read.at("end"));
  run.why = read.value("why", "");
  run.input = read.at("input");
  run.at_start = read.at("halfspaces");
  run.steps = read.at("steps");
  run.compared = read.at("compared");
  run.seconds = read.at("seconds");
  run.memory = read.at("memory");
  take(run.volume_error, read.at("volume_error"));
  take(run.cost_error, read.at("cost_error"));
  take(run.first_difference, read.at("first_difference"));
  run.other_ties = read.at("other_ties");
  run.undecided = read.value("undecided", std::size_t(0));
  if (read.contains("moves")) run.moves = read.at("moves").get<std::size_t>();
  take(run.regret, read.at("regret"));
  run.claim = claim_in(read.at("claim"));
  for (const nlohmann::json& stored : read.at("stored")) run.stored.push_back(stored_in(stored));
  run.faults = read.at("faults");
  return run;
}

}  // namespace

Json stress_run_json(const StressRun& run) {
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

Json stress_json(const StressReport& report) {
  Json runs = Json::array();
  for (const StressRun& run : report.runs) runs.push_back(stress_run_json(run));
  Json json = {{"passes", report.passes()}, {"seconds", report.seconds}};
  if (report.cost != CostMeasure::Volume) json["cost"] = name_of(report.cost);
  json["runs"] = runs;
  return json;
}

std::vector<StressRun> stress_runs_in(std::string_view text) {
  const nlohmann::json read = parse_json(text);
  std::vector<StressRun> runs;
  for (const nlohmann::json& run : read.at("runs")) runs.push_back(run_in(run));
  return runs;
}

Json search_json(const std::optional<SearchAnswer>& search) {
  if (!search) return nullptr;
  return {{"moves", moves_json(search->moves)}, {"left", search->left}};
}

std::optional<SearchAnswer> search_in(const nlohmann::json& read, CostMeasure measure) {
  if (read.is_null()) return std::nullopt;
  SearchAnswer search;
  for (const nlohmann::json& entry : read.at("moves")) {
    search.moves.push_back({entry.at("removed").get<std::vector<HalfspaceId>>(),
                            entry.at("inserted").get<std::vector<HalfspaceId>>(),
                            cost_in_json(entry.at("measure"), measure)});
  }
  search.left = read.at("left").get<std::vector<Halfspace>>();
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

EngineAnswer answer_in(std::string_view text) {
  const nlohmann::json read = parse_json(text);
  EngineAnswer answer;
  answer.engine = enumerator_in(kEngineNames, read.at("engine"));
  answer.end = enumerator_in(kStressEndNames, read.at("end"));
  answer.why = read.at("why");
  answer.run.measure = enumerator_in(kCostMeasureNames, read.at("cost"));
  if (const nlohmann::json& measure = read.at("measure"); !measure.is_null()) {
    answer.measure = {volume_in(measure.at(0)), volume_in(measure.at(1))};
  }
  answer.run.halfspaces = read.at("halfspaces").get<std::vector<Halfspace>>();
  for (const nlohmann::json& entry : read.at("steps")) {
    Step& step = answer.run.steps.emplace_back();
    step.removed = entry.at("removed").get<HalfspaceId>();
    step.cost = cost_in_json(entry.at("cost"), answer.run.measure);
    step.tie = entry.at("tie").get<std::vector<HalfspaceId>>();
  }
  for (const nlohmann::json& entry : read.at("lean")) {
    answer.lean.push_back({.removed = entry.at("removed").get<HalfspaceId>(),
                           .cost = volume_in(entry.at("cost")),
                           .tied = entry.at("tied")});
  }
  answer.left = read.at("left").get<std::vector<Halfspace>>();
  answer.input_volume = volume_in(read.at("input_volume"));
  answer.output_volume = volume_in(read.at("output_volume"));
  answer.claim = claim_in(read.at("claim"));
  answer.search = search_in(read.at("search"), answer.run.measure);
  for (const nlohmann::json& entry : read.at("stored")) {
    answer.stored.push_back({stored_in(entry.at("stored")), entry.at("bytes")});
  }
  answer.seconds = read.at("seconds");
  return answer;
}

}  // namespace convexact
