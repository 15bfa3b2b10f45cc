// SPDX-License-Identifier: MIT
#include "wire/conformance_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <vector>

#include "convexact/number.hpp"
#include "io/json.hpp"
#include "io/names.hpp"
#include "simplify/run_names.hpp"

namespace convexact {
namespace {

// ---- Sums

constexpr int kLevels = 3;

struct Score {
  std::size_t passed = 0, total = 0;
};

// One row of the matrix: the levels, then all of them.
using ScoreRow = std::array<Score, kLevels + 1>;

struct ScoreMatrix {
  // By name; a vector counts under each of its flags, one that is to be refused in rows of its own.
  std::map<std::string, ScoreRow> flags;
  ScoreRow all;
};

bool is_pass(const ConformanceEntry& entry) { return entry.result.failures.empty(); }

bool is_refusal(const ConformanceEntry& entry) {
  return std::holds_alternative<RefuseQuestion>(entry.vector->question);
}

ScoreMatrix matrix_of(const ConformanceReport& report) {
  ScoreMatrix matrix;
  for (const ConformanceEntry& entry : report.entries) {
    const auto add = [&](ScoreRow& row) {
      for (const int column : {entry.vector->level - 1, kLevels}) {
        ++row[column].total;
        row[column].passed += is_pass(entry) ? 1 : 0;
      }
    };
    for (const std::string& flag : entry.vector->flags) {
      add(matrix.flags[is_refusal(entry) ? "refuse " + flag : flag]);
    }
    add(matrix.all);
  }
  return matrix;
}

// How many vectors have their worst excess above one bound and up to the next, by the upper bound
// as an exponent of ten.
struct ExcessHistogram {
  std::size_t none = 0;  // without a point outside
  std::map<int, std::size_t> by_decade;
};

ExcessHistogram excess_histogram(const ConformanceReport& report) {
  ExcessHistogram histogram;
  for (const ConformanceEntry& entry : report.entries) {
    if (!entry.result.outside) continue;
    const auto& decades = entry.result.outside_by_decade;
    ++(decades.empty() ? histogram.none : histogram.by_decade[decades.rbegin()->first]);
  }
  return histogram;
}

// ---- Text

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

// Known failures that failed again, and those that passed.
std::string known_sentence(const ConformanceReport& report) {
  if (!report.known_failures) return "";
  std::size_t failed = 0;
  std::vector<std::string> passed;
  for (const ConformanceEntry& entry : report.entries) {
    if (!report.is_known_failure(*entry.vector)) continue;
    if (is_pass(entry)) {
      passed.push_back(entry.vector->id);
    } else {
      ++failed;
    }
  }
  std::string text = fmt::format("Known failures: {} failed again", failed);
  const std::size_t other = report.known_failures->size() - failed - passed.size();
  if (other > 0) text += fmt::format(", {} not run", other);
  if (passed.empty()) return text + "\n";
  return text + fmt::format("; {} pass now and can leave the list: {}\n", passed.size(),
                            fmt::join(passed, ", "));
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
  for (const auto& [decade, count] : excess_histogram(report).by_decade) {
    int bound = kLeast;
    while (bound < decade && bound <= kMost) bound += kStep;
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
  const char* verdict = "nothing was asked: no vector with a usable input is among them";
  if (report.asked() > 0 && report.known_failures) {
    verdict = report.conforms() ? "no other than known failures"
                                : "a vector failed that is not in the list of known failures";
  } else if (report.asked() > 0) {
    verdict = report.conforms() ? "every required vector passed: the program conforms"
                                : "a required vector failed: the program does not conform";
  }
  return fmt::format("{} of {} passed; {}\n", report.passed(), report.entries.size(), verdict);
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

// A header, a row for each flag, and one for all vectors.
using TableRow = std::array<std::string, kLevels + 2>;

std::vector<TableRow> table_of(const ConformanceReport& report, const char* flag, const char* all) {
  std::vector<TableRow> table = {{flag, "everyday", "hard", "cruel", "all"}};
  const auto append = [&](const std::string& name, const ScoreRow& row) {
    TableRow& texts = table.emplace_back(TableRow{name});
    for (std::size_t k = 0; k < row.size(); ++k) {
      texts[k + 1] = row[k].total == 0 ? "-" : fmt::format("{}/{}", row[k].passed, row[k].total);
    }
  };
  const ScoreMatrix matrix = matrix_of(report);
  for (const auto& [name, row] : matrix.flags) append(name, row);
  append(all, matrix.all);
  return table;
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

// ---- JSON

Json score_json(const Score& score) { return {{"passed", score.passed}, {"total", score.total}}; }

Json row_json(const ScoreRow& row) {
  Json levels = Json::array();
  for (const Score& score : std::span(row).first(row.size() - 1)) {
    levels.push_back(score_json(score));
  }
  return {{"levels", std::move(levels)}, {"all", score_json(row.back())}};
}

Json promise_json(const ConformanceReport& report) {
  const Promise& promise = report.promise;
  Json result = {{"profile", report.profile.empty() ? Json() : Json(report.profile)},
                 {"asks", name_of(promise.asks)},
                 {"numbers", name_in(kPrecisionNames, promise.numbers)},
                 {"tolerance", describe(promise.tolerance)},
                 {"allow_flat", promise.allow_flat}};
  if (promise.max_facets) result["max_facets"] = *promise.max_facets;
  if (promise.max_vertices) result["max_vertices"] = *promise.max_vertices;
  if (promise.max_facet_vertices) result["max_facet_vertices"] = *promise.max_facet_vertices;
  return result;
}

Json histogram_json(const std::map<int, std::size_t>& decades) {
  Json list = Json::array();
  for (const auto& [decade, count] : decades) {
    list.push_back({{"up_to", fmt::format("1e{}", decade)}, {"count", count}});
  }
  return list;
}

// The lists by what became of the known failures.
Json known_json(const ConformanceReport& report) {
  Json failed = Json::array(), passed = Json::array();
  for (const ConformanceEntry& entry : report.entries) {
    if (!report.is_known_failure(*entry.vector)) continue;
    (is_pass(entry) ? passed : failed).push_back(entry.vector->id);
  }
  return {{"failed", failed}, {"passed", passed}};
}

}  // namespace

Json conformance_entry_json(const ConformanceEntry& entry) {
  const Conformance& result = entry.result;
  Json failures = Json::array();
  for (const Failure& failure : result.failures) {
    failures.push_back({{"outcome", name_of(failure.outcome)},
                        {"rounding", failure.is_rounding},
                        {"sentence", failure.sentence}});
  }
  Json found = {{"id", entry.vector->id},       {"title", entry.vector->title},
                {"level", entry.vector->level}, {"required", entry.vector->required},
                {"flags", entry.vector->flags}, {"outcome", name_of(result.outcome())},
                {"sentence", result.sentence},  {"failures", failures},
                {"notes", result.notes},        {"seconds", entry.seconds}};
  if (const auto& outside = result.outside) {
    found["excess"] = {{"points", outside->points},
                       {"tested", outside->tested},
                       {"worst", decimal_of_root(outside->relative_squared_distance.value_or(0))},
                       {"corners", histogram_json(result.outside_by_decade)}};
  }
  if (result.relative_squared_hausdorff) {
    found["hausdorff"] = decimal_of_root(*result.relative_squared_hausdorff);
  }
  if (result.tightness) found["tightness"] = to_decimal(*result.tightness, 6);
  if (!is_pass(entry) && !entry.printed.empty()) found["printed"] = last_line(entry.printed);
  return found;
}

std::string last_line(const std::string& printed) {
  constexpr std::size_t kMost = 200;
  const std::size_t end = printed.find_last_not_of(" \t\r\n");
  if (end == std::string::npos) return "";
  const std::size_t before = printed.find_last_of("\r\n", end);
  const std::size_t start = before == std::string::npos ? 0 : before + 1;
  std::string line = printed.substr(start, end + 1 - start);
  if (line.size() > kMost) line = line.substr(0, kMost) + "...";
  return as_utf8(line);
}

std::string failed_ids(const ConformanceReport& report) {
  std::string text;
  for (const ConformanceEntry& entry : report.entries) {
    if (!is_pass(entry)) text += entry.vector->id + "\n";
  }
  return text;
}

const char* name_of(NotRun reason) {
  constexpr auto kNames = name_table<NotRun>({{NotRun::AsksOtherwise, "asks-otherwise"},
                                              {NotRun::OtherFormat, "other-format"},
                                              {NotRun::OtherNumbers, "other-numbers"},
                                              {NotRun::BeyondTheProgram, "beyond-the-program"}});
  static_assert(kNames.size() == kAllNotRun.size());
  return name_in(kNames, reason);
}

const char* name_of(Outcome outcome) {
  constexpr auto kNames =
      name_table<Outcome>({{Outcome::NotStarted, "not-started"},
                           {Outcome::TimedOut, "timed-out"},
                           {Outcome::OutOfMemory, "out-of-memory"},
                           {Outcome::Crashed, "crashed"},
                           {Outcome::AcceptedUnusable, "accepted-unusable"},
                           {Outcome::WrongExit, "wrong-exit"},
                           {Outcome::MissingOutput, "missing-output"},
                           {Outcome::UnreadableOutput, "unreadable-output"},
                           {Outcome::NoSolid, "no-solid"},
                           {Outcome::NotEnclosing, "not-enclosing"},
                           {Outcome::NotInside, "not-inside"},
                           {Outcome::TooLoose, "too-loose"},
                           {Outcome::BrokenMesh, "broken-mesh"},
                           {Outcome::NotConvex, "not-convex"},
                           {Outcome::NotTheHull, "not-the-hull"},
                           {Outcome::TooManyFacets, "too-many-facets"},
                           {Outcome::TooManyVertices, "too-many-vertices"},
                           {Outcome::TooManyFacetVertices, "too-many-facet-vertices"},
                           {Outcome::Undecided, "undecided"},
                           {Outcome::Passed, "passed"}});
  static_assert(kNames.size() == kAllOutcomes.size());
  return name_in(kNames, outcome);
}

std::size_t ConformanceReport::passed() const {
  return static_cast<std::size_t>(std::count_if(entries.begin(), entries.end(), is_pass));
}

std::size_t ConformanceReport::asked() const {
  return static_cast<std::size_t>(std::count_if(
      entries.begin(), entries.end(), [](const auto& entry) { return !is_refusal(entry); }));
}

bool ConformanceReport::is_known_failure(const TestVector& vector) const {
  return known_failures && known_failures->contains(vector.id);
}

bool ConformanceReport::conforms() const {
  return asked() > 0 && std::all_of(entries.begin(), entries.end(), [&](const auto& entry) {
           const bool may_fail =
               known_failures ? is_known_failure(*entry.vector) : !entry.vector->required;
           return is_pass(entry) || may_fail;
         });
}

std::string conformance_text(const ConformanceReport& report) {
  constexpr std::size_t kListed = 5;  // of each kind; JSON has all
  std::string text;
  for (const TableRow& row : table_of(report, "", "all vectors")) {
    text += fmt::format("{:<18}{:>10}{:>10}{:>10}{:>10}\n", row[0], row[1], row[2], row[3], row[4]);
  }
  for (const auto& [kind, entries] : failures_of(report)) {
    text += "\n" + title_of(kind, entries.size()) + "\n";
    for (std::size_t i = 0; i < std::min(entries.size(), kListed); ++i) {
      text += fmt::format("  {}: {}\n", entries[i]->vector->id, failure_text(*entries[i]));
      const std::string said = last_line(entries[i]->printed);
      if (i == 0 && !said.empty()) text += fmt::format("    it printed: {}\n", said);
    }
    if (entries.size() > kListed) text += fmt::format("  and {} more\n", entries.size() - kListed);
  }
  return text + "\n" + excess_text(report) + tightness_sentence(report) + not_run_sentence(report) +
         known_sentence(report) + verdict_sentence(report);
}

std::string conformance_markdown(const ConformanceReport& report) {
  std::string text = fmt::format("# Conformance of `{}`\n\n", as_utf8(report.program));
  for (const std::string& paragraph :
       {verdict_sentence(report), excess_text(report), tightness_sentence(report),
        not_run_sentence(report), known_sentence(report)}) {
    if (!paragraph.empty()) text += paragraph + "\n";
  }
  const std::vector<TableRow> table = table_of(report, "flag", "**all vectors**");
  for (const TableRow& row : table) {
    text += fmt::format("| {} |\n", fmt::join(row, " | "));
    if (&row == &table.front()) text += "|---|---|---|---|---|\n";
  }
  for (const auto& [kind, entries] : failures_of(report)) {
    text += "\n## " + title_of(kind, entries.size()) + "\n\n";
    for (const ConformanceEntry* entry : entries) {
      text += fmt::format("- `{}` (level {}{}): {}\n", entry->vector->id, entry->vector->level,
                          entry->vector->required ? "" : ", not required", failure_text(*entry));
      const std::string said = last_line(entry->printed);
      if (entry == entries.front() && !said.empty()) {
        text += fmt::format("\n  It printed: `{}`\n", said);
      }
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

Json conformance_json(const ConformanceReport& report) {
  const ScoreMatrix matrix = matrix_of(report);
  Json flags = Json::object(), outcomes = Json::object(), reasons = Json::object();
  Json entries = Json::array();
  for (const auto& [flag, row] : matrix.flags) flags[flag] = row_json(row);
  for (const Outcome outcome : kAllOutcomes) outcomes[name_of(outcome)] = 0;
  for (const ConformanceEntry& entry : report.entries) {
    Json& count = outcomes[name_of(entry.result.outcome())];
    count = count.count() + 1;
    entries.push_back(conformance_entry_json(entry));
  }
  std::size_t not_run = 0;
  for (const auto& [reason, count] : report.not_run) {
    reasons[name_of(reason)] = count;
    not_run += count;
  }
  const ExcessHistogram histogram = excess_histogram(report);
  Json document = {
      {"program", report.program},
      {"promise", promise_json(report)},
      {"conforms", report.conforms()},
      {"asked", report.asked()},
      {"passed", report.passed()},
      {"total", report.entries.size()},
      {"not_run", not_run},
      {"not_run_reasons", reasons},
      {"outcomes", outcomes},
      {"excess", {{"none", histogram.none}, {"vectors", histogram_json(histogram.by_decade)}}},
      {"flags", flags},
      {"all", row_json(matrix.all)},
      {"vectors", entries}};
  if (report.known_failures) document["known_failures"] = known_json(report);
  return document;
}

}  // namespace convexact
