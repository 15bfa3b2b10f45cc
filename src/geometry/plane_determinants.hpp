// SPDX-License-Identifier: MIT
// plane_determinants.hpp - signs of the determinants of plane coefficients: doubles where these
// decide, else integers.
#pragma once
#include <array>
#include <optional>

#include "convexact/halfspace.hpp"
#include "convexact/number.hpp"

namespace convexact {

/// D(a, b, c) = det(n_a, n_b, n_c), exactly. For x <= 0, y <= 0, z <= 0 in this order it is 1.
[[nodiscard]] Integer normal_determinant(const Halfspace& a, const Halfspace& b,
                                         const Halfspace& c);

/// H(a, b, c, p), the determinant of the rows (n, d) of four halfspaces, exactly. For x <= 0, y <=
/// 0, z <= 0 and -x-y-z-1 <= 0 it is -1.
[[nodiscard]] Integer plane_determinant(const Halfspace& a, const Halfspace& b, const Halfspace& c,
                                        const Halfspace& p);

/// (n, d) of a halfspace in doubles: multiplied by a power of two that brings the largest of them
/// into [1/2, 1), each off by less than 2^-52 of itself (or underflowed). Worth keeping where a
/// halfspace takes part in many determinants.
using PlaneRow = std::array<double, 4>;
[[nodiscard]] PlaneRow plane_row(const Halfspace& h);

/// The signs of D and H where doubles are certain of them. About 30 and 100 flops.
[[nodiscard]] std::optional<Sign> certain_normal_sign(const PlaneRow& a, const PlaneRow& b,
                                                      const PlaneRow& c);
[[nodiscard]] std::optional<Sign> certain_plane_sign(const PlaneRow& a, const PlaneRow& b,
                                                     const PlaneRow& c, const PlaneRow& p);

/// The signs of D and H, always.
[[nodiscard]] Sign normal_sign(const Halfspace& a, const Halfspace& b, const Halfspace& c);
[[nodiscard]] Sign plane_sign(const Halfspace& a, const Halfspace& b, const Halfspace& c,
                              const Halfspace& p);

/// Whether the planes of a dual triangle, counter-clockwise from outside, meet in a vertex that
/// bounds the halfspaces (D > 0). Else they are unbounded in a direction common to the three.
[[nodiscard]] inline bool is_bounded(const Halfspace& a, const Halfspace& b, const Halfspace& c) {
  return normal_sign(a, b, c) == Sign::Positive;
}

/// Whether dual point p lies strictly beyond the dual triangle a, b, c, counter-clockwise from
/// outside (H > 0). It does not depend on the center of the duality.
[[nodiscard]] inline bool is_beyond(const Halfspace& a, const Halfspace& b, const Halfspace& c,
                                    const Halfspace& p) {
  return plane_sign(a, b, c, p) == Sign::Positive;
}

}  // namespace convexact
