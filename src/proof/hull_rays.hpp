// SPDX-License-Identifier: MIT
// hull_rays.hpp - the hull of a cluster, and where rays from its triangles leave it: the part of a
// decomposition's proof about concavities.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "convexact/geometry.hpp"
#include "convexact/surface.hpp"

namespace convexact {

/// A plane in doubles, used only to choose what is tried first.
struct ClusterPlane {
  Point normal;
  double offset;
};

/// The hull of the points of a cluster, with its planes as the proof numbers them.
struct ClusterHull {
  std::vector<PointId> points;
  std::vector<std::array<PointId, 3>> facets;  ///< Fans of the facets; none if it is flat.
  std::vector<Halfspace> planes;               ///< Each once.
  std::vector<std::size_t> number;  ///< By plane: its number in the proof, where each fan has
                                    ///< several.
  std::vector<std::vector<PointId>> corners;  ///< By plane: of the facet; all points if it is flat.
  std::vector<ClusterPlane> near;             ///< By plane.
};

[[nodiscard]] ClusterHull hull_of_cluster(const Surface& surface,
                                          std::span<const TriangleId> triangles);

/// Where concavity is taken: at all points of a triangle, or at one point.
struct RaySource {
  std::uint32_t id;  ///< Of the triangle or the point.
  std::vector<PointId> corners;
  IntegerVector3 direction;
  Point near_direction;  ///< Of length 1.
  Rational squared_length;
};

struct HullRay {
  Rational u = 0, w = 0;  ///< From a + u (b - a) + w (c - a), the corners of the source.
  Rational length = 0;    ///< In multiples of the direction.
  std::size_t plane = 0;  ///< Where it leaves the hull.
};

/// A bound of the rays of a source: a combination of planes.
using PlaneSum = std::vector<std::pair<std::size_t, Rational>>;

/// The rays of a cluster to the planes of its hull.
class HullRays {
 public:
  /// Keeps references.
  HullRays(const Surface& surface, const ClusterHull& hull) : surface_(surface), hull_(hull) {}

  Point near_point(PointId p) const { return surface_.points.doubles()[p.index()]; }
  /// The plane that cuts the ray first, and its length: in doubles, to choose what is tried first.
  std::pair<std::size_t, double> near_exit(const RaySource& source, const Point& from) const;
  /// The plane for which the longest ray from a corner is shortest, and that length; likewise.
  std::pair<std::size_t, double> near_bound(const RaySource& source) const;

  RationalPoint end(const RaySource& source, const HullRay& ray) const;
  /// Exactly, with length and plane filled in.
  HullRay leave(const RaySource& source, HullRay ray) const;

  /// Whether no ray of the source that stays behind the plane, or behind the combination of planes,
  /// is longer than the limit.
  bool is_bound(const RaySource& source, std::size_t plane, const Rational& squared_limit) const;
  bool is_bound(const RaySource& source, const PlaneSum& combination,
                const Rational& squared_limit) const;

  /// The longest ray of a triangle, or a bound that is within the limit, from as few planes as
  /// decide it.
  struct Longest {
    HullRay ray;
    bool is_within;
    PlaneSum bound;  ///< No ray is longer than the limit, or than this one.
  };
  Longest longest(const RaySource& source, const Rational& squared_limit) const;

 private:
  double near_length(const RaySource& source, std::size_t plane, const Point& from) const;
  RationalPoint point(const RaySource& source, const HullRay& ray) const;
  bool is_bound(const RaySource& source, const RationalVector3& n, const Rational& d,
                const Rational& squared_limit) const;

  const Surface& surface_;
  const ClusterHull& hull_;
};

}  // namespace convexact
