// SPDX-License-Identifier: MIT
// conformance_report.hpp - how a program did on the vectors: as text, Markdown, JSON and a badge,
// and the sums that these have in common.
#pragma once
#include <array>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "convexact/conform.hpp"

namespace convexact {

/// A matrix of passed/total by flag and level, the failures by kind and the worst first, how far
/// points are outside, and how tight the outputs are.
[[nodiscard]] std::string conformance_text(const ConformanceReport& report);
/// The same as a Markdown document.
[[nodiscard]] std::string conformance_markdown(const ConformanceReport& report);
/// docs/schema/conformance.schema.json.
[[nodiscard]] nlohmann::ordered_json conformance_json(const ConformanceReport& report);
/// A small SVG: "convexact" and passed/total; green if the program conforms.
[[nodiscard]] std::string conformance_badge(const ConformanceReport& report);

inline constexpr int kLevels = 3;

struct Score {
  std::size_t passed = 0, total = 0;

  void add(bool is_pass) {
    ++total;
    passed += is_pass ? 1 : 0;
  }
};

/// One row of the matrix: the levels, then all of them.
using ScoreRow = std::array<Score, kLevels + 1>;

struct ScoreMatrix {
  std::map<std::string, ScoreRow> flags;  ///< By name; a vector counts under each of its flags.
  ScoreRow all;
};
[[nodiscard]] ScoreMatrix matrix_of(const ConformanceReport& report);

inline bool is_pass(const ConformanceEntry& entry) { return entry.result.failures.empty(); }

/// The square of the distance of the worst point outside over the square of the diameter; 0 if no
/// point is outside; nothing if there is no solid.
[[nodiscard]] std::optional<Rational> squared_excess(const Conformance& result);

/// How many vectors have their worst excess above one bound and up to the next, by the upper bound
/// as an exponent of ten; nothing stands for vectors without excess.
[[nodiscard]] std::map<std::optional<int>, std::size_t> excess_histogram(
    const ConformanceReport& report);

}  // namespace convexact
