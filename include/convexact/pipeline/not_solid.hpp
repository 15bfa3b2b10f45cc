// SPDX-License-Identifier: MIT
// not_solid.hpp - inputs that enclose no bounded volume, each with its proof.
#pragma once
#include <string>
#include <variant>

#include "convexact/hull/hull.hpp"
#include "convexact/lp/feasibility.hpp"

namespace convexact {

/// Points that span no volume, or halfspaces whose intersection is empty, flat or unbounded.
using NotSolid = std::variant<FlatInput, EmptyProof, FlatProof, RecessionRay>;

/// One sentence for people: what the input is, and what the proof consists of.
[[nodiscard]] std::string describe(const NotSolid& reason);

}  // namespace convexact
