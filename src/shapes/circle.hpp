// SPDX-License-Identifier: MIT
// circle.hpp - points of a circle as doubles that are the same on every platform.
#pragma once
#include <cstdint>

namespace convexact::shapes {

struct CirclePoint {
  double cosine;
  double sine;
};

/// Cosine and sine of the angle 2 pi k / n, each rounded to a nearest double from 128 bits. They
/// come from MPFR, not from the C library, whose last bits differ between platforms, and from one
/// octant: mirrored angles have exactly mirrored points, and the axes and diagonals are met
/// exactly. Precondition: n >= 1 and k, n < 2^61.
[[nodiscard]] CirclePoint on_circle(std::uint64_t k, std::uint64_t n);

}  // namespace convexact::shapes
