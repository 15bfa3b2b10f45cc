// SPDX-License-Identifier: MIT
// merge_by_reach.hpp - parts merged as long as their common hull stays near the solid.
#pragma once
#include <vector>

#include "convexact/decompose.hpp"
#include "convexact/reach.hpp"

namespace convexact {

/// Merges, one after another, the two parts whose common hull adds the least volume among those
/// that the limit allows, until there are none; parts whose boxes are farther apart than T are
/// never tried. Volumes are compared as doubles around their enclosures, so that every machine
/// sorts alike; no proof depends on the order. What merges with a part follows it in `merged`.
/// @param distance  T in length units, rounded up.
/// @return By part as it was, its place now, or that of the one that it merged with.
/// @throws Error Stopped when the watch ends the call.
std::vector<std::size_t> merge_by_reach(std::vector<Part>& parts, ReachLimit& limit,
                                        const Rational& distance, const Watch& watch);

}  // namespace convexact
