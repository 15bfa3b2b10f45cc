// SPDX-License-Identifier: MIT
// tie_report.hpp - how ties were proven: for machines and for people.
#pragma once
#include <string>

#include "convexact/run.hpp"
#include "io/json_document.hpp"

namespace convexact {

/// Of one tie: its proof under `key`; with an undecided one, the "bits" of enclosures that still
/// overlap. Empty if there is no tie.
[[nodiscard]] Json tie_json(const TieEvidence& evidence, const char* key = "tie_proof");

/// Of many: their numbers by proof; with undecided ones, the "bits" of the finest enclosures that
/// still overlap.
[[nodiscard]] Json ties_json(const TieTally& ties);

/// How many they are.
[[nodiscard]] std::size_t tie_count(const TieTally& ties);

/// "3 rational, 1 undecided; not told apart by 4096 bits".
[[nodiscard]] std::string tie_proofs_text(const TieTally& ties);

}  // namespace convexact
