// SPDX-License-Identifier: MIT
// near_facets.hpp - the hull of some points of a surface, with the planes of its facets in doubles.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "convexact/hull.hpp"
#include "near/near_plane.hpp"
#include "number/roundoff.hpp"

namespace convexact {

/// More than all that is lost to numbers that are too small for doubles.
inline constexpr double kLostToUnderflow = 1e-290;

/// A vector in doubles, and how far each component may be from the true one.
struct NearNormal {
  Point value;
  double error;
};

/// (b - a) x (c - a). @param off  How far each coordinate is from the true point's.
[[nodiscard]] NearNormal near_normal(const Point& a, const Point& b, const Point& c, double off);

/// The hull of a cluster in doubles: per facet the plane n.x = d about a local origin.
struct NearFacets {
  struct Plane {
    double x, y, z, d;
    double depth_error;   ///< Of d - n.x for every point of the cluster.
    double normal_error;  ///< Of each component of n.
    double size;          ///< |x| + |y| + |z|.

    /// d - n.x of a point about the origin.
    [[nodiscard]] double depth(const Point& point) const {
      return d - (x * point[0] + y * point[1] + z * point[2]);
    }
    /// n.m, and how far it may be from the true one: |m| = 1, each component within `m_error`.
    [[nodiscard]] NearValue along(const Point& m, double m_error) const {
      return {x * m[0] + y * m[1] + z * m[2],
              size * (m_error + 8 * kUnitRoundoff) + 4 * normal_error};
    }
  };
  std::vector<Plane> planes;
  std::vector<std::array<PointId, 3>> corners;  ///< By plane: what it was computed from.
  Point origin = Point::Zero();
};

/// The hull of some points of a surface: the extreme ones, ascending, and the facets; none if it is
/// flat.
/// @param ids       At least one, ascending.
/// @param near      All points of the surface in doubles, over a power of two.
/// @param off       How far each of their coordinates is from the true one.
/// @param is_float  Errors count as zero.
[[nodiscard]] std::pair<std::vector<PointId>, NearFacets> near_hull_of(
    const PointSet& points, const std::vector<PointId>& ids, std::span<const Point> near,
    double off, bool is_float);

/// The facets of a hull at its corners, as far as their planes were computed from these.
class FacetsAtPoints {
 public:
  /// Keeps references. @param extreme  The corners of the hull, ascending.
  FacetsAtPoints(const std::vector<PointId>& extreme, const NearFacets& facets);

  /// Ascending; none if the point is no corner.
  [[nodiscard]] std::span<const std::int32_t> at(PointId point) const;

  /// By plane of another hull: which plane of this one is the same, or -1.
  [[nodiscard]] std::vector<std::int32_t> same_planes(const NearFacets& other) const;

 private:
  [[nodiscard]] std::size_t place_of(PointId point) const;

  const std::vector<PointId>& extreme_;
  const NearFacets& facets_;
  std::vector<std::uint32_t> starts_;  // by place in extreme_, and the end of the last one
  std::vector<std::int32_t> at_;
};

}  // namespace convexact
