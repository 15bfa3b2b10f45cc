// SPDX-License-Identifier: MIT
// flat.hpp - points that span no volume, exactly, in no special position.
#pragma once
#include <cstdint>
#include <vector>

#include "convexact/point_set.hpp"

namespace convexact::shapes {

/// n copies of one point: affine dimension 0.
[[nodiscard]] std::vector<Point> all_equal(std::uint32_t n);
/// n points of a line that no coordinate plane is parallel to, repeats possible. The first two
/// differ, so that n >= 2 have affine dimension 1.
[[nodiscard]] std::vector<Point> collinear(std::uint32_t n, std::uint64_t seed);
/// n points of a plane that no axis is parallel to, repeats possible. The first three are not
/// collinear, so that n >= 3 have affine dimension 2.
[[nodiscard]] std::vector<Point> coplanar(std::uint32_t n, std::uint64_t seed);

}  // namespace convexact::shapes
