// SPDX-License-Identifier: MIT
// parts_verdict.hpp - the verdict on a decomposition, for machines
// (docs/schema/verdict.schema.json) and for people.
#pragma once
#include <string>

#include "convexact/verify_parts.hpp"
#include "io/json_document.hpp"

namespace convexact {

/// "verdict", "claims", "parts", "surface", "outside", "uncovered", "measures", "notes".
[[nodiscard]] Json parts_verdict_json(const PartsVerdict& verdict);

/// A line for each claim that was asked, then the surface, the parts and the measures, then the
/// verdict.
[[nodiscard]] std::string parts_verdict_text(const PartsVerdict& verdict);

}  // namespace convexact
