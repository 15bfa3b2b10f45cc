// SPDX-License-Identifier: MIT
// stress_report.hpp - what a sweep found, for people and for machines.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "stress/stress_result.hpp"

namespace convexact {

/// Everything: docs/schema/stress.schema.json. Infinite numbers are the string "infinite".
[[nodiscard]] nlohmann::ordered_json stress_json(const StressReport& report);

/// One line for each family and engine with the worst of its runs, then the faults; at most 100
/// columns but for the faults' sentences.
[[nodiscard]] std::string stress_table(const StressReport& report);
/// One line for each run, then the faults.
[[nodiscard]] std::string stress_case_table(const StressReport& report);

}  // namespace convexact
