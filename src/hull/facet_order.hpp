// SPDX-License-Identifier: MIT
// facet_order.hpp - facets of a hull in canonical order, which gives halfspaces their ids.
#pragma once
#include "convexact/hull.hpp"

namespace convexact {

/// The facets in the canonical order of their planes.
/// @par Cost  The exact plane of each.
[[nodiscard]] FacetList in_canonical_order(const Hull& hull, const PointSet& points);

}  // namespace convexact
