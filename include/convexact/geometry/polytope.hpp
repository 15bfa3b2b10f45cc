// SPDX-License-Identifier: MIT
// polytope.hpp - a bounded convex solid: vertices, facets and their planes.
#pragma once
#include <cstdint>
#include <vector>

#include "convexact/geometry/halfspace.hpp"

namespace convexact {

/// A convex polytope of dimension 3, the one primal type. `facets[f]` lists the corners of facet f
/// as indices into `vertices`, counter-clockwise from outside, at least three, no repeats;
/// `planes[f]` bounds it. Facets are maximal and stand in canonical order of their planes.
struct Polytope {
  std::vector<RationalPoint> vertices;
  std::vector<std::vector<std::uint32_t>> facets;
  std::vector<Halfspace> planes;
};

}  // namespace convexact
