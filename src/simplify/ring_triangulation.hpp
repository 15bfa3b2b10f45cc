// SPDX-License-Identifier: MIT
// ring_triangulation.hpp - closes the dual hull after a dual point is removed.
#pragma once
#include <span>
#include <vector>

#include "convexact/dual.hpp"
#include "convexact/geometry.hpp"
#include "number/random.hpp"

namespace convexact {

/// T_i: the part of the hull of the ring that the removed dual point was beyond (or level with).
struct RingTriangulation {
  std::vector<DualTriangle> triangles;  ///< k - 2 for a ring of k, counter-clockwise from outside.
  std::vector<DualPlane> planes;        ///< planes[t] holds triangles[t].

  /// Whether every triangle has a primal vertex; if not, the removal opens a gap to infinity.
  bool is_bounded() const;
};

/// Watches a ring being triangulated, corner by corner.
class RingObserver {
 public:
  virtual ~RingObserver() = default;
  /// The first three corners, in one triangle.
  virtual void started(const DualTriangle& first) = 0;
  /// One more corner: it was beyond `lost`, and is a corner of each of `gained`.
  virtual void inserted(HalfspaceId corner, std::span<const DualTriangle> lost,
                        std::span<const DualTriangle> gained) = 0;
};

/// Triangulates the hole that dual point i leaves. Any valence and any degeneracy are allowed: if
/// four dual points lie in a plane, the generator chooses among equal triangulations.
/// @param points  The dual points of all halfspaces, by id.
/// @param ring    The one-ring of i in a convex dual hull, counter-clockwise, at least three.
/// @param random  Draws the insertion order.
/// @param observer  Receives every insertion; null for none.
/// @par Cost      Expected O(k) exact signs for every ring.
/// @par Source    [Chew1990]: insertion in random order into a polygon in convex position, here
///                with "beyond the dual plane" in place of "inside the circumcircle".
[[nodiscard]] RingTriangulation triangulate_ring(std::span<const DualPoint> points,
                                                 std::span<const HalfspaceId> ring, Random& random,
                                                 RingObserver* observer = nullptr);

}  // namespace convexact
