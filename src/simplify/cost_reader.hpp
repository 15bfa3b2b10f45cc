// SPDX-License-Identifier: MIT
// cost_reader.hpp - reads a cost as write_trace_json() spells it.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "convexact/cost.hpp"

namespace convexact {

/// The exact number of the object of a cost: what "exact", "roots" or "edges" spell, by the
/// measure; none if the object does not have that key.
/// @throws Error Malformed if the key holds anything else.
[[nodiscard]] std::optional<Cost> cost_in_json(const nlohmann::json& object, CostMeasure measure);

}  // namespace convexact
