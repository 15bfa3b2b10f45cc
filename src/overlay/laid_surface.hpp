// SPDX-License-Identifier: MIT
// laid_surface.hpp - the triangles of a surface as planes and walls, and pieces cut along them
// until no triangle crosses a piece.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "convexact/overlay.hpp"
#include "overlay/convex_piece.hpp"
#include "overlay/scaled.hpp"
#include "task/lazy.hpp"

namespace convexact {

class LaidSurface {
 public:
  /// Keeps a reference.
  LaidSurface(const Surface& surface, long exponent);

  const Surface& surface() const { return surface_; }
  const ScaledPoints& points() const { return points_; }
  std::array<std::uint32_t, 3> corners(std::size_t t) const {
    const auto& ids = surface_.triangles[t];
    return {ids[0].value, ids[1].value, ids[2].value};
  }
  const NearBox& box(std::size_t t) const { return tree_.box(t); }

  /// The plane of a triangle with an area, which faces the same way as the triangle; and by edge
  /// (from corner k to corner k + 1) a wall: a halfspace that holds the triangle, and whose plane
  /// meets the triangle's in the edge's line.
  struct Walls {
    Halfspace plane;
    std::array<Halfspace, 3> walls;
  };
  /// Nothing for a triangle without area.
  const Walls* walls(std::size_t t) const {
    return walls_[t].get([&] { return make_walls(t); }).get();
  }

  /// The triangles that concern pieces of one plane, see relate().
  struct Related {
    std::vector<std::uint32_t> crossing;  ///< Have an area, and meet the plane in a segment.
    std::vector<std::uint32_t> coplanar;
    std::vector<std::uint32_t> touching;  ///< Meet the plane in a point, or have no area.
  };
  /// @param skip  Triangles with at least two of these points are left out, except coplanar ones:
  ///              they do not cross pieces on one side of their common edge.
  Related relate(const Halfspace& plane, const NearBox& box, std::span<const std::uint32_t> skip,
                 std::optional<std::size_t> self) const;

  /// Cuts pieces of the plane until each related triangle crosses none, and each coplanar one
  /// holds all of a piece or nothing with an area. Pieces that coplanar triangles below
  /// `drop_below` hold are dropped.
  void cut(Arrangement<3>& arrangement, std::vector<ConvexPiece<3>>& pieces, const Related& related,
           std::size_t drop_below) const;

  /// Whether x, in the plane, lies on no related triangle, except for the interiors of coplanar
  /// ones.
  /// @param inside  Receives the first coplanar triangle with x in its interior.
  bool is_clear(const RationalPoint& x, const Related& related,
                std::optional<std::size_t>& inside) const;

 private:
  std::unique_ptr<const Walls> make_walls(std::size_t t) const;

  const Surface& surface_;
  long exponent_;
  ScaledPoints points_;
  BoxTree tree_;
  std::vector<Lazy<std::unique_ptr<const Walls>>> walls_;
};

}  // namespace convexact
