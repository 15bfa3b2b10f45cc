// SPDX-License-Identifier: MIT
// hull_observer.hpp - watching a hull being built.
#pragma once
#include <array>
#include <span>

#include "convexact/hull.hpp"

namespace convexact {

/// A triangle of the surface under construction, counter-clockwise from outside.
using HullTriangle = std::array<PointId, 3>;

/// A point that still waits, filed with the triangle that it lies strictly beyond, and that the ray
/// to it from the interior point meets.
struct FiledPoint {
  PointId point;
  HullTriangle triangle;
};

/// The first simplex, and what becomes of the other points. The spans are valid during the call
/// only.
struct HullStart {
  std::span<const HullTriangle> triangles;  ///< Four of them.
  std::span<const FiledPoint> filed;
  std::span<const InsideProof> inside;  ///< Points given up, each with its proof.
};

/// The effect of one insertion on the surface. The spans are valid during the call only.
struct HullInsertion {
  PointId point;
  /// The triangles that the point sees: they go. Together they are a disk.
  std::span<const HullTriangle> visible;
  /// The rim of that disk, counter-clockwise from outside: the edges that stay lie between
  /// horizon[k] and horizon[k + 1], cyclically.
  std::span<const PointId> horizon;
  /// The triangles (horizon[k], horizon[k + 1], point): they come.
  std::span<const HullTriangle> added;
  /// The points that waited at a visible triangle: each is filed with one of those added ...
  std::span<const FiledPoint> filed;
  /// ... or given up, with its proof. So are the vertices that the point swallows.
  std::span<const InsideProof> inside;
};

/// Sees the hull grow, for lessons. The surface that start() shows, less the triangles that each
/// insertion removes, plus those that it adds, ends as the hull; coplanar triangles are not merged.
class HullObserver {
 public:
  virtual ~HullObserver() = default;
  /// Not called for points that span no volume.
  virtual void start(const HullStart& start) = 0;
  /// Called after each insertion; points that lie inside when their turn comes are not inserted.
  virtual void inserted(const HullInsertion& insertion) = 0;
  /// The hull in the end: coplanar triangles are merged, and only extreme points are corners.
  virtual void finished(const Hull&) {}
};

}  // namespace convexact
