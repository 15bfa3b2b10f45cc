// SPDX-License-Identifier: MIT
#include "convexact/format/conformance_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>

namespace convexact {
namespace {

constexpr int kLevels = 3;
constexpr const char* kLevelNames[kLevels] = {"everyday", "hard", "cruel"};

struct Score {
  std::size_t passed = 0, total = 0;

  void add(bool is_pass) {
    ++total;
    passed += is_pass ? 1 : 0;
  }
  std::string text() const { return total == 0 ? "-" : fmt::format("{}/{}", passed, total); }
};

// One row of the matrix: the levels, then all of them.
using Row = std::array<Score, kLevels + 1>;

struct Matrix {
  std::map<std::string, Row> flags;  // by name; a vector counts under each of its flags
  Row all;
};

bool is_pass(const ConformanceEntry& entry) { return entry.result.outcome == Outcome::Passed; }

Matrix matrix_of(const ConformanceReport& report) {
  Matrix matrix;
  for (const ConformanceEntry& entry : report.entries) {
    const auto add = [&](Row& row) {
      row[entry.vector->level - 1].add(is_pass(entry));
      row[kLevels].add(is_pass(entry));
    };
    for (const std::string& flag : entry.vector->flags) add(matrix.flags[flag]);
    add(matrix.all);
  }
  return matrix;
}

std::map<Outcome, std::vector<const ConformanceEntry*>> failures_of(
    const ConformanceReport& report) {
  std::map<Outcome, std::vector<const ConformanceEntry*>> failures;
  for (const ConformanceEntry& entry : report.entries) {
    if (!is_pass(entry)) failures[entry.result.outcome].push_back(&entry);
  }
  return failures;
}

// Of the passed runs, ascending.
std::vector<double> tightness_of(const ConformanceReport& report) {
  std::vector<double> values;
  for (const ConformanceEntry& entry : report.entries) {
    if (is_pass(entry) && entry.result.tightness) values.push_back(*entry.result.tightness);
  }
  std::sort(values.begin(), values.end());
  return values;
}

std::string tightness_sentence(const ConformanceReport& report) {
  const std::vector<double> values = tightness_of(report);
  if (values.empty()) return "";
  return fmt::format(
      "Volume against the exact greedy result (reported, not judged): median {:.6g}, largest "
      "{:.6g} "
      "times\n",
      values[values.size() / 2], values.back());
}

std::string verdict_sentence(const ConformanceReport& report) {
  return fmt::format("{} of {} passed; {}\n", report.passed(), report.entries.size(),
                     report.conforms() ? "every required vector passed: the program conforms"
                                       : "a required vector failed: the program does not conform");
}

void append_row(std::string& text, const std::string& name, const Row& row) {
  text += fmt::format("{:<16}{:>10}{:>10}{:>10}{:>10}\n", name, row[0].text(), row[1].text(),
                      row[2].text(), row[3].text());
}

// A badge of two boxes; text widths are near those of Verdana at 11 pixels.
constexpr const char* kBadge =
    R"(<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="20" role="img" aria-label="convexact: {words}">
<rect width="70" height="20" rx="3" fill="#444"/>
<rect x="66" width="{right}" height="20" rx="3" fill="{color}"/>
<rect x="66" width="4" height="20" fill="{color}"/>
<g fill="#fff" text-anchor="middle" font-family="Verdana,sans-serif" font-size="11">
<text x="34" y="14">convexact</text>
<text x="{middle}" y="14">{words}</text>
</g>
</svg>
)";

}  // namespace

std::size_t ConformanceReport::passed() const {
  return static_cast<std::size_t>(std::count_if(entries.begin(), entries.end(), is_pass));
}

bool ConformanceReport::conforms() const {
  return std::all_of(entries.begin(), entries.end(), [](const ConformanceEntry& entry) {
    return is_pass(entry) || !entry.vector->required;
  });
}

