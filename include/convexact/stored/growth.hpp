// SPDX-License-Identifier: MIT
// growth.hpp - how far a stored solid is from the exact one, as proven upper bounds.
#pragma once
#include "convexact/geometry/polytope.hpp"

namespace convexact {

/// How rounding changed a solid.
struct Growth {
  /// Upper bound of the Hausdorff distance between the exact and the stored solid, divided by the
  /// diameter of the input (the diagonal of its axis-aligned box). 0 iff they are the same set;
  /// infinity if it is beyond the largest double.
  double push = 0;
  /// Upper bound of the stored solid's volume over the exact one's, from 128 bits; may be below 1,
  /// because both hold the input but not each other. Infinity beyond the largest double.
  double volume_ratio = 1;
};

/// Compares two solids that share an interior point.
/// The distance of a vertex of the one to the other solid is at most that to the nearest vertex,
/// and at most that to where the segment to `center` enters; the lesser counts. So the bound is
/// sharp when vertices move a little, and also when they slide along an edge that is almost flat.
/// @param center   Strictly inside both.
/// @param squared_diameter  Of the input; positive.
/// @par Cost  A double distance for each pair of vertices; exact arithmetic for a few of each
/// vertex.
[[nodiscard]] Growth growth(const Polytope& exact, const Polytope& stored,
                            const RationalPoint& center, const Rational& squared_diameter);

}  // namespace convexact
