// SPDX-License-Identifier: MIT
// volume.hpp - volume of a polytope, exactly or to a number of bits.
#pragma once
#include "convexact/geometry/polytope.hpp"
#include "convexact/number/enclosure.hpp"

namespace convexact {

/// Exact volume, in cubed length units: the sum over the facets of height times area over 3, where
/// the roots in both cancel. Balanced, because the vertices of a simplified polytope hardly share
/// denominators.
/// @par Cost    O(corners) short products; the last additions are as long as the result.
/// @par Source  docs/measures.md
[[nodiscard]] Rational volume(const Polytope& polytope);

/// The same to a relative width of about 2^-precision, without long numbers: no term is negative,
/// because heights are measured from a vertex.
[[nodiscard]] Enclosure enclose_volume(const Polytope& polytope, long precision);

}  // namespace convexact
