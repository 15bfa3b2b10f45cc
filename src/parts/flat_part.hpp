// SPDX-License-Identifier: MIT
// flat_part.hpp - clusters that lie in a plane: they join a neighbour, or they are thickened.
#pragma once
#include <vector>

#include "convexact/cluster.hpp"

namespace convexact {

/// A cluster and the hull of its points.
struct HulledCluster {
  std::vector<TriangleId> triangles;  ///< Ascending.
  ConvexPart hull;
};

/// Flat clusters join, lowest first, the neighbour with which they are least concave, of equal ones
/// the lowest; again, as long as the union is flat. A cluster without a neighbour stays.
/// @param clusters      By their lowest triangles, before and after.
/// @param skips_inner   Those that lie in the hull of another cluster stay, too; of equal ones the
///                      first joins a neighbour.
/// @return The lowest triangles of the clusters that joined another one, in that order.
/// @throws Error Stopped when the watch ends the call.
[[nodiscard]] std::vector<TriangleId> merge_flat(const Surface& surface, Connect connect,
                                                 const ExactConcavity& concavity, bool skips_inner,
                                                 std::vector<HulledCluster>& clusters,
                                                 const Watch& watch);

/// Points around a flat hull, whose hull has a volume: each corner v becomes v + w and v - w, or
/// all sums v +- w1 +- w2 for a segment, v +- w1 +- w2 +- w3 for a point. Every w is dyadic, close
/// to perpendicular to the hull and to the others, and about 2^-20 of the diameter long, or some
/// units in the last place of the coordinates in `precision`, if that is more. As v is the middle
/// of these points, their hull holds it.
[[nodiscard]] PointSet thicken(const ConvexPart& flat, const Rational& squared_diameter,
                               Precision precision);

}  // namespace convexact
