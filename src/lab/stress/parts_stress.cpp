// SPDX-License-Identifier: MIT
#include "lab/stress/parts_stress.hpp"

#include <fmt/format.h>

#include <ctime>
#include <nlohmann/json.hpp>

#include "convexact/verify_parts.hpp"
#include "io/json.hpp"
#include "number/precision.hpp"

namespace convexact {
namespace {

constexpr const char* kBroken = "an error that is not documented";

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

void judge(const Mesh& mesh, const Decomposition& made, PartsStressRun& run) {
  std::vector<NamedPart> parts;
  for (const Part& part : made.parts) parts.push_back({"part", part.mesh});
  PartsRequest asked;
  asked.claims = {ClaimCode::PartsSolid, ClaimCode::PartsConvex, ClaimCode::CoversSurface,
                  ClaimCode::CoversSolid};
  asked.distance = Tolerance{kDefaultDistance.value, true};
  asked.measures = PartMeasures::None;  // distances take minutes at the ends of the doubles
  asked.jobs = 1;                       // as of the method
  const PartsVerdict verdict = verify_parts(mesh, parts, asked);
  for (const ClaimCode code : asked.claims) {
    if (verdict[code].status == Status::Holds) continue;
    run.faults.push_back(std::string(name_of(code)) + ": " + verdict[code].sentence);
  }
  const Status within = verdict[ClaimCode::WithinSolid].status;
  if (run.is_within != (within == Status::Holds)) {
    run.faults.push_back(std::string("within the distance, says the ") +
                         (run.is_within ? "method, and not the oracle: " : "oracle: ") +
                         verdict[ClaimCode::WithinSolid].sentence);
  }
  // The parts hold the solid, or there is a fault already.
  const Measured solid = solid_volume(verdict.surface, kMeasureBits, false);
  if (solid.bounds.low() <= 0) return;
  const Measured united = union_volume(verdict.hulls, kMeasureBits, false);
  const Enclosure share = (united.bounds - solid.bounds) / solid.bounds;
  run.excess = std::max(0.0, to_double(share.high(), Rounding::Up));
}

Json run_json(const PartsStressRun& run) {
  Json json = {{"family", run.family},    {"parameter", run.parameter}, {"value", run.value},
               {"end", name_of(run.end)}, {"parts", run.parts},         {"within", run.is_within},
               {"excess", run.excess},    {"seconds", run.seconds},     {"memory", run.memory},
               {"faults", run.faults}};
  if (!run.why.empty()) json["why"] = run.why;
  return json;
}

// What a child says of its run.
void take_answer(const std::string& text, PartsStressRun& run) {
  const auto answer = nlohmann::json::parse(text);
  run.end = value_in(kStressEndNames, answer.at("end").get<std::string>()).value();
  run.parts = answer.at("parts");
  run.is_within = answer.at("within");
  run.excess = answer.at("excess");
  run.seconds = answer.at("seconds");
  run.faults = answer.at("faults");
  if (answer.contains("why")) run.why = answer.at("why");
}

PartsStressRun run_of(const PartsFamily& family, double value, const StressLimits& limits,
                      const Watch& watch) {
  const std::function<Json()> work = [&] { return run_json(cut_and_judge(family.make(value))); };
  const auto child = start_child(work, limits);
  std::optional<ProgramRun> ended;
  while (!ended) {
    watch.ask();
    ended = child->poll(20);
  }
  const ChildEnd end = end_of(*ended, *child, limits);
  PartsStressRun run;
  if (end.answer) {
    take_answer(*end.answer, run);
  } else {
    run.end = end.end;
    run.why = end.why;
    run.faults = {std::string(name_of(end.end)) + ": " + end.why};
  }
  run.family = family.name;
  run.parameter = family.parameter;
  run.value = value;
  run.memory = end.memory;
  return run;
}

}  // namespace

PartsStressRun cut_and_judge(const Mesh& mesh) {
  PartsStressRun run;
  DecomposeRequest request;
  request.method = DecomposeMethod::Cut;
  request.measures = PartMeasures::None;
  request.jobs = 1;  // threads reserve addresses, of which the process has a limit
  const double start = processor_seconds();
  try {
    const DecomposeOutcome outcome = decompose(mesh, request);
    run.seconds = processor_seconds() - start;
    const auto* made = std::get_if<Decomposition>(&outcome);
    if (made == nullptr) {
      run.end = StressEnd::NoVolume;
      return run;
    }
    run.end = StressEnd::Reached;
    run.parts = made->parts.size();
    run.is_within = made->limit_holds;
    judge(mesh, *made, run);
  } catch (const Error& error) {
    run.end = StressEnd::Failed;
    run.why = error.what();
    if (error.code() != ErrorCode::Unrepresentable) run.faults = {kBroken + (": " + run.why)};
  }
  return run;
}

std::vector<PartsStressRun> stress_parts(std::span<const PartsFamily> families,
                                         std::span<const double> values, const StressLimits& limits,
                                         const Watch& watch) {
  std::vector<std::pair<const PartsFamily*, double>> inputs;
  for (const PartsFamily& family : families) {
    for (const double value : values.empty() ? std::span<const double>(family.values) : values) {
      inputs.emplace_back(&family, value);
    }
  }
  std::vector<PartsStressRun> runs;
  for (const auto& [family, value] : inputs) {
    watch.report(runs.size(), inputs.size());
    runs.push_back(run_of(*family, value, limits, watch));
  }
  return runs;
}

Json parts_stress_json(std::span<const PartsStressRun> runs) {
  Json list = Json::array();
  for (const PartsStressRun& run : runs) list.push_back(run_json(run));
  return {{"runs", std::move(list)}};
}

std::string parts_stress_table(std::span<const PartsStressRun> runs) {
  std::string text =
      fmt::format("{:<10} {:<10} {:>8}  {:<10} {:>6}  {:<6}  {:>8}  {:>7}  {:>6}  {}\n", "family",
                  "parameter", "value", "end", "parts", "within", "excess", "secs", "MB", "kept");
  std::string faults;
  for (const PartsStressRun& run : runs) {
    text += fmt::format(
        "{:<10} {:<10} {:>8.3g}  {:<10} {:>6}  {:<6}  {:>7.2g}%  {:>7.2f}  {:>6}  {}\n", run.family,
        run.parameter, run.value, name_of(run.end), run.parts, run.is_within ? "yes" : "no",
        100 * run.excess, run.seconds, run.memory >> 20, run.faults.empty() ? "yes" : "NO");
    for (const std::string& fault : run.faults) {
      faults += fmt::format("{} {:g}: {}\n", run.family, run.value, fault);
    }
  }
  return text + faults;
}

}  // namespace convexact
