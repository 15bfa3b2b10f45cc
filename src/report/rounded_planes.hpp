// SPDX-License-Identifier: MIT
// rounded_planes.hpp - the errors of planes that were rounded to some numbers.
#pragma once
#include "convexact/dual.hpp"
#include "fast/rounded_dual.hpp"
#include "report/error_size.hpp"

namespace convexact {

/// The largest relative error of a coordinate of a dual point.
[[nodiscard]] ErrorSize worst_coordinate(const RoundedDual& rounded, std::size_t halfspaces);

/// How far a vertex of the solid lies outside one of the rounded planes, at most; relative to the
/// diameter of the solid's box. Exactly the worst one: doubles only exclude pairs of a plane and a
/// vertex that are proven not to be it.
[[nodiscard]] ErrorSize worst_outside(const RoundedDual& rounded, const DualHull& solid,
                                      const RationalPoint& center);

}  // namespace convexact
