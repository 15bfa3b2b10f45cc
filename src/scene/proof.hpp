// SPDX-License-Identifier: MIT
// proof.hpp - the proof of a run, for convexact-check.
#pragma once
#include <optional>
#include <string>

#include "convexact/simplify.hpp"
#include "convexact/stored.hpp"

namespace convexact {

/// The claim of the proof of a run, as docs/proof-format.md names it: "greedy", "costs",
/// "greedy-area", "costs-not-shown" or "optimal"; where a search led elsewhere without a proof,
/// "costs", of the removals that lead there.
/// @throws Error  Internal for a run by area that is not greedy.
[[nodiscard]] const char* proof_claim(const Run& run);

/// Writes the proof of a run; docs/proof-format.md has the format and why it proves what it does.
/// The exact cost of every evaluation is computed here, by the exact engine's caps. By mean width
/// it shows the removals, and no costs.
/// @param points  That the run had to hold, in the order of the ids in `start`.
/// @param stored  The result as it is stored; none where it is stored as exact integers.
/// @throws Error  Internal if the run has no proof: then the run was wrong.
/// @par Cost      An exact cap for each evaluation.
[[nodiscard]] std::string write_proof(const RunStart& start, const Run& run, const PointSet& points,
                                      const std::optional<StoredPlanes>& stored);

}  // namespace convexact
