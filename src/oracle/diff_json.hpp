// SPDX-License-Identifier: MIT
// diff_json.hpp - how engines compare, for machines (docs/schema/diff.schema.json) and for people.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "oracle/diff.hpp"

namespace convexact {

/// One object's report without its name and stages. Where two runs differ first and worst, costs
/// are exact, of any length.
[[nodiscard]] nlohmann::ordered_json diff_json(const DiffReport& report);

struct NamedDiff {
  std::string name;
  const DiffReport* report;
};

/// A table with a row per object and comparison, then where each pair differs first and worst, with
/// planes and costs.
[[nodiscard]] std::string diff_table(const std::vector<NamedDiff>& objects);

}  // namespace convexact
