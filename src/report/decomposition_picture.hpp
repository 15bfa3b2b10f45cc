// SPDX-License-Identifier: MIT
// decomposition_picture.hpp - convex parts and how they came about, to look at.
#pragma once
#include <string>

#include "convexact/decompose.hpp"
#include "report/picture.hpp"

namespace convexact {

/// The parts, which can be drawn apart; the input coloured by the clusters after any number of
/// merges; and the input coloured by how far a ray from the middle of each triangle runs inside the
/// hull of its cluster, in doubles. Both colourings are hidden at first.
[[nodiscard]] Picture decomposition_picture(const Decomposition& decomposition,
                                            const std::string& title);

}  // namespace convexact
