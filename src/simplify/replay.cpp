// SPDX-License-Identifier: MIT
#include "simplify/replay.hpp"

#include "convexact/dual.hpp"
#include "convexact/error.hpp"
#include "simplify/cap.hpp"

namespace convexact {

Simplification replay(const DualHull& solid, const RationalPoint& center,
                      std::span<const HalfspaceId> removed, std::uint64_t seed) {
  std::vector<DualPoint> points;
  for (const Halfspace& halfspace : solid.halfspaces) points.push_back(polar(halfspace, center));
  AdjacencyMatrix dual(solid.halfspaces.size());
  for (const DualTriangle& triangle : solid.triangles) dual.add(triangle);
  Random random(seed);
  Simplification result;
  result.trace.halfspaces = solid.halfspaces;
  for (const HalfspaceId i : removed) {
    const std::size_t step = result.trace.steps.size();
    const std::vector<HalfspaceId> ring = dual.one_ring(i);
    const RingTriangulation roof = triangulate_ring(points, ring, random);
    if (!roof.is_bounded()) {
      throw Error(ErrorCode::InvalidArgument,
                  "step " + std::to_string(step + 1) + " leaves an unbounded solid");
    }
    result.evaluations.push_back({step, i, ring, roof.triangles});
    result.trace.steps.push_back({i,
                                  volume(make_cap(points, i, ring, roof)),
                                  {},
                                  ring,
                                  roof.triangles,
                                  solid.halfspaces.size() - step - 1});
    for (std::size_t t = 0; t < ring.size(); ++t) {
      dual.remove({i, ring[t], ring[(t + 1) % ring.size()]});
    }
    for (const DualTriangle& triangle : roof.triangles) dual.add(triangle);
  }
  result.triangles = dual.triangles();
  return result;
}

}  // namespace convexact
