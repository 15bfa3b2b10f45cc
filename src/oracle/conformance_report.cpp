// SPDX-License-Identifier: MIT
#include "oracle/conformance_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "convexact/number.hpp"
#include "io/json.hpp"

namespace convexact {
namespace {

constexpr const char* kLevelNames[kLevels] = {"everyday", "hard", "cruel"};

std::string score_text(const Score& score) {
  return score.total == 0 ? "-" : fmt::format("{}/{}", score.passed, score.total);
}

// Failed vectors by the kind of their gravest failure, each list with the worst first.
struct KindOfFailure {
  bool is_rounding;
  Outcome outcome;
  auto operator<=>(const KindOfFailure&) const = default;
};
using FailureList = std::map<KindOfFailure, std::vector<const ConformanceEntry*>>;

FailureList failures_of(const ConformanceReport& report) {
  FailureList failures;
  for (const ConformanceEntry& entry : report.entries) {
    if (is_pass(entry)) continue;
    const Failure& gravest = entry.result.failures.front();
    failures[{gravest.is_rounding, gravest.outcome}].push_back(&entry);
  }
  for (auto& [kind, entries] : failures) {
    std::stable_sort(entries.begin(), entries.end(), [](const auto* a, const auto* b) {
      return is_graver(a->result.failures.front(), b->result.failures.front());
    });
  }
  return failures;
}

std::string title_of(const KindOfFailure& kind, std::size_t count) {
  return fmt::format("{}{} ({})", name_of(kind.outcome),
                     kind.is_rounding ? ", by no more than rounding" : "", count);
}

// The first sentence, then the names of the other failures, each once.
std::string failure_text(const ConformanceEntry& entry) {
  const std::vector<Failure>& failures = entry.result.failures;
  std::string others;
  std::set<std::pair<bool, Outcome>> named = {
      {failures.front().is_rounding, failures.front().outcome}};
  for (const Failure& other : failures) {
    if (!named.insert({other.is_rounding, other.outcome}).second) continue;
    others += fmt::format("{}{}{}", others.empty() ? "; also " : ", ", name_of(other.outcome),
                          other.is_rounding ? " by no more than rounding" : "");
  }
  return entry.result.sentence + others;
}

std::string bound_text(const ConformanceReport& report) {
  switch (report.promise.asks) {
    case Asks::Simplify:
      return "the exact greedy result (reported; judged only if too loose)";
    case Asks::Inner:
      return "the hull of the input (reported, not judged)";
    case Asks::Enclosure:
    case Asks::Hull:
      break;
  }
  return "the hull of the input (reported; judged only if too loose)";
}

std::string tightness_sentence(const ConformanceReport& report) {
  std::vector<const ConformanceEntry*> known;
  for (const ConformanceEntry& entry : report.entries) {
    if (entry.result.tightness) known.push_back(&entry);
  }
  if (known.empty()) return "";
  std::sort(known.begin(), known.end(), [](const auto* a, const auto* b) {
    return *a->result.tightness < *b->result.tightness;
  });
  const auto text = [](const ConformanceEntry* entry) {
    return to_decimal(*entry->result.tightness, 6);
  };
  return fmt::format("Volume against {}: median {}, largest {} times ({})\n", bound_text(report),
                     text(known[known.size() / 2]), text(known.back()), known.back()->vector->id);
}

// Three decades at a time; JSON has each of them.
std::string excess_text(const ConformanceReport& report) {
  constexpr int kLeast = -18, kMost = 0, kStep = 3;
  std::map<int, std::size_t> steps;
  for (const auto& [decade, count] : excess_histogram(report)) {
    if (!decade) continue;
    int bound = kLeast;
    while (bound < *decade && bound <= kMost) bound += kStep;
    steps[bound] += count;
  }
  std::string text;
  for (const auto& [bound, count] : steps) {
    text += fmt::format("{}{} by ", text.empty() ? "Points outside: of " : ", ", count);
    text += bound > kMost ? "more" : fmt::format("up to 1e{}", bound);
  }
  return text.empty() ? "" : text + " of the diameter (vectors by their worst point)\n";
}

std::string verdict_sentence(const ConformanceReport& report) {
  return fmt::format("{} of {} passed; {}\n", report.passed(), report.entries.size(),
                     report.conforms() ? "every required vector passed: the program conforms"
                                       : "a required vector failed: the program does not conform");
}

std::string not_run_sentence(const ConformanceReport& report) {
  constexpr const char* kReasons[] = {"ask something else", "do not fit the input format",
                                      "do not exist in binary32",
                                      "have more facets or corners than promised"};
  std::string text;
  for (const auto& [reason, count] : report.not_run) {
    text += fmt::format("{}{} {}", text.empty() ? "Not run: " : ", ", count,
                        kReasons[static_cast<std::size_t>(reason)]);
  }
  return text.empty() ? "" : text + "\n";
}

void append_row(std::string& text, const std::string& name, const ScoreRow& row) {
  text += fmt::format("{:<16}{:>10}{:>10}{:>10}{:>10}\n", name, score_text(row[0]),
                      score_text(row[1]), score_text(row[2]), score_text(row[3]));
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

ScoreMatrix matrix_of(const ConformanceReport& report) {
  ScoreMatrix matrix;
  for (const ConformanceEntry& entry : report.entries) {
    const auto add = [&](ScoreRow& row) {
      row[entry.vector->level - 1].add(is_pass(entry));
      row[kLevels].add(is_pass(entry));
    };
    for (const std::string& flag : entry.vector->flags) add(matrix.flags[flag]);
    add(matrix.all);
  }
  return matrix;
}

std::optional<Rational> squared_excess(const Conformance& result) {
  if (!result.outside) return std::nullopt;
  return result.outside->relative_squared_distance.value_or(0);
}

std::map<std::optional<int>, std::size_t> excess_histogram(const ConformanceReport& report) {
  std::map<std::optional<int>, std::size_t> histogram;
  for (const ConformanceEntry& entry : report.entries) {
    if (!squared_excess(entry.result)) continue;
    const auto& decades = entry.result.outside_by_decade;
    ++histogram[decades.empty() ? std::nullopt : std::optional(decades.rbegin()->first)];
  }
  return histogram;
}

std::string conformance_text(const ConformanceReport& report) {
  constexpr std::size_t kListed = 5;  // of each kind; JSON has all
  const ScoreMatrix matrix = matrix_of(report);
  std::string text = fmt::format("{:<16}{:>10}{:>10}{:>10}{:>10}\n", "", kLevelNames[0],
                                 kLevelNames[1], kLevelNames[2], "all");
  for (const auto& [flag, row] : matrix.flags) append_row(text, flag, row);
  append_row(text, "all vectors", matrix.all);
  for (const auto& [kind, entries] : failures_of(report)) {
    text += "\n" + title_of(kind, entries.size()) + "\n";
    for (std::size_t i = 0; i < std::min(entries.size(), kListed); ++i) {
      text += fmt::format("  {}: {}\n", entries[i]->vector->id, failure_text(*entries[i]));
    }
    if (entries.size() > kListed) text += fmt::format("  and {} more\n", entries.size() - kListed);
  }
  return text + "\n" + excess_text(report) + tightness_sentence(report) + not_run_sentence(report) +
         verdict_sentence(report);
}

std::string conformance_markdown(const ConformanceReport& report) {
  const ScoreMatrix matrix = matrix_of(report);
  std::string text = fmt::format("# Conformance of `{}`\n\n", as_utf8(report.program));
  for (const std::string& paragraph : {verdict_sentence(report), excess_text(report),
                                       tightness_sentence(report), not_run_sentence(report)}) {
    if (!paragraph.empty()) text += paragraph + "\n";
  }
  text += fmt::format("| flag | {} | {} | {} | all |\n|---|---|---|---|---|\n", kLevelNames[0],
                      kLevelNames[1], kLevelNames[2]);
  const auto append = [&text](const std::string& name, const ScoreRow& row) {
    text += fmt::format("| {} | {} | {} | {} | {} |\n", name, score_text(row[0]),
                        score_text(row[1]), score_text(row[2]), score_text(row[3]));
  };
  for (const auto& [flag, row] : matrix.flags) append(flag, row);
  append("**all vectors**", matrix.all);
  for (const auto& [kind, entries] : failures_of(report)) {
    text += "\n## " + title_of(kind, entries.size()) + "\n\n";
    for (const ConformanceEntry* entry : entries) {
      text += fmt::format("- `{}` (level {}{}): {}\n", entry->vector->id, entry->vector->level,
                          entry->vector->required ? "" : ", not required", failure_text(*entry));
    }
  }
  return text;
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
