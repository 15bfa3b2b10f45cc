// SPDX-License-Identifier: MIT
// conformance_report.hpp - how a program did on the vectors: as text, Markdown, JSON and a badge.
#pragma once
#include <string>

#include "convexact/conform.hpp"
#include "io/json_document.hpp"

namespace convexact {

/// A matrix of passed/total by flag and level, the failures by kind with the worst first and what
/// the program printed then, how far points are outside, and how tight the outputs are.
[[nodiscard]] std::string conformance_text(const ConformanceReport& report);
/// The same as a Markdown document.
[[nodiscard]] std::string conformance_markdown(const ConformanceReport& report);
/// docs/schema/conformance.schema.json.
[[nodiscard]] Json conformance_json(const ConformanceReport& report);
/// A small SVG: "convexact" and passed/total; green if the program conforms.
[[nodiscard]] std::string conformance_badge(const ConformanceReport& report);
/// The XML that services of continuous integration read: a test case for each vector. A known
/// failure is skipped.
[[nodiscard]] std::string conformance_junit(const ConformanceReport& report);
/// The ids of the vectors that failed, one in each line: a list of known failures.
[[nodiscard]] std::string failed_ids(const ConformanceReport& report);
/// What conformance_json() says of a vector.
[[nodiscard]] Json conformance_entry_json(const ConformanceEntry& entry);
/// The last line that a program printed, for people; empty if it printed nothing.
[[nodiscard]] std::string last_line(const std::string& printed);

}  // namespace convexact
