// SPDX-License-Identifier: MIT
// prisms.hpp - solids over a k-gon, k >= 3, inscribed in the unit circle of the xy-plane.
#pragma once
#include <cstdint>
#include <vector>

#include "convexact/point_set.hpp"

namespace convexact::shapes {

// The polygon's corners are on_circle(i, k): regular up to rounding, with exact mirror images.

/// z from -1/2 to 1/2; all facets exactly plane. 2k vertices, k + 2 facets.
[[nodiscard]] std::vector<Point> prism(std::uint32_t k);
/// The upper k-gon turned by half a side; both k-gons exactly plane. 2k vertices, 2k + 2 facets.
[[nodiscard]] std::vector<Point> antiprism(std::uint32_t k);
/// Apex (0, 0, 1); the base exactly plane. k + 1 vertices, k + 1 facets.
[[nodiscard]] std::vector<Point> pyramid(std::uint32_t k);
/// Apexes (0, 0, +-1). k + 2 vertices, 2k facets.
[[nodiscard]] std::vector<Point> bipyramid(std::uint32_t k);
/// The prism's hull from `rings` >= 2 copies of the k-gon: rings * k points of which those of the
/// inner rings lie exactly on edges. 2k vertices, k + 2 facets.
[[nodiscard]] std::vector<Point> cylinder(std::uint32_t k, std::uint32_t rings);
/// The pyramid's hull from 1 <= `rings` <= 50 copies of the k-gon, each half as large as the one
/// below and exactly on the edges to the apex. rings * k + 1 points, k + 1 vertices, k + 1 facets.
[[nodiscard]] std::vector<Point> cone(std::uint32_t k, std::uint32_t rings);

}  // namespace convexact::shapes
