// SPDX-License-Identifier: MIT
// proof.hpp - a run as the text that convexact-check proves again.
#pragma once
#include <optional>
#include <string>

#include "convexact/simplify.hpp"
#include "convexact/stored.hpp"

namespace convexact {

/// Writes the proof of a run; docs/proof-format.md has the format and why it proves what it does.
/// The exact cost of every evaluation is computed here, by the exact engine's caps.
/// @param points  That the run had to hold, in the order of the ids in `start`.
/// @param stored  The result as it is stored; none where it is stored as exact integers.
/// @throws Error  Internal if the run has no proof: then the run was wrong.
/// @par Cost      An exact cap for each evaluation.
[[nodiscard]] std::string write_proof(const RunStart& start, const Run& run, const PointSet& points,
                                      const std::optional<StoredPlanes>& stored);

}  // namespace convexact
