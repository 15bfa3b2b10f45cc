// SPDX-License-Identifier: MIT
// integer.hpp - integer points in exactly special positions: on a sphere, on the moment curve.
#pragma once
#include <cstdint>
#include <vector>

#include "convexact/point_set.hpp"

namespace convexact::shapes {

/// At most n of the integer points with x^2 + y^2 + z^2 = `squared_radius` <= 10^6, drawn without
/// repeats: exactly cospherical, so every one is extreme, and many are coplanar.
/// @throws Error InvalidArgument if fewer than 4 such points exist; there are none for
///         4^a (8 b + 7), by Legendre's theorem.
[[nodiscard]] std::vector<Point> cospherical(std::uint32_t n, std::uint32_t squared_radius,
                                             std::uint64_t seed);

/// The points (t, t^2, t^3) for 4 <= n <= 10^5 consecutive integers t around 0: no four coplanar.
/// The hull is the cyclic polytope: n vertices, 2n - 4 triangles, of which n - 1 meet in each of
/// the first and the last point.
/// @par Source  [Ziegler1995, sec. 0]
[[nodiscard]] std::vector<Point> moment_curve(std::uint32_t n);

}  // namespace convexact::shapes
