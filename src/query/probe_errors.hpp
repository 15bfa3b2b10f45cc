// SPDX-License-Identifier: MIT
// probe_errors.hpp - the values of planes along a line in doubles, and their error bounds.
#pragma once
#include "near/near_plane.hpp"
#include "number/roundoff.hpp"

namespace convexact {

// Error of the value of a plane at a point, |y_k| <= 1, or at a vertex, whose coordinates are
// rounded as well, with u = kUnitRoundoff. The normal's components are at most 1, each off by at
// most u/2; the offset is below 2, because the plane meets the frame's ball, so off by at most u:
// together 5u/2. The vertex's coordinates are off by u/2 each: 3u/2. Three products of at most 1
// are off by u/2 each: 3u/2. The sums are at most 2, 3 and 5, so off by at most u, 2u and 4u. All
// of it is 25u/2. Values themselves are at most 5. For a ProbePlane at a vertex the same terms are
// smaller.
inline constexpr double kPlaneError = 16 * kUnitRoundoff;

// Of the difference w of two such values, at most 10: twice that, and its rounding, 8u.
inline constexpr double kSlopeError = 3 * kPlaneError;

// Of v + t w for |t| <= 4: kPlaneError + 4 kSlopeError, and roundings of a product and a sum of at
// most 45, 64u, so below 17 kPlaneError. Of v_i w_j - w_i v_j: two products of values of at most 5
// and slopes of at most 10, each off by 5 kSlopeError + 10 kPlaneError, and by products of errors
// below kPlaneError; and the roundings of numbers of at most 100, 64u each: below 64 kPlaneError.
inline constexpr double kLineError = 64 * kPlaneError;
inline constexpr double kMostT = 4;

/// Along a line, first + t (second - first): of a plane, its value where t = 0, and its slope.
struct LineValues {
  double at_first = 0, slope = 0;

  LineValues() = default;
  LineValues(const DoubleHalfspace& plane, const Point& first, const Point& second)
      : at_first(plane(first)), slope(plane(second) - at_first) {}

  /// Off by at most kLineError for |t| <= kMostT.
  double at(double t) const { return at_first + t * slope; }
  /// For slopes < 0 < exit.slope, the parts of the line beyond either plane: how far the line is
  /// from being on the inner side of both, times both slopes. Off by at most kLineError.
  double gap_before(const LineValues& exit) const {
    return at_first * exit.slope - slope * exit.at_first;
  }
};

}  // namespace convexact
