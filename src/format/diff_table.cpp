// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "convexact/format/diff_json.hpp"
#include "convexact/format/summary.hpp"
#include "convexact/number/digits.hpp"
#include "words.hpp"

namespace convexact {
namespace {

constexpr int kDigits = 17;      // of costs
constexpr int kFewDigits = 3;    // of shares
constexpr int kRatioDigits = 8;  // of the final volumes

std::string ratio_text(const std::optional<Enclosure>& ratio) {
  if (!ratio) return "unbounded";
  return to_decimal(*ratio, kRatioDigits).value_or("?");
}

std::string share_text(const std::optional<Rational>& share) {
  return share ? to_decimal(*share, kFewDigits) : "-";
}

std::string plane_text(const Halfspace& plane) {
  return fmt::format("({}, {}, {}, {})", to_string(plane.normal()[0]), to_string(plane.normal()[1]),
                     to_string(plane.normal()[2]), to_string(plane.offset()));
}

std::string choice_line(Engine engine, const Choice& choice,
                        const std::vector<Halfspace>& halfspaces) {
  if (!choice.removed) return fmt::format("    {:<9} ended\n", words::name_of(engine));
  return fmt::format("    {:<9} removed {}, cost {}\n              {}\n", words::name_of(engine),
                     choice.removed->index(),
                     choice.cost ? to_decimal(*choice.cost, kDigits) : "infinite: unbounded",
                     plane_text(halfspaces[choice.removed->index()]));
}

struct Row {
  std::string name;
  const DiffReport* report;
  const Comparison* comparison;
};

std::string row_text(const Row& row, std::size_t name_width) {
  const Comparison& comparison = *row.comparison;
  const auto& found = comparison.divergence;
  const std::string where =
      found ? fmt::format("{} at step {}", words::name_of(found->kind), found->step) : "same";
  return fmt::format("{:<{}}  {:>10}  {:>8} {:<8}  {:<34}  {:>9}  {:>9}  {:>12}  {}\n", row.name,
                     name_width, with_separators(row.report->halfspaces.size()),
                     words::name_of(comparison.reference), words::name_of(comparison.other), where,
                     found ? share_text(found->regret) : "",
                     found ? share_text(found->rounding) : "", ratio_text(comparison.volume_ratio),
                     comparison.explained ? "ok" : "DIFFERENT");
}

std::string witness_text(const Row& row) {
  const Divergence& found = *row.comparison->divergence;
  return fmt::format("\n  {}: {} and {} part at step {}, {} halfspaces left: {}\n", row.name,
                     words::name_of(row.comparison->reference),
                     words::name_of(row.comparison->other), found.step, with_separators(found.left),
                     words::name_of(found.kind)) +
         choice_line(row.comparison->reference, found.reference, row.report->halfspaces) +
         choice_line(row.comparison->other, found.other, row.report->halfspaces);
}

}  // namespace

std::string diff_table(const std::vector<NamedDiff>& objects) {
  std::vector<Row> rows;
  std::size_t width = 6;
  for (const NamedDiff& object : objects) {
    width = std::max(width, object.name.size());
    for (const Comparison& comparison : object.report->comparisons) {
      rows.push_back({object.name, object.report, &comparison});
    }
  }
  std::string text = fmt::format("{:<{}}  {:>10}  {:<17}  {:<34}  {:>9}  {:>9}  {:>12}\n", "object",
                                 width, "halfspaces", " reference other", "removals", "regret",
                                 "rounding", "final volume");
  for (const Row& row : rows) text += row_text(row, width);
  for (const Row& row : rows) {
    if (row.comparison->divergence) text += witness_text(row);
  }
  return text;
}

}  // namespace convexact
