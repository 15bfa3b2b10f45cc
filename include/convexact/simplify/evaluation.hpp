// SPDX-License-Identifier: MIT
// evaluation.hpp - a look at what one removal would cost, as an engine took it.
#pragma once
#include <vector>

#include "convexact/geometry/ids.hpp"

namespace convexact {

/// Which cap an engine looked at, and when. Costs never decrease, so what an evaluation shows stays
/// a lower bound; with every evaluation that an engine made, each of its choices can be proven.
struct Evaluation {
  std::size_t step;  ///< Removals made before it.
  HalfspaceId halfspace;
  std::vector<HalfspaceId> ring;        ///< One-ring of `halfspace` at that time.
  std::vector<DualTriangle> triangles;  ///< T_i: what would fill the ring.
};

}  // namespace convexact
