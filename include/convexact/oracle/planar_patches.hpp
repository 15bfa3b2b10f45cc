// SPDX-License-Identifier: MIT
// planar_patches.hpp - how many planes a solid with rounded vertices was meant to have.
#pragma once
#include <cstddef>

#include "convexact/geometry/polytope.hpp"

namespace convexact {

/// The number of patches into which the surface falls if, from the largest facet down, each takes
/// the neighbouring facets all of whose corners lie within the tolerance of its plane. At most the
/// number of facets; with tolerance 0 exactly that, since facets are maximal.
/// @param squared_tolerance  In squared length units, at least 0.
/// @par Cost  For each facet its corners, exactly, against the planes of its neighbours' patches.
[[nodiscard]] std::size_t count_planar_patches(const Polytope& polytope,
                                               const Rational& squared_tolerance);

}  // namespace convexact
