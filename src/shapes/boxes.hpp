// SPDX-License-Identifier: MIT
// boxes.hpp - boxes, whole, with cut corners, with flat and with round edges.
#pragma once
#include <cstdint>
#include <vector>

#include "convexact/point_set.hpp"

namespace convexact::shapes {

/// [-a, a] x [-b, b] x [-c, c] for half = (a, b, c) > 0. 8 vertices, 6 facets.
[[nodiscard]] std::vector<Point> box(const Point& half);

/// box(half) with every edge and corner cut off, 0 < width < half: 6 rectangles, 12 rectangles at
/// 45 degrees along the edges, 8 triangles. 24 vertices, 26 facets, exactly plane if half - width
/// is exact.
[[nodiscard]] std::vector<Point> chamfered_box(const Point& half, double width);

/// The sum of box(half) and a ball of `radius` > 0 of which each octant is a grid of `segments` >=
/// 1 steps: 8 (segments (segments + 1) + 1) points, all extreme. The 6 sides and the 12 * segments
/// rectangles along edges are exactly plane; the cells of the corners are plane up to rounding.
[[nodiscard]] std::vector<Point> rounded_box(const Point& half, double radius,
                                             std::uint32_t segments);

/// [0, 1]^3 with `corners` <= 8 of its corners cut off by planes through the points at distance
/// 0 < `depth` <= 1/2 along the three edges: equal cuts, so exact ties if depth and 1 - depth are
/// exact. 8 + 2 * corners points (repeats at depth 1/2), 6 + corners facets.
[[nodiscard]] std::vector<Point> cut_cube(std::uint32_t corners, double depth);

/// The lattice points {0, ..., n-1}^3, n >= 2: most lie inside facets and edges of a cube.
[[nodiscard]] std::vector<Point> grid(std::uint32_t n);

}  // namespace convexact::shapes
