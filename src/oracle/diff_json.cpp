// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "convexact/number.hpp"
#include "io/json.hpp"
#include "number/precision.hpp"
#include "oracle/diff.hpp"
#include "scene/result_json.hpp"
#include "simplify/trace_json.hpp"

namespace convexact {
namespace {

using Json = nlohmann::ordered_json;

Json choice_json(const Choice& choice, const std::vector<Halfspace>& halfspaces) {
  if (!choice.removed) return {{"removed", nullptr}};
  const Halfspace& plane = halfspaces[choice.removed->index()];
  return {{"removed", choice.removed->index()},
          {"plane", plane_json(plane)},
          {"cost", choice.cost ? quantity_json(choice.cost->rational()) : Json(nullptr)}};
}

Json shortened(const std::optional<Rational>& x) {
  return x ? measured_json({Enclosure(*x, kMeasureBits), std::nullopt}, kDigits) : Json(nullptr);
}

const char* at_fault(const Comparison& comparison, const Divergence& found) {
  return name_of(found.reference_at_fault ? comparison.reference : comparison.other);
}

Json divergence_json(const Comparison& comparison, const Divergence& found,
                     const std::vector<Halfspace>& halfspaces) {
  return {{"step", found.step},
          {"left", found.left},
          {"class", name_of(found.kind)},
          {"at_fault", at_fault(comparison, found)},
          {"reference", choice_json(found.reference, halfspaces)},
          {"other", choice_json(found.other, halfspaces)},
          {"regret", shortened(found.regret)},
          {"rounding", shortened(found.rounding)}};
}

// Without planes and costs, of which there may be thousands of thousands of digits.
Json brief_json(const Comparison& comparison, const Divergence& found) {
  const auto id = [](const Choice& choice) {
    return choice.removed ? Json(choice.removed->index()) : Json(nullptr);
  };
  return {{"step", found.step},
          {"class", name_of(found.kind)},
          {"at_fault", at_fault(comparison, found)},
          {"reference", id(found.reference)},
          {"other", id(found.other)},
          {"regret", shortened(found.regret)}};
}

Json comparison_json(const Comparison& comparison, const std::vector<Halfspace>& halfspaces) {
  const std::vector<Divergence>& all = comparison.divergences;
  Json json = {{"reference", name_of(comparison.reference)},
               {"other", name_of(comparison.other)},
               {"same", all.empty()},
               {"explained", comparison.explained},
               {"compared", {"removals"}},
               {"judged", comparison.judged}};
  if (comparison.with_records) json["compared"] = {"removals", "costs", "ties"};
  if (!all.empty()) {
    json["divergence"] = divergence_json(comparison, all.front(), halfspaces);
    json["worst"] = divergence_json(comparison, worst_of(all), halfspaces);
  }
  json["divergences"] = Json::array();
  for (const Divergence& found : all) json["divergences"].push_back(brief_json(comparison, found));
  json["volume_ratio"] = comparison.volume_ratio
                             ? measured_json({*comparison.volume_ratio, std::nullopt}, kDigits)
                             : Json(nullptr);
  return json;
}

}  // namespace

Json diff_json(const DiffReport& report) {
  Json engines = Json::array(), comparisons = Json::array();
  for (std::size_t k = 0; k < report.runs.size(); ++k) {
    const Run& run = report.runs[k];
    engines.push_back({{"engine", name_of(report.engines[k])},
                       {"steps", run.steps.size()},
                       {"stop", name_of(run.stop)}});
  }
  for (const Comparison& comparison : report.comparisons) {
    comparisons.push_back(comparison_json(comparison, report.halfspaces));
  }
  return {{"halfspaces", report.halfspaces.size()},
          {"explained", report.holds()},
          {"engines", engines},
          {"comparisons", comparisons}};
}

}  // namespace convexact
