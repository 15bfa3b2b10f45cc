// SPDX-License-Identifier: MIT
// facet_area.hpp - the rational part of a facet's area.
#pragma once
#include "convexact/polytope.hpp"

namespace convexact {

/// Area of a facet divided by the length of its plane's normal; positive.
[[nodiscard]] Rational area_per_normal(const Polytope& polytope, std::size_t facet);

}  // namespace convexact
