// SPDX-License-Identifier: MIT
// nesting.hpp - which closed components of a surface are inside out.
#pragma once
#include <vector>

#include "convexact/surface.hpp"

namespace convexact {

/// Whether each component is to be turned as a whole: a consistent closed one that lies in no
/// other, if its signed volume is negative; one that lies in others, if the outermost of them is.
/// The components' own fields are filled in.
[[nodiscard]] std::vector<bool> find_inside_out(const Surface& surface, const Watch& watch);

}  // namespace convexact
