// SPDX-License-Identifier: MIT
// mean_width.hpp - mean width of a polytope.
#pragma once
#include "convexact/geometry/polytope.hpp"
#include "convexact/number/enclosure.hpp"
#include "convexact/watch.hpp"

namespace convexact {

/// The width of the polytope between two parallel planes, averaged over all directions, in length
/// units: the sum over the edges of length times exterior dihedral angle, over 4 pi. A ball
/// of diameter D has D, a cube of side a has 3a/2. Relative width about 2^-precision.
/// @throws Error Stopped, as the watch says.
/// @par Cost    Two roots and one arctangent per edge.
/// @par Source  [Schneider2014, sec. 4.2]; docs/measures.md derives it.
[[nodiscard]] Enclosure mean_width(const Polytope& polytope, long precision,
                                   const Watch& watch = {});

}  // namespace convexact
