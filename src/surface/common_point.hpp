// SPDX-License-Identifier: MIT
// common_point.hpp - the common points of two triangles on points of one set, exactly.
#pragma once
#include "surface/flat_polygon.hpp"

namespace convexact {

/// The sign of orient3d of four points of the set, rational or not.
[[nodiscard]] Sign orient(const PointSet& points, PointId a, PointId b, PointId c, PointId d);

/// Whether two triangles have a common point, their boundaries included; the triangles may have no
/// area.
[[nodiscard]] bool have_common_point(const PointSet& points, const Triangle& s, const Triangle& t);

/// Whether they have one besides the corners and the edge that they share by their ids.
[[nodiscard]] bool cross(const PointSet& points, const Triangle& s, const Triangle& t);

}  // namespace convexact
