// SPDX-License-Identifier: MIT
// notches.hpp - the edges at which a solid is concave, and the planes to cut it there.
#pragma once
#include <optional>
#include <vector>

#include "convexact/partition.hpp"
#include "cut/leaf.hpp"
#include "surface/edges.hpp"

namespace convexact {

/// The notch edges of a surface: those of two triangles, each of which has the other in front of
/// it; of an open surface all of two triangles that are not in one plane.
class Notches {
 public:
  /// Keeps a reference. @par Cost  O(n log n)
  /// @param kind  If only planes of facets, then edges of more than two triangles are notches, too,
  ///              as sheets that touch there may have room between them.
  Notches(const Surface& surface, const CutPoints& points, CutPlanes kind);

  /// All of them, whole.
  std::vector<NotchEdge> all() const;
  /// What of them lies on one side of a plane.
  std::vector<NotchEdge> clipped(const std::vector<NotchEdge>& notches, const CutPlane& plane,
                                 Sign side) const;
  /// Both facets' planes at the strongest of them, and the plane between these, as far as they are
  /// of this kind; the strongest first. Strength is the squared length times 1 - c |c|, with c the
  /// cosine between the normals.
  std::vector<Halfspace> planes(const std::vector<NotchEdge>& notches) const;

 private:
  struct Edge {
    PointId low, high;
    std::uint32_t left, right;  // triangles
    double sharpness;           // 1 - c |c|
  };
  void add(const EdgeUse& one, const EdgeUse& other, bool if_concave);
  std::optional<Halfspace> bisector(const Edge& edge) const;

  const Surface& surface_;
  const CutPoints& points_;
  const CutPlanes kind_;
  std::vector<Edge> edges_;
};

/// A plane across a direction, of which 16 bits are kept, through a point of the frame.
[[nodiscard]] Halfspace plane_across(const Point& direction, const Point& through,
                                     const NearFrame& frame);

/// The same plane with the normal turned so that its first component that is not 0 is positive.
[[nodiscard]] Halfspace turned(const Halfspace& plane);

}  // namespace convexact
