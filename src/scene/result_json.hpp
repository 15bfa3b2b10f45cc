// SPDX-License-Identifier: MIT
// result_json.hpp - what a run found, for machines: docs/schema/result.schema.json.
#pragma once
#include <nlohmann/json_fwd.hpp>

#include "convexact/simplify.hpp"
#include "io/names.hpp"

namespace convexact {

inline constexpr auto kEngineNames = name_table<Engine>(
    {{Engine::Exact, "exact"}, {Engine::Filtered, "filtered"}, {Engine::Float, "float"}});
inline const char* name_of(Engine engine) { return name_in(kEngineNames, engine); }

inline constexpr auto kVerifyLevelNames = name_table<VerifyLevel>(
    {{VerifyLevel::None, "none"}, {VerifyLevel::Local, "local"}, {VerifyLevel::Full, "full"}});

inline constexpr auto kPrecisionNames =
    name_table<Precision>({{Precision::Binary64, "binary64"}, {Precision::Binary32, "binary32"}});

[[nodiscard]] nlohmann::ordered_json stages_json(const std::vector<Stage>& stages);

/// One result without its stages.
[[nodiscard]] nlohmann::ordered_json result_json(const SimplifyResult& result);
[[nodiscard]] nlohmann::ordered_json hull_json(const HullResult& result, int digits);

/// The proof that an input is no solid: its kind, and the numbers that a reader needs to check it.
[[nodiscard]] nlohmann::ordered_json proof_json(const NotSolid& reason);

}  // namespace convexact
