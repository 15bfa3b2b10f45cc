// SPDX-License-Identifier: MIT
#include "wire/stage_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/json.hpp"
#include "number/text.hpp"

namespace convexact {

Json stages_json(const std::vector<Stage>& stages) {
  Json list = Json::array();
  for (const Stage& stage : stages) {
    if (!stage.skipped.empty()) {
      list.push_back({{"name", stage.name}, {"skipped", stage.skipped}});
    } else {
      const char* kind = stage.kind == StageKind::Io ? "io" : "compute";
      list.push_back({{"name", stage.name}, {"kind", kind}, {"seconds", stage.seconds}});
    }
  }
  return list;
}

std::string stage_text(const std::vector<Stage>& stages, bool list_all) {
  constexpr std::size_t kMostNamed = 3;
  std::vector<Stage> ran;
  double seconds = 0;
  for (const Stage& stage : stages) {
    if (stage.skipped.empty()) ran.push_back(stage);
    seconds += stage.seconds;
  }
  std::string text;
  if (list_all) {
    for (const Stage& stage : ran) {
      text += fmt::format("  {:<24}{:>9.3f} s\n", stage.name, stage.seconds);
    }
    for (const Stage& stage : stages) {
      if (!stage.skipped.empty()) {
        text += fmt::format("  {:<24}not needed: {}\n", stage.name, stage.skipped);
      }
    }
    return text;
  }
  std::stable_sort(ran.begin(), ran.end(),
                   [](const Stage& a, const Stage& b) { return a.seconds > b.seconds; });
  if (ran.size() > kMostNamed) ran.resize(kMostNamed);
  std::vector<std::string> longest;
  for (const Stage& stage : ran) {
    longest.push_back(fmt::format("{} {:.2f}", stage.name, stage.seconds));
  }
  text = fmt::format("{:.2f} s ({}); ", seconds, fmt::join(longest, ", "));
  return summary_line("time", text + "--stages lists all");
}

namespace {

Json multipliers_json(const std::vector<Multiplier>& multipliers) {
  Json list = Json::array();
  for (const Multiplier& m : multipliers) {
    list.push_back({{"halfspace", m.row}, {"multiplier", to_string(m.value)}});
  }
  return list;
}

struct ProofJson {
  Json operator()(const FlatInput& flat) const {
    return {{"kind", "flat-points"},
            {"dimension", flat.dimension},
            {"basis", flat.basis},
            {"equations", flat.equations}};
  }
  Json operator()(const EmptyProof& proof) const {
    return {{"kind", "empty"}, {"farkas", multipliers_json(proof.farkas)}};
  }
  Json operator()(const FlatProof& proof) const {
    return {{"kind", "flat-halfspaces"},
            {"point", vector_json(proof.point)},
            {"multipliers", multipliers_json(proof.multipliers)}};
  }
  Json operator()(const RecessionRay& ray) const {
    return {{"kind", "unbounded"}, {"ray", vector_json(ray.direction)}};
  }
};

}  // namespace

Json proof_json(const NotSolid& reason) { return std::visit(ProofJson{}, reason); }

}  // namespace convexact
