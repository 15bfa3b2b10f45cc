// SPDX-License-Identifier: MIT
// not_solid.hpp - inputs that enclose no bounded volume, each with its proof.
#pragma once
#include <string>
#include <variant>

#include "convexact/geometry/halfspace_list.hpp"
#include "convexact/hull/hull.hpp"
#include "convexact/lp/feasibility.hpp"

namespace convexact {

/// Points that span no volume, or halfspaces whose intersection is empty, flat or unbounded.
using NotSolid = std::variant<FlatInput, EmptyProof, FlatProof, RecessionRay>;

/// A proof about the halfspaces of a list, told of its rows as typed: the multipliers are theirs,
/// so that y'N = 0 holds with the numbers of the file, and rows count from 0, dropped ones
/// included.
/// @param rows  Of the list; without any, the proof stays as it is.
[[nodiscard]] NotSolid of_typed_rows(NotSolid reason, const TypedRows& rows);

/// One sentence for people: what the input is, and what the proof consists of. Points and
/// halfspaces count from 0.
[[nodiscard]] std::string describe(const NotSolid& reason);

}  // namespace convexact
