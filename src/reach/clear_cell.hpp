// SPDX-License-Identifier: MIT
// clear_cell.hpp - cells in which no triangle runs through a part: what the part has there is all
// inside of the solid, however close its facets are to the faces.
#pragma once
#include <optional>

#include "reach/met_cell.hpp"
#include "reach/reach_cells.hpp"

namespace convexact {

/// A part, smaller by so little that it is within T of the solid if the smaller one is in cells
/// that are fine. Facets that lie in faces of the solid, or in walls of cells, do not touch them
/// any more: otherwise cells along them would have to be as small as T.
struct InnerPart {
  NearPart part;
  Point middle;  ///< To which each point x of the part moved, by share (middle - x).
  double share;
};

/// The share of T by which no point of an InnerPart moves farther; cells that are said to be near
/// are so by more than that.
inline constexpr double kInnerSlack = kReachSlack / 2;

/// @return Nothing if the part has no planes, or is so thin that points would move too far.
[[nodiscard]] std::optional<InnerPart> inner_part(const ReachCells& cells, const NearPart& part);

/// A point inside of what a part and a cell have in common, if it is certain that no triangle runs
/// through that: all of it is inside of the solid, or outside, as the point is.
struct ClearPoint {
  Point point;
  bool is_outside;
};
/// @param y  A point of the part, up to rounding; the nearer to the center of the cell the better.
[[nodiscard]] std::optional<ClearPoint> clear_point(const ReachCells& cells, const NearPart& part,
                                                    const MetCell& met, const Point& y);

}  // namespace convexact
