// SPDX-License-Identifier: MIT
// solid_boundary.hpp - the boundary of the rest of a solid outside convex parts.
//
// Let D be the points with a winding number other than 0 that lie in no solid part. Up to a set
// without area, its boundary consists of
// (1) pieces of triangles that no part holds, with a winding number of 0 on one side only;
// (2) pieces of the union's boundary with a winding number other than 0 on their outer side.
// D is empty iff there is no such piece, and its volume is a sum over them.
#pragma once
#include <functional>
#include <span>

#include "convexact/overlay.hpp"
#include "overlay/laid_surface.hpp"
#include "overlay/union_boundary.hpp"

namespace convexact {

struct SolidPiece {
  Arrangement<3>& arrangement;
  const ConvexPiece<3>& piece;
  const Halfspace& plane;  ///< Faces the same way as the frame's triangle.
  const RationalPoint& x;  ///< Strictly inside the piece.
  bool looks_out;          ///< D lies behind the plane; otherwise before it, on the side that it
                           ///< faces.
};

struct BoundaryVisitor {
  /// Called with each piece until it returns false.
  std::function<bool(const SolidPiece&)> piece;
  /// If there are no parts: called instead with triangles that nothing crosses, as a whole.
  std::function<void(TriangleId triangle, bool looks_out)> whole = {};
};

/// Pieces are found on up to `jobs` threads, and visited one after another in the same order.
/// @throws Error Stopped when the watch ends the call.
void visit_uncovered_boundary(const Surface& surface, const Winding& winding,
                              std::span<const ConvexPart> parts, long exponent,
                              const BoundaryVisitor& visitor, const Watch& watch, std::size_t jobs);

/// common_exponent() of the surface and the parts.
[[nodiscard]] long common_exponent(const Surface& surface, std::span<const ConvexPart> parts);

}  // namespace convexact
