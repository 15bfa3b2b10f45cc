// SPDX-License-Identifier: MIT
// conformance_report.hpp - how a program did on the vectors: as text, Markdown, JSON and a badge.
#pragma once
#include <string>

#include "convexact/conform.hpp"
#include "io/json_document.hpp"

namespace convexact {

/// A matrix of passed/total by flag and level, the failures by kind with the worst first, how far
/// points are outside, and how tight the outputs are.
[[nodiscard]] std::string conformance_text(const ConformanceReport& report);
/// The same as a Markdown document.
[[nodiscard]] std::string conformance_markdown(const ConformanceReport& report);
/// docs/schema/conformance.schema.json.
[[nodiscard]] Json conformance_json(const ConformanceReport& report);
/// A small SVG: "convexact" and passed/total; green if the program conforms.
[[nodiscard]] std::string conformance_badge(const ConformanceReport& report);

}  // namespace convexact
