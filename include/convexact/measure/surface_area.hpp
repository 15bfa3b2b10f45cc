// SPDX-License-Identifier: MIT
// surface_area.hpp - areas of facets and of the whole surface: rationals times square roots.
#pragma once
#include <vector>

#include "convexact/geometry/polytope.hpp"
#include "convexact/number/enclosure.hpp"
#include "convexact/watch.hpp"

namespace convexact {

/// factor * sqrt(radicand), radicand > 0.
struct RootTerm {
  Rational factor;
  Integer radicand;
};

/// Exact area of each facet, in squared length units; radicand = n.n of the facet's primitive
/// normal direction.
[[nodiscard]] std::vector<RootTerm> facet_areas(const Polytope& polytope, const Watch& watch = {});

/// The sum of root terms. Relative width about 2^-precision if no factor is negative.
[[nodiscard]] Enclosure enclose_sum(const std::vector<RootTerm>& terms, long precision);

/// Surface area in squared length units, relative width about 2^-precision.
/// @par Cost    O(corners) exact products, then one root per facet.
[[nodiscard]] Enclosure surface_area(const Polytope& polytope, long precision,
                                     const Watch& watch = {});

}  // namespace convexact
