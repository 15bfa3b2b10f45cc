// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "convexact/number.hpp"
#include "oracle/conformance_report.hpp"

namespace convexact {
namespace {

using json = nlohmann::ordered_json;

json row_json(const ScoreRow& row) {
  json levels = json::array();
  for (const Score& score : row) {
    levels.push_back({{"passed", score.passed}, {"total", score.total}});
  }
  return {{"levels", json(levels.begin(), levels.end() - 1)}, {"all", levels.back()}};
}

json promise_json(const ConformanceReport& report) {
  const Promise& promise = report.promise;
  json result = {{"profile", report.profile.empty() ? json() : json(report.profile)},
                 {"asks", name_of(promise.asks)},
                 {"numbers", promise.numbers == Precision::Binary32 ? "binary32" : "binary64"},
                 {"tolerance", describe(promise.tolerance)},
                 {"allow_flat", promise.allow_flat}};
  if (promise.max_facets) result["max_facets"] = *promise.max_facets;
  if (promise.max_vertices) result["max_vertices"] = *promise.max_vertices;
  if (promise.max_facet_vertices) result["max_facet_vertices"] = *promise.max_facet_vertices;
  return result;
}

template <class Decades>
json histogram_json(const Decades& decades) {
  json list = json::array();
  for (const auto& [decade, count] : decades) {
    list.push_back({{"up_to", "1e" + std::to_string(decade)}, {"count", count}});
  }
  return list;
}

json failure_json(const Failure& failure) {
  return {{"outcome", name_of(failure.outcome)},
          {"rounding", failure.is_rounding},
          {"sentence", failure.sentence}};
}

json entry_json(const ConformanceEntry& entry) {
  const Conformance& result = entry.result;
  json failures = json::array();
  for (const Failure& failure : result.failures) failures.push_back(failure_json(failure));
  json found = {{"id", entry.vector->id},       {"title", entry.vector->title},
                {"level", entry.vector->level}, {"required", entry.vector->required},
                {"flags", entry.vector->flags}, {"outcome", name_of(result.outcome())},
                {"sentence", result.sentence},  {"failures", failures},
                {"notes", result.notes},        {"seconds", entry.seconds}};
  if (const auto squared = squared_excess(result)) {
    found["excess"] = {{"points", result.outside->points},
                       {"tested", result.outside->tested},
                       {"worst", decimal_of_root(*squared)},
                       {"corners", histogram_json(result.outside_by_decade)}};
  }
  if (result.relative_squared_hausdorff) {
    found["hausdorff"] = decimal_of_root(*result.relative_squared_hausdorff);
  }
  if (result.tightness) found["tightness"] = to_decimal(*result.tightness, 6);
  return found;
}

}  // namespace

nlohmann::ordered_json conformance_json(const ConformanceReport& report) {
  const ScoreMatrix matrix = matrix_of(report);
  json flags = json::object(), outcomes = json::object(), reasons = json::object();
  json entries = json::array();
  for (const auto& [flag, row] : matrix.flags) flags[flag] = row_json(row);
  for (const Outcome outcome : kAllOutcomes) outcomes[name_of(outcome)] = 0;
  for (const ConformanceEntry& entry : report.entries) {
    json& count = outcomes[name_of(entry.result.outcome())];
    count = count.get<std::size_t>() + 1;
    entries.push_back(entry_json(entry));
  }
  std::size_t not_run = 0;
  for (const auto& [reason, count] : report.not_run) {
    reasons[name_of(reason)] = count;
    not_run += count;
  }
  auto histogram = excess_histogram(report);
  const std::size_t without = histogram[std::nullopt];
  histogram.erase(std::nullopt);
  json excess = json::array();
  for (const auto& [decade, count] : histogram) {
    excess.push_back({{"up_to", "1e" + std::to_string(*decade)}, {"count", count}});
  }
  return {{"program", report.program},
          {"promise", promise_json(report)},
          {"conforms", report.conforms()},
          {"passed", report.passed()},
          {"total", report.entries.size()},
          {"not_run", not_run},
          {"not_run_reasons", reasons},
          {"outcomes", outcomes},
          {"excess", {{"none", without}, {"vectors", excess}}},
          {"flags", flags},
          {"all", row_json(matrix.all)},
          {"vectors", entries}};
}

}  // namespace convexact
