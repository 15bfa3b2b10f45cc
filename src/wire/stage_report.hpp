// SPDX-License-Identifier: MIT
// stage_report.hpp - what every command that runs stages says: how long they took, and why an input
// is no solid.
#pragma once
#include <string>
#include <vector>

#include "convexact/scene.hpp"
#include "io/json_document.hpp"

namespace convexact {

[[nodiscard]] Json stages_json(const std::vector<Stage>& stages);

/// One line: the time of all stages, the longest of them, and how many were not needed. Or a table
/// of all stages, those that were not needed with their reasons.
[[nodiscard]] std::string stage_text(const std::vector<Stage>& stages, bool list_all);

/// The proof that an input is no solid: its kind, and the numbers that a reader needs to check it.
[[nodiscard]] Json proof_json(const NotSolid& reason);

}  // namespace convexact
