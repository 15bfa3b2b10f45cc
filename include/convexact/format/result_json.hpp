// SPDX-License-Identifier: MIT
// result_json.hpp - what a run found, for machines: docs/schema/result.schema.json.
#pragma once
#include <nlohmann/json_fwd.hpp>

#include "convexact/pipeline/hull_measures.hpp"
#include "convexact/pipeline/simplify.hpp"

namespace convexact {

/// {"value": nearest double of the digits, or null beyond the largest; "decimal": `digits` certain
/// digits} and, where it is known, "exact": "p/q". The bounds must be narrow enough for the digits.
[[nodiscard]] nlohmann::ordered_json measured_json(const Measured& x, int digits);

[[nodiscard]] nlohmann::ordered_json stages_json(const std::vector<Stage>& stages);

/// One result without its stages.
[[nodiscard]] nlohmann::ordered_json result_json(const SimplifyResult& result);
[[nodiscard]] nlohmann::ordered_json hull_json(const HullResult& result, int digits);

/// The proof that an input is no solid: its kind, and the numbers that a reader needs to check it.
[[nodiscard]] nlohmann::ordered_json proof_json(const NotSolid& reason);

}  // namespace convexact
