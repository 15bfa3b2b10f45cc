// SPDX-License-Identifier: MIT
// orientation.hpp - which triangles of a surface are to be turned.
#pragma once
#include <vector>

#include "convexact/surface.hpp"

namespace convexact {

/// Which triangles to turn, and what was found on the way.
struct Orientation {
  std::vector<bool> turns;          ///< By triangle.
  std::vector<bool> has_one_side;   ///< By component: some patch of it is like a Moebius strip.
  std::size_t ambiguous_edges = 0;  ///< At which patches meet in more ways than one, or in none.
};

/// A *patch* is connected over edges of exactly two triangles. (1) Each is made consistent, so that
/// these edges cancel; one that has a single side stays as it is. (2) Patches that are not closed
/// by themselves are joined where they meet at an edge of up to four triangles that exactly one
/// choice of their directions makes cancel. (3) What is joined keeps the direction that has the
/// larger area: sums of roots, compared by enclosures of up to kAreaBits; where these overlap, the
/// direction of more triangles, then that of the lowest. (4) What is closed then is turned as
/// find_inside_out() says.
/// @throws Error Stopped when the watch ends the call.
[[nodiscard]] Orientation find_orientation(const Surface& surface, const Watch& watch);

/// Of the finest enclosures of areas.
inline constexpr long kAreaBits = 512;

}  // namespace convexact
