// SPDX-License-Identifier: MIT
// conformance_report.hpp - how a program did on the vectors: as text, Markdown, JSON and a badge.
#pragma once
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "convexact/conform.hpp"

namespace convexact {

/// One vector and the result of a program on it. The vector outlives this.
struct ConformanceEntry {
  const TestVector* vector;
  Conformance result;
  double seconds;  ///< Of the program.
};

struct ConformanceReport {
  std::string program;  ///< The command as it was given.
  std::string profile;  ///< Its name, or empty.
  Promise promise;
  std::vector<ConformanceEntry> entries;       ///< In the order of the vectors.
  std::map<NotRun, std::size_t> not_run = {};  ///< How many vectors were not run, and why.

  std::size_t passed() const;
  /// Whether every required vector passed.
  bool conforms() const;
};

/// A matrix of passed/total by flag and level, the failures by kind and the worst first, how far
/// points are outside, and how tight the outputs are.
[[nodiscard]] std::string conformance_text(const ConformanceReport& report);
/// The same as a Markdown document.
[[nodiscard]] std::string conformance_markdown(const ConformanceReport& report);
/// docs/schema/conformance.schema.json.
[[nodiscard]] nlohmann::ordered_json conformance_json(const ConformanceReport& report);
/// A small SVG: "convexact" and passed/total; green if the program conforms.
[[nodiscard]] std::string conformance_badge(const ConformanceReport& report);

}  // namespace convexact
