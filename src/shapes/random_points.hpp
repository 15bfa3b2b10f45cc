// SPDX-License-Identifier: MIT
// random_points.hpp - seeded points in and on simple solids; the same doubles on every platform.
#pragma once
#include <cstdint>
#include <vector>

#include "convexact/point_set.hpp"

namespace convexact::shapes {

// Only +, -, *, / and sqrt of doubles are used, which IEEE 754 rounds correctly, or MPFR.

/// n points uniform in [-1, 1)^3, coordinates multiples of 2^-52.
[[nodiscard]] std::vector<Point> in_box(std::uint32_t n, std::uint64_t seed);
/// n points uniform in the unit ball.
[[nodiscard]] std::vector<Point> in_ball(std::uint32_t n, std::uint64_t seed);
/// n points uniform on the unit sphere, up to rounding.
[[nodiscard]] std::vector<Point> on_sphere(std::uint32_t n, std::uint64_t seed);
/// n points of on_sphere(), each `copies` >= 1 times, in random order: exact duplicates.
[[nodiscard]] std::vector<Point> repeated_sphere(std::uint32_t n, std::uint32_t copies,
                                                 std::uint64_t seed);
/// n points uniform in {-range, ..., range}^3: repeats, coplanar and collinear points.
/// Precondition: range <= 2^52.
[[nodiscard]] std::vector<Point> lattice(std::uint32_t n, std::uint64_t range, std::uint64_t seed);
/// n points on the unit sphere along a spiral of golden angles: all costs nearly equal.
/// @par Source  [Gonzalez2010]
[[nodiscard]] std::vector<Point> fibonacci_sphere(std::uint32_t n);

/// n points of in_box() and their images under x -> -x: exact ties in pairs. 2n points.
[[nodiscard]] std::vector<Point> centrally_symmetric(std::uint32_t n, std::uint64_t seed);
/// n points of lattice(range) and their images under all 48 symmetries of the cube: exact ties of
/// up to 48. 48 n points, repeats where a point lies on a mirror.
[[nodiscard]] std::vector<Point> cube_symmetric(std::uint32_t n, std::uint64_t range,
                                                std::uint64_t seed);

}  // namespace convexact::shapes
