// SPDX-License-Identifier: MIT
// shrink.hpp - reduces a failing input to a minimal one: fewer points or halfspaces, then simpler
// numbers.
#pragma once
#include <functional>
#include <span>
#include <vector>

#include "convexact/geometry.hpp"

namespace convexact {

/// Whether points still fail as the first ones did. Equal arguments must give equal answers.
/// @param origin  origin[k]: which of the first points points[k] came from. Ascending.
using StillFails = std::function<bool(const PointSet& points, std::span<const PointId> origin)>;

/// The same for halfspaces.
using HalfspacesStillFail = std::function<bool(std::span<const Halfspace> halfspaces)>;

/// How complicated a coordinate is: the bits of its numerator and of its denominator, so 0 for 0, 1
/// for +-1, 3 for 5 and for 1/4, and 1000 for 2^-999 and for 2^999.
[[nodiscard]] std::size_t coordinate_bits(const Rational& x);
/// The bits of all coordinates, or numbers, together.
[[nodiscard]] std::size_t coordinate_bits(const PointSet& points);
[[nodiscard]] std::size_t coordinate_bits(std::span<const Halfspace> halfspaces);

struct Shrunk {
  PointSet points;
  std::vector<PointId> origin;
  std::size_t tries = 0;  ///< How often `fails` was called.
};

/// Makes a failing point set smaller for as long as it fails. For the result:
/// - leaving out any one point makes it pass;
/// - so does replacing any one coordinate by 0 or by its sign (if that has fewer bits), an integer
///   by half of it, a fraction by the nearest one with a binary digit less.
/// Before single coordinates, all are rounded to one grid, moved to the origin and scaled by powers
/// of two together, so that equal ones stay equal. Deterministic. Binary point sets stay binary.
/// @param progress  Called each time the input has become smaller.
/// @throws Error    InvalidArgument if `points` do not fail; and any error of `fails`.
/// @par Cost        About c log n questions to go from n points to c, c^2 at worst per round; then
///                  some ten per coordinate and round.
/// @par Source      [ZellerHildebrandt2002] for the points.
[[nodiscard]] Shrunk shrink(const PointSet& points, const StillFails& fails,
                            const std::function<void(const PointSet&)>& progress = {});

/// The same for the rows of a list of halfspaces and the four integers of each: of the result, no
/// row can be left out, and no number be replaced by 0, by its sign or by half of it.
[[nodiscard]] std::vector<Halfspace> shrink(
    std::span<const Halfspace> halfspaces, const HalfspacesStillFail& fail,
    const std::function<void(std::span<const Halfspace>)>& progress = {});

}  // namespace convexact
