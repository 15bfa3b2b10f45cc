// SPDX-License-Identifier: MIT
// proof.hpp - the proof of a run, for convexact-check.
#pragma once
#include <optional>
#include <string>

#include "convexact/simplify.hpp"
#include "convexact/stored.hpp"
#include "io/names.hpp"

namespace convexact {

/// What a proof claims of a run, under the names of docs/proof-format.md.
enum class ProofClaim {
  Greedy,         ///< Each removal adds the least volume.
  GreedyArea,     ///< Each removal adds the least area.
  Costs,          ///< The volumes that the removals add.
  CostsNotShown,  ///< The removals alone.
  Optimal,        ///< No other planes, as many, bound a smaller volume.
};

inline constexpr auto kProofClaimNames =
    name_table<ProofClaim>({{ProofClaim::Greedy, "greedy"},
                            {ProofClaim::GreedyArea, "greedy-area"},
                            {ProofClaim::Costs, "costs"},
                            {ProofClaim::CostsNotShown, "costs-not-shown"},
                            {ProofClaim::Optimal, "optimal"}});

/// The claim of the proof of a run. Where a search led elsewhere without a proof it is Costs, of
/// the removals that lead there.
/// @throws Error  Internal for a run by area that is not greedy.
[[nodiscard]] ProofClaim proof_claim(const Run& run);

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
