// SPDX-License-Identifier: MIT
// verdict_report.hpp - verdicts as JSON (docs/schema/verdict.schema.json) and as a table for
// people.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "convexact/verify.hpp"

namespace convexact {

/// {"verdict", "claims", "candidate", "outside", "tightness", "notes"}; numbers that are not
/// doubles are strings, exact ones as fractions.
[[nodiscard]] nlohmann::ordered_json verdict_json(const Verdict& verdict);

/// A line for each claim that was asked, then how tight the candidate is, then the verdict.
[[nodiscard]] std::string verdict_table(const Verdict& verdict);

}  // namespace convexact