std::string conformance_text(const ConformanceReport& report) {
  constexpr std::size_t kListed = 5;  // of each kind; JSON has all
  const Matrix matrix = matrix_of(report);
  std::string text = fmt::format("{:<16}{:>10}{:>10}{:>10}{:>10}\n", "", kLevelNames[0],
                                 kLevelNames[1], kLevelNames[2], "all");
  for (const auto& [flag, row] : matrix.flags) append_row(text, flag, row);
  append_row(text, "all vectors", matrix.all);
  for (const auto& [outcome, entries] : failures_of(report)) {
    text += fmt::format("\n{} ({})\n", name_of(outcome), entries.size());
    for (std::size_t i = 0; i < std::min(entries.size(), kListed); ++i) {
      text += fmt::format("  {}: {}\n", entries[i]->vector->id, entries[i]->result.sentence);
    }
    if (entries.size() > kListed) text += fmt::format("  and {} more\n", entries.size() - kListed);
  }
  return text + "\n" + tightness_sentence(report) + verdict_sentence(report);
}

std::string conformance_markdown(const ConformanceReport& report) {
  const Matrix matrix = matrix_of(report);
  std::string text = fmt::format("# Conformance of `{}`\n\n{}{}\n", report.program,
                                 verdict_sentence(report), tightness_sentence(report));
  text += fmt::format("| flag | {} | {} | {} | all |\n|---|---|---|---|---|\n", kLevelNames[0],
                      kLevelNames[1], kLevelNames[2]);
  const auto append = [&text](const std::string& name, const Row& row) {
    text += fmt::format("| {} | {} | {} | {} | {} |\n", name, row[0].text(), row[1].text(),
                        row[2].text(), row[3].text());
  };
  for (const auto& [flag, row] : matrix.flags) append(flag, row);
  append("**all vectors**", matrix.all);
  for (const auto& [outcome, entries] : failures_of(report)) {
    text += fmt::format("\n## {} ({})\n\n", name_of(outcome), entries.size());
    for (const ConformanceEntry* entry : entries) {
      text += fmt::format("- `{}` (level {}{}): {}\n", entry->vector->id, entry->vector->level,
                          entry->vector->required ? "" : ", not required", entry->result.sentence);
    }
  }
  return text;
}

nlohmann::ordered_json conformance_json(const ConformanceReport& report) {
  using json = nlohmann::ordered_json;
  const auto row_json = [](const Row& row) {
    json levels = json::array();
    for (const Score& score : row) {
      levels.push_back({{"passed", score.passed}, {"total", score.total}});
    }
    return json{{"levels", json(levels.begin(), levels.end() - 1)}, {"all", levels.back()}};
  };
  const Matrix matrix = matrix_of(report);
  json flags = json::object(), outcomes = json::object(), entries = json::array();
  for (const auto& [flag, row] : matrix.flags) flags[flag] = row_json(row);
  for (const Outcome outcome : kAllOutcomes) outcomes[name_of(outcome)] = 0;
  for (const ConformanceEntry& entry : report.entries) {
    json& count = outcomes[name_of(entry.result.outcome)];
    count = count.get<std::size_t>() + 1;
    json result = {{"id", entry.vector->id},
                   {"title", entry.vector->title},
                   {"level", entry.vector->level},
                   {"required", entry.vector->required},
                   {"flags", entry.vector->flags},
                   {"outcome", name_of(entry.result.outcome)},
                   {"sentence", entry.result.sentence},
                   {"seconds", entry.seconds}};
    if (entry.result.tightness) result["tightness"] = *entry.result.tightness;
    entries.push_back(std::move(result));
  }
  return {{"program", report.program},
          {"conforms", report.conforms()},
          {"passed", report.passed()},
          {"total", report.entries.size()},
          {"not_run", report.not_run},
          {"outcomes", outcomes},
          {"flags", flags},
          {"all", row_json(matrix.all)},
          {"vectors", entries}};
}

std::string conformance_badge(const ConformanceReport& report) {
  const std::string words = fmt::format("{}/{}", report.passed(), report.entries.size());
  const int right = 24 + 7 * static_cast<int>(words.size());
  const bool all = report.passed() == report.entries.size();
  const char* color = !report.conforms() ? "#c33" : all ? "#2a2" : "#7a3";
  return fmt::format(fmt::runtime(kBadge), fmt::arg("width", 66 + right), fmt::arg("right", right),
                     fmt::arg("middle", 66 + right / 2), fmt::arg("color", color),
                     fmt::arg("words", words));
}

}  // namespace convexact
