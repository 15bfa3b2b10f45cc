// SPDX-License-Identifier: MIT
// planar_patches.hpp - how many facets a solid was meant to have whose vertices are rounded.
#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "convexact/geometry/polytope.hpp"
#include "convexact/number/precision.hpp"

namespace convexact {

/// How far each stored coordinate may be from the one that was meant: u.
struct Slack {
  Precision precision = Precision::Binary64;  ///< Whose units in the last place count.
  unsigned ulps_of_largest = 0;  ///< Of the largest coordinate; 0: half one of each coordinate.
};

/// "half a unit in the last place of each coordinate in binary64" and the like.
[[nodiscard]] std::string describe(const Slack& slack);

/// The format to whose numbers the coordinates were rounded, as far as they tell: binary32 if all
/// are numbers of binary32 and one of them needs more than 16 of its 24 bits; else binary64.
[[nodiscard]] Precision precision_of(const PointSet& points);

/// What rounding in a program may add up to: so many units in the last place of the largest
/// coordinate.
inline constexpr unsigned kRoundingUlps = 16;

/// One unit in the last place of a number of the format; of 0, the least positive number.
[[nodiscard]] Rational unit_in_last_place(Precision precision, const Rational& x);

/// The facets as they were meant, each a list of facets of the solid: the fewest *patches* found. A
/// patch is a set of facets, connected by edges, all of whose corners some plane comes near:
/// |n.p + d| <= |n_1| u_1 + |n_2| u_2 + |n_3| u_3, that is, they become coplanar when each
/// coordinate moves by at most its own u. Such a plane is found by linear programs, exactly.
///
/// Where the solid is thinner along n than 1024 times the right side, rounding might explain
/// anything. There facets stay single, unless all corners of the patch remain corners of the solid
/// meant: three patches or more meet in each. The vertices of a solid of k facets that were rounded
/// pass that test; points of a thin cloud, whose facets happen to be nearly coplanar, do not.
///
/// Patches grow greedily from the largest facet down (where the solid is thin, once more from the
/// smallest up), so that there may be fewer. There are at most as many as facets.
/// @par Cost  Doubles for each edge; for each that may lie inside a patch linear programs with the
///            patch's corners as rows.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> planar_patches(const Polytope& solid,
                                                                     const Slack& slack);

}  // namespace convexact
