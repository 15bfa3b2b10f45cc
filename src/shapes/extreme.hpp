// SPDX-License-Identifier: MIT
// extreme.hpp - stiff inputs: needles, slabs, far offsets, the ends of the exponent range, one ulp.
#pragma once
#include <cstdint>
#include <vector>

#include "convexact/point_set.hpp"

namespace convexact::shapes {

/// n points of in_ball() with y and z divided by `aspect` >= 1.
[[nodiscard]] std::vector<Point> needle(std::uint32_t n, double aspect, std::uint64_t seed);
/// n points of in_ball() with z divided by `aspect` >= 1.
[[nodiscard]] std::vector<Point> slab(std::uint32_t n, double aspect, std::uint64_t seed);
/// n points of in_ball() with `distance` added to each coordinate, so that few of their bits are
/// left.
[[nodiscard]] std::vector<Point> offset_ball(std::uint32_t n, double distance, std::uint64_t seed);
/// n points of in_ball() times 2^exponent; exact while nothing leaves the range of normal doubles.
[[nodiscard]] std::vector<Point> scaled_ball(std::uint32_t n, int exponent, std::uint64_t seed);
/// n points of lattice(range) times 2^-1074: every coordinate is subnormal.
/// Precondition: range < 2^52.
[[nodiscard]] std::vector<Point> subnormal(std::uint32_t n, std::uint64_t range,
                                           std::uint64_t seed);
/// n points of in_box() times 1e300: squares overflow.
[[nodiscard]] std::vector<Point> huge(std::uint32_t n, std::uint64_t seed);
/// n points of in_box(), each coordinate times its own power of two from 2^-exponent to 2^exponent.
[[nodiscard]] std::vector<Point> wide_exponents(std::uint32_t n, std::uint32_t exponent,
                                                std::uint64_t seed);
/// n points of the plane z = 1, every second of them `ulps` >= 1 units in the last place (2^-52)
/// above it. Precondition: ulps < 2^52.
[[nodiscard]] std::vector<Point> nearly_flat(std::uint32_t n, std::uint64_t seed,
                                             std::uint64_t ulps = 1);
/// n points (x, y, (x + y) / 3) with x and y uniform in [0, 1), off that plane by the rounding of
/// z, and the apex (1, 0, -1): a lid of many facets that hardly differ.
[[nodiscard]] std::vector<Point> nearly_coplanar(std::uint32_t n, std::uint64_t seed);

/// The box [-1, 1]^2 x [-1, 1] under a lid: n points (x, y, 1 + tilt (1 - (x^2 + y^2) / 2)) with x
/// and y uniform in [-1, 1). Planes of the lid are tilted by about 0 < `tilt` <= 1 against each
/// other; at 2^-52, one ulp of 1, by the rounding of z. n + 8 points.
[[nodiscard]] std::vector<Point> tilted_lid(std::uint32_t n, double tilt, std::uint64_t seed);
/// cospherical(), each coordinate other than 0 moved up or down by at most `ulps` units in its last
/// place, 0 <= ulps <= 2^20: facets with many corners break up.
[[nodiscard]] std::vector<Point> nearly_cospherical(std::uint32_t n, std::uint32_t squared_radius,
                                                    std::uint32_t ulps, std::uint64_t seed);
/// Three balls with their centers on one ray from the origin, n points in each, of radii 1, 2^-e
/// and 2^-2e, 0 <= e <= 500, each 4 radii from the origin: detail at three scales in one hull.
[[nodiscard]] std::vector<Point> mixed_scales(std::uint32_t n, std::uint32_t exponent,
                                              std::uint64_t seed);

}  // namespace convexact::shapes
