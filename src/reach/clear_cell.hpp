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
/// @return Nothing if the part has no planes, or is so thin that points would move too far.
[[nodiscard]] std::optional<NearPart> inner_part(const ReachCells& cells, const NearPart& part);

/// Whether it is certain that all points that a part and a cell have in common are inside of the
/// solid, as no triangle runs through them and the surface winds about one of them.
/// @param y  A point of the part, up to rounding; the nearer to the center of the cell the better.
[[nodiscard]] bool is_clear_inside(const ReachCells& cells, const NearPart& part,
                                   const MetCell& met, const Point& y);

}  // namespace convexact
