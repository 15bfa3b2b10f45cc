// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "convexact/number.hpp"
#include "number/text.hpp"
#include "oracle/diff.hpp"
#include "scene/result_json.hpp"

namespace convexact {
namespace {

constexpr int kCostDigits = 17;  // of costs
constexpr int kShareDigits = 3;  // of shares
constexpr int kRatioDigits = 8;  // of the final volumes

std::string ratio_text(const std::optional<Enclosure>& ratio) {
  if (!ratio) return "unbounded";
  return to_decimal(*ratio, kRatioDigits).value_or("?");
}

std::string share_text(const std::optional<Rational>& share) {
  return share ? to_decimal(*share, kShareDigits) : "-";
}

std::string plane_text(const Halfspace& plane) {
  return fmt::format("({}, {}, {}, {})", to_string(plane.normal()[0]), to_string(plane.normal()[1]),
                     to_string(plane.normal()[2]), to_string(plane.offset()));
}

std::string choice_line(Engine engine, const Choice& choice,
                        const std::vector<Halfspace>& halfspaces) {
  if (!choice.removed) return fmt::format("    {:<9} ended\n", name_of(engine));
  return fmt::format(
      "    {:<9} removed {}, cost {}\n              {}\n", name_of(engine), choice.removed->index(),
      choice.cost ? to_decimal(choice.cost->rational(), kCostDigits) : "infinite: unbounded",
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

std::string row_text(const DiffRow& row, std::size_t name_width) {
  const Comparison& comparison = *row.comparison;
  const Divergence* worst =
      comparison.divergences.empty() ? nullptr : &worst_of(comparison.divergences);
  return fmt::format(
      "{:<{}}  {:>10}  {:>8} {:<8}  {:<21}  {:>6}  {:<42}  {:>9}  {:>9}  {:>12}  {}\n", row.name,
      name_width, with_separators(row.report->halfspaces.size()), name_of(comparison.reference),
      name_of(comparison.other), comparison.with_records ? "removals, costs, ties" : "removals",
      with_separators(comparison.judged), difference_text(comparison),
      worst ? share_text(worst->regret) : "", worst ? share_text(worst->rounding) : "",
      ratio_text(comparison.volume_ratio), comparison.explained ? "ok" : "DIFFERENT");
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
                  "regret", "rounding", "final volume");
  for (const DiffRow& row : rows) text += row_text(row, width);
  for (const DiffRow& row : rows) text += witness_text(row);
  return text;
}

}  // namespace convexact
