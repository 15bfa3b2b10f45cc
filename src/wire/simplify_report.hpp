// SPDX-License-Identifier: MIT
// simplify_report.hpp - what a run or a hull found: for machines (docs/schema/result.schema.json)
// and for people.
#pragma once
#include <string>

#include "convexact/simplify.hpp"
#include "io/json_document.hpp"

namespace convexact {

/// One result without its stages.
[[nodiscard]] Json result_json(const SimplifyResult& result);
/// All parts of a scene together, without stages.
[[nodiscard]] Json totals_json(const SceneTotals& totals, const Gaps& gaps);
[[nodiscard]] Json gaps_json(const Gaps& gaps);
[[nodiscard]] Json hull_json(const HullResult& result, int digits);

/// A few lines: what was found, how tight it is, what was verified, how far it was pushed.
/// @param verbose  Also how steps were proven, and what rounding added.
/// "+6.108%", certain digits only.
[[nodiscard]] std::string growth_percent(const Enclosure& before, const Enclosure& after);
[[nodiscard]] std::string summary(const SimplifyResult& result, bool verbose);
/// The same of all parts of a scene together.
[[nodiscard]] std::string summary(const SceneTotals& totals, const Gaps& gaps);
/// Counts, box, and each measure with `digits` certain digits.
[[nodiscard]] std::string summary(const HullResult& result, int digits, bool verbose);

}  // namespace convexact
