// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "convexact/number.hpp"
#include "io/json.hpp"
#include "lab/diff/diff.hpp"
#include "number/precision.hpp"
#include "number/text.hpp"
#include "simplify/run_names.hpp"
#include "wire/trace_json.hpp"

namespace convexact {
namespace {

// ---- JSON

Json choice_json(const Choice& choice, const std::vector<Halfspace>& halfspaces) {
  if (!choice.removed) return {{"removed", nullptr}};
  Json cost = nullptr;
  if (choice.cost) {
    cost = choice.cost->measure() == CostMeasure::Volume ? quantity_json(choice.cost->rational())
                                                         : cost_json(*choice.cost);
  }
  return {{"removed", *choice.removed},
          {"plane", halfspaces[choice.removed->index()]},
          {"cost", std::move(cost)}};
}

Json shortened(const std::optional<Rational>& x) {
  return x ? measured_json({Enclosure(*x, kMeasureBits), std::nullopt}, kDigits) : Json(nullptr);
}

// Null for an interval around 0, too.
Json shortened(const std::optional<Regret>& x) {
  if (!x || (x->exact() == nullptr && !x->is_positive())) return nullptr;
  return measured_json({x->bounds(), std::nullopt}, kDigits);
}

const char* at_fault(const Comparison& comparison, const Divergence& found) {
  return name_of(found.reference_at_fault ? comparison.reference : comparison.other);
}

Json divergence_json(const Comparison& comparison, const Divergence& found,
                     const std::vector<Halfspace>& halfspaces) {
  Json json = {{"step", found.step},
               {"left", found.left},
               {"class", name_of(found.kind)},
               {"at_fault", at_fault(comparison, found)},
               {"reference", choice_json(found.reference, halfspaces)},
               {"other", choice_json(found.other, halfspaces)},
               {"regret", shortened(found.regret)},
               {"rounding", shortened(found.rounding)}};
  if (found.is_undecided) json["undecided"] = true;
  return json;
}

// Without planes and costs, of which there may be thousands of thousands of digits.
Json brief_json(const Comparison& comparison, const Divergence& found) {
  Json json = {{"step", found.step},
               {"class", name_of(found.kind)},
               {"at_fault", at_fault(comparison, found)},
               {"reference", or_null(found.reference.removed)},
               {"other", or_null(found.other.removed)},
               {"regret", shortened(found.regret)}};
  if (found.is_undecided) json["undecided"] = true;
  return json;
}

Json ratio_json(const std::optional<Enclosure>& ratio) {
  return ratio ? measured_json({*ratio, std::nullopt}, kDigits) : Json(nullptr);
}

Json comparison_json(const Comparison& comparison, const std::vector<Halfspace>& halfspaces,
                     CostMeasure cost) {
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
  json["volume_ratio"] = ratio_json(comparison.volume_ratio);
  if (cost != CostMeasure::Volume) json["measure_ratio"] = ratio_json(comparison.measure_ratio);
  return json;
}

// ---- Text

constexpr int kShareDigits = 3;  // of shares
constexpr int kRatioDigits = 8;  // of the final volumes

std::string ratio_text(const std::optional<Enclosure>& ratio) {
  if (!ratio) return "unbounded";
  return to_decimal(*ratio, kRatioDigits).value_or("?");
}

std::string share_text(const std::optional<Rational>& share) {
  return share ? to_decimal(*share, kShareDigits) : "-";
}

std::string share_text(const std::optional<Regret>& share) {
  if (!share) return "-";
  if (const Rational* exact = share->exact()) return to_decimal(*exact, kShareDigits);
  return to_decimal(share->bounds(), kShareDigits).value_or("open");
}

std::string plane_text(const Halfspace& plane) {
  return fmt::format("({}, {}, {}, {})", to_string(plane.normal()[0]), to_string(plane.normal()[1]),
                     to_string(plane.normal()[2]), to_string(plane.offset()));
}

std::string choice_line(Engine engine, const Choice& choice,
                        const std::vector<Halfspace>& halfspaces) {
  if (!choice.removed) return fmt::format("    {:<9} ended\n", name_of(engine));
  return fmt::format("    {:<9} removed {}, cost {}\n              {}\n", name_of(engine),
                     choice.removed->index(),
                     choice.cost ? choice.cost->decimal(kDigits) : "infinite: unbounded",
                     plane_text(halfspaces[choice.removed->index()]));
}

struct DiffRow {
  std::string name;
  const DiffReport* report;
  const Comparison* comparison;
};

// The worst difference, the first one, and how often they differ.
std::string difference_text(const Comparison& comparison) {
  const std::vector<Divergence>& all = comparison.divergences;
  if (all.empty()) return "same";
  const Divergence& worst = worst_of(all);
  const std::string text = fmt::format("{} at step {}", name_of(worst.kind), worst.step);
  return all.size() == 1 ? text : fmt::format("{}, {} in all", text, with_separators(all.size()));
}

// All objects are compared by the same measure.
const char* final_name(const std::vector<NamedDiff>& objects) {
  switch (objects.empty() ? CostMeasure::Volume : objects[0].report->cost) {
    case CostMeasure::Area:
      return "final area";
    case CostMeasure::MeanWidth:
      return "final width";
    case CostMeasure::Volume:
      break;
  }
  return "final volume";
}

std::string row_text(const DiffRow& row, std::size_t name_width) {
  const Comparison& comparison = *row.comparison;
  const auto& ratio =
      row.report->cost == CostMeasure::Volume ? comparison.volume_ratio : comparison.measure_ratio;
  const Divergence* worst =
      comparison.divergences.empty() ? nullptr : &worst_of(comparison.divergences);
  return fmt::format(
      "{:<{}}  {:>10}  {:>8} {:<8}  {:<21}  {:>6}  {:<42}  {:>9}  {:>9}  {:>12}  {}\n", row.name,
      name_width, with_separators(row.report->halfspaces.size()), name_of(comparison.reference),
      name_of(comparison.other), comparison.with_records ? "removals, costs, ties" : "removals",
      with_separators(comparison.judged), difference_text(comparison),
      worst ? share_text(worst->regret) : "", worst ? share_text(worst->rounding) : "",
      ratio_text(ratio), comparison.explained ? "ok" : "DIFFERENT");
}

std::string divergence_text(const DiffRow& row, const Divergence& found, const char* what) {
  return fmt::format("\n  {}: {} and {} {} at step {}, {} halfspaces left: {}\n", row.name,
                     name_of(row.comparison->reference), name_of(row.comparison->other), what,
                     found.step, with_separators(found.left), name_of(found.kind)) +
         choice_line(row.comparison->reference, found.reference, row.report->halfspaces) +
         choice_line(row.comparison->other, found.other, row.report->halfspaces);
}

// Where they differ first and, if it is another step, where they differ worst.
std::string witness_text(const DiffRow& row) {
  const std::vector<Divergence>& all = row.comparison->divergences;
  if (all.empty()) return "";
  const Divergence &first = all.front(), &worst = worst_of(all);
  std::string text = divergence_text(row, first, "part");
  if (&worst != &first) text += divergence_text(row, worst, "differ most");
  return text;
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
    comparisons.push_back(comparison_json(comparison, report.halfspaces, report.cost));
  }
  Json json = {{"halfspaces", report.halfspaces.size()}};
  if (report.cost != CostMeasure::Volume) json["cost"] = name_of(report.cost);
  if (!report.kept.empty()) json["kept"] = report.kept;
  json["explained"] = report.holds();
  json["engines"] = engines;
  json["comparisons"] = comparisons;
  return json;
}

std::string diff_table(const std::vector<NamedDiff>& objects) {
  std::vector<DiffRow> rows;
  std::size_t width = 6;
  for (const NamedDiff& object : objects) {
    width = std::max(width, object.name.size());
    for (const Comparison& comparison : object.report->comparisons) {
      rows.push_back({object.name, object.report, &comparison});
    }
  }
  std::string text =
      fmt::format("{:<{}}  {:>10}  {:<17}  {:<21}  {:>6}  {:<42}  {:>9}  {:>9}  {:>12}\n", "object",
                  width, "halfspaces", " reference other", "compared", "steps", "difference",
                  "regret", "rounding", final_name(objects));
  for (const DiffRow& row : rows) text += row_text(row, width);
  for (const DiffRow& row : rows) text += witness_text(row);
  return text;
}

}  // namespace convexact
