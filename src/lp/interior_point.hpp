// SPDX-License-Identifier: MIT
// interior_point.hpp - points inside halfspaces, rounded to few bits, and bounds of norms.
#pragma once
#include <optional>
#include <span>

#include "convexact/geometry.hpp"

namespace convexact {

/// Each coordinate rounded to the nearest multiple of 2^exponent (half of it: upwards).
[[nodiscard]] RationalPoint round_to_grid(const RationalPoint& x, long exponent);

/// Whether dot(n, x) + d < 0 for every halfspace.
[[nodiscard]] bool is_strictly_inside(std::span<const Halfspace> halfspaces,
                                      const RationalPoint& x);

/// The first strictly interior point among `inside` rounded to ever finer grids 2^k: the coarsest
/// power of two that serves, starting with the one on which `inside` becomes the origin. Its depth
/// in P is not bounded from below.
/// @param inside  A strictly interior point: any rational, or a guess such as a centroid of
///                doubles. The function tests it.
/// @return Nothing if `inside` is not strictly interior.
/// @par Cost  Few exact evaluations per grid that fails, m for the one that serves.
[[nodiscard]] std::optional<RationalPoint> short_dyadic_interior_point(
    std::span<const Halfspace> halfspaces, const RationalPoint& inside);

/// Rationals with lower <= |n| <= upper. They are equal if |n| is a rational of at most 64 bits.
/// Otherwise they are 64-bit integers times a power of two and differ in the last bit.
struct NormEnclosure {
  Rational lower;
  Rational upper;
};

/// The Euclidean norm of an integer vector.
[[nodiscard]] NormEnclosure enclose_norm(const IntegerVector3& n);

}  // namespace convexact
