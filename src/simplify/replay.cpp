// SPDX-License-Identifier: MIT
#include "simplify/replay.hpp"

#include "convexact/error.hpp"
#include "simplify/dual_surface.hpp"

namespace convexact {

Run replay(const DualHull& dual, const RationalPoint& center, std::span<const HalfspaceId> removed,
           std::uint64_t seed) {
  DualSurface surface(dual.halfspaces, dual.triangles, center, seed);
  Run run;
  run.halfspaces = dual.halfspaces;
  run.is_greedy = false;
  for (const HalfspaceId i : removed) {
    const Removal removal = surface.removal_of(i);
    const std::size_t step = run.steps.size();
    if (!removal.cost) {
      throw Error(ErrorCode::InvalidArgument,
                  "step " + std::to_string(step + 1) + " leaves an unbounded solid");
    }
    surface.apply(removal);
    run.evaluations.push_back({step, i, removal.ring, removal.roof.triangles});
    Step& made = run.steps.emplace_back();
    made.removed = i;
    made.cost = removal.cost;
    made.ring = removal.ring;
    made.triangles = removal.roof.triangles;
    made.left = surface.left();
  }
  run.triangles = surface.triangles();
  return run;
}

}  // namespace convexact
