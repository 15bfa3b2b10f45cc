// SPDX-License-Identifier: MIT
// cut_points.hpp - the corners of pieces and regions, and the planes that cut them: in doubles of a
// frame, and exactly.
//
// A corner is a point of the surface, or what planes of the surface and of cuts have in common. It
// is never derived from another new corner, so numbers do not grow with the cuts.
#pragma once
#include <cstdint>
#include <vector>

#include "convexact/surface.hpp"
#include "near/frame.hpp"
#include "near/near_plane.hpp"

namespace convexact {

/// A plane that cuts, in integers, and in a frame whose coordinates are at most 2.
struct CutPlane {
  Halfspace exact;
  Point normal;  ///< In the frame, of length about 1.
  double offset;

  CutPlane(Halfspace plane, const NearFrame& frame);
  /// n.y + d; off by less than kCutError.
  double operator()(const Point& y) const { return normal.dot(y) + offset; }
};

/// At least the error of a plane's value at a corner in a frame. With u = 2^-53: a corner is off by
/// u in each coordinate, n and d by 3u each, and the sum of four products of at most 2 by less
/// than 16u.
inline constexpr double kCutError = 0x1p-46;

/// The plane of a triangle with an area; beyond it is where the triangle faces.
[[nodiscard]] Halfspace triangle_plane(const Surface& surface, std::uint32_t triangle);

/// All corners of a run; ids below surface.points.size() are the points of the surface.
class CutPoints {
 public:
  /// Keeps a reference. @param is_exact  Decide each side in exact numbers.
  CutPoints(const Surface& surface, const NearFrame& frame, bool is_exact = false);

  std::uint32_t add(RationalPoint x);
  const Point& near(std::uint32_t id) const { return near_[id]; }
  RationalPoint exact(std::uint32_t id) const;
  /// On which side of a plane a corner lies: by doubles where they are certain, unless `is_exact`.
  Sign side(const CutPlane& plane, std::uint32_t id) const;

  bool is_exact() const { return is_exact_; }
  const NearFrame& frame() const { return frame_; }
  const Surface& surface() const { return surface_; }

 private:
  const Surface& surface_;
  NearFrame frame_;
  bool is_exact_;
  std::vector<Point> near_;
  std::vector<RationalPoint> made_;  // those that are no points of the surface
};

}  // namespace convexact
