// SPDX-License-Identifier: MIT
// result_json.hpp - the result of a run as JSON (docs/schema/result.schema.json), as text for
// people, and as a proof for convexact-check.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "convexact/simplify.hpp"
#include "convexact/simplify_scene.hpp"
#include "convexact/stored.hpp"
#include "io/names.hpp"

namespace convexact {

inline constexpr auto kEngineNames = name_table<Engine>(
    {{Engine::Exact, "exact"}, {Engine::Filtered, "filtered"}, {Engine::Float, "float"}});
inline const char* name_of(Engine engine) { return name_in(kEngineNames, engine); }

inline constexpr auto kSearchKindNames = name_table<SearchKind>({{SearchKind::None, "none"},
                                                                 {SearchKind::Walk, "walk"},
                                                                 {SearchKind::Local, "local"},
                                                                 {SearchKind::Optimal, "optimal"}});

inline constexpr auto kVerifyLevelNames = name_table<VerifyLevel>(
    {{VerifyLevel::None, "none"}, {VerifyLevel::Local, "local"}, {VerifyLevel::Full, "full"}});

inline constexpr auto kPrecisionNames =
    name_table<Precision>({{Precision::Binary64, "binary64"}, {Precision::Binary32, "binary32"}});

[[nodiscard]] nlohmann::ordered_json stages_json(const std::vector<Stage>& stages);

/// Steps with a tie, by their proof; with undecided ones, the bits of enclosures that still
/// overlap.
[[nodiscard]] nlohmann::ordered_json ties_json(const TieTally& ties);

/// One result without its stages.
[[nodiscard]] nlohmann::ordered_json result_json(const SimplifyResult& result);
/// All parts of a scene together, without stages.
[[nodiscard]] nlohmann::ordered_json totals_json(const SceneTotals& totals, const Gaps& gaps);
[[nodiscard]] nlohmann::ordered_json gaps_json(const Gaps& gaps);
[[nodiscard]] nlohmann::ordered_json hull_json(const HullResult& result, int digits);

/// The proof that an input is no solid: its kind, and the numbers that a reader needs to check it.
[[nodiscard]] nlohmann::ordered_json proof_json(const NotSolid& reason);

/// A few lines: the result, how tight it is, what was verified, and how far rounding pushed it.
[[nodiscard]] std::string summary(const SimplifyResult& result);
/// The same for all parts of a scene together.
[[nodiscard]] std::string summary(const SceneTotals& totals, const Gaps& gaps);
/// Counts, box, and each measure with `digits` certain digits.
[[nodiscard]] std::string summary(const HullResult& result, int digits);

/// One line: the time of all stages, the longest of them, and how many were not needed; or a table
/// of all stages, those that were not needed with their reasons.
[[nodiscard]] std::string stage_text(const std::vector<Stage>& stages, bool list_all);

/// The claim of the proof of a run, as docs/proof-format.md names it: "greedy", "costs",
/// "greedy-area", "costs-not-shown" or "optimal"; where a search led elsewhere without a proof,
/// "costs", for the removals that lead there.
/// @throws Error  Internal for a run by area that is not greedy.
[[nodiscard]] const char* proof_claim(const Run& run);

/// Writes the proof of a run; docs/proof-format.md has the format and why it proves what it does.
/// The exact cost of every evaluation is computed here, by the exact engine's caps. For a run by
/// mean width it shows the removals, and no costs.
/// @param points  The points that the run had to hold, in the order of the ids in `start`.
/// @param stored  The result as it is stored; none where it is stored as exact integers.
/// @throws Error  Internal if the run has no proof: then the run was wrong.
/// @par Cost      An exact cap for each evaluation.
[[nodiscard]] std::string write_proof(const RunStart& start, const Run& run, const PointSet& points,
                                      const std::optional<StoredPlanes>& stored);

}  // namespace convexact
