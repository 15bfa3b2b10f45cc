// SPDX-License-Identifier: MIT
// leaf.hpp - what a leaf of the partition holds: pieces of triangles, and the corners of its region
// at which the solid has a volume in it. docs/design/cutting.md proves that their hull holds what
// the solid and the region have in common.
#pragma once
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "convexact/surface.hpp"
#include "cut/cut_points.hpp"
#include "cut/region.hpp"

namespace convexact {

/// A convex polygon in a triangle, or all of it. Degenerate if the triangle is.
struct Piece {
  /// The side of the triangle, 0 to 2, or 3 + the plane that a side of the polygon lies in.
  struct Corner {
    std::uint32_t point;
    std::uint32_t side;  ///< Of the side from this corner to the next.
  };
  std::uint32_t triangle;
  std::vector<Corner> corners;  ///< Empty: the whole triangle.
};

/// An edge of the triangles at which the solid is concave, and what of it lies in a region.
struct NotchEdge {
  std::uint32_t edge;  ///< Into the list of all notch edges.
  double from, to;     ///< Shares of its length, in doubles.
};

struct Leaf {
  Region region;
  std::vector<Piece> pieces;
  std::vector<std::uint32_t> solid_corners;  ///< Of the region; ascending.
  std::vector<NotchEdge> notches;

  /// The corners of the pieces and of the region, ascending, each once.
  std::vector<std::uint32_t> points(const Surface& surface) const;
};

/// Cuts leaves of one surface, exactly.
class LeafCutter {
 public:
  /// Keeps references. @param winding  Null for an open surface.
  LeafCutter(const Surface& surface, const Winding* winding, CutPoints& points,
             const std::vector<CutPlane>& planes, const Watch& watch)
      : surface_(surface), winding_(winding), points_(points), planes_(planes), watch_(watch) {}

  /// What lies below the plane and above it. Pieces in the plane go where the solid is; to the
  /// lower side if it is on both sides or on none.
  /// @param raised  Receives the triangles of those that went above.
  /// @throws Error  Stopped when the watch ends the call.
  std::pair<Leaf, Leaf> cut(const Leaf& leaf, std::uint32_t plane, std::vector<TriangleId>& raised);

  /// The corners of a region at which the solid has a volume in it that no piece bounds.
  std::vector<std::uint32_t> solid_corners(const Region& region) const;

 private:
  class PieceCutter;
  bool goes_up(const Piece& piece, const CutPlane& plane) const;

  const Surface& surface_;
  const Winding* winding_;
  CutPoints& points_;
  const std::vector<CutPlane>& planes_;
  const Watch& watch_;
};

}  // namespace convexact
