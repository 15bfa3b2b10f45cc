// SPDX-License-Identifier: MIT
// acceptance.hpp - the tests that a stored solid must pass before it is written, planes and meshes
// alike; and a point inside it from which to measure.
#pragma once
#include <span>
#include <string>

#include "convexact/geometry.hpp"
#include "convexact/number.hpp"
#include "convexact/stored.hpp"

namespace convexact::stored {

/// The mean of `witnesses`, rounded to doubles if it is still strictly inside all of `halfspaces`,
/// otherwise exactly: the mean of points that span a volume is strictly inside every halfspace that
/// holds them.
[[nodiscard]] RationalPoint interior_point(const PointSet& points,
                                           std::span<const PointId> witnesses,
                                           std::span<const Halfspace> halfspaces);

/// @throws Error Unrepresentable, always: "binary32 cannot hold the result: WHY; ...".
[[noreturn]] void refuse(Precision precision, const std::string& why);

/// The final pass: every input point against every halfspace that is about to be written.
/// @return 0. @throws Error Internal if a point is outside.
[[nodiscard]] std::size_t final_pass(std::span<const Halfspace> halfspaces, const PointSet& input);

/// Compares two solids that share an interior point.
/// The distance of a vertex of one solid to the other solid is at most that to the nearest vertex,
/// and at most that to the point where the segment to `center` enters; the smaller one counts. So
/// the bound is sharp when vertices move a little, and also when they slide along an edge that is
/// almost flat.
/// @param center   Strictly inside both.
/// @param squared_diameter  Of the input; positive.
/// @par Cost  n log n for n vertices where both solids have nearly the same; enclosures for a few
/// planes of each vertex that may be the farthest, and exact numbers for those that these leave.
[[nodiscard]] Growth growth(const Polytope& exact, const Polytope& stored,
                            const RationalPoint& center, const Rational& squared_diameter);

/// growth() about an interior point.
/// @throws Error Unrepresentable if the solids are farther apart than the exact one is long.
[[nodiscard]] Growth checked_growth(const Polytope& exact, const Polytope& polytope,
                                    const PointSet& input, std::span<const PointId> witnesses,
                                    Precision precision);

}  // namespace convexact::stored
