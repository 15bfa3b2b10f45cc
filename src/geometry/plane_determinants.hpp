// SPDX-License-Identifier: MIT
// plane_determinants.hpp - the determinants of plane coefficients that decide the shape of dual
// hulls.
#pragma once
#include "convexact/geometry.hpp"
#include "convexact/number.hpp"

namespace convexact {

/// D(a, b, c) = det(n_a, n_b, n_c), exactly: positive iff the planes of a dual triangle,
/// counter-clockwise from outside, meet in a vertex that bounds the halfspaces. For x <= 0, y <= 0,
/// z <= 0 in this order it is 1.
[[nodiscard]] Integer normal_determinant(const Halfspace& a, const Halfspace& b,
                                         const Halfspace& c);

/// H(a, b, c, p), the determinant of the rows (n, d) of four halfspaces, exactly: positive iff dual
/// point p lies strictly beyond the dual triangle a, b, c, wherever the center of the duality is.
/// For x <= 0, y <= 0, z <= 0 and -x-y-z-1 <= 0 it is -1.
[[nodiscard]] Integer plane_determinant(const Halfspace& a, const Halfspace& b, const Halfspace& c,
                                        const Halfspace& p);

}  // namespace convexact
