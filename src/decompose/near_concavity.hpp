// SPDX-License-Identifier: MIT
// near_concavity.hpp - bounds of the concavity of a cluster, in doubles with proven errors.
//
// docs/design/clustering.md derives the bounds.
#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "convexact/cluster.hpp"
#include "convexact/hull.hpp"

namespace convexact {

inline constexpr double kNoBound = std::numeric_limits<double>::infinity();

/// A length between two doubles. Lengths of the clustering in doubles are multiples of a power of
/// two near the largest coordinate.
struct LengthBounds {
  double low = 0;
  double high = kNoBound;
};

/// The hull of a cluster in doubles: per facet the plane n.x = d about a local origin.
struct NearFacets {
  struct Plane {
    double x, y, z, d;
    double depth_error;   ///< Of d - n.x for every point of the cluster.
    double normal_error;  ///< Of each component of n.
    double size;          ///< |x| + |y| + |z|.
  };
  std::vector<Plane> planes;
  std::vector<std::array<PointId, 3>> corners;  ///< By plane: the points from which it was
                                                ///< computed.
  Point origin = Point::Zero();
};

/// The upper bound of the rays of a triangle, or of a point: up to three planes.
struct RayBound {
  std::uint32_t item = 0;                          ///< The triangle, or the point.
  std::array<std::int32_t, 3> planes{-1, -1, -1};  ///< Into NearFacets::planes.
  double high = kNoBound;
};

/// The data of a cluster that its concavity needs.
struct NearCluster {
  std::vector<PointId> extreme;  ///< Their hull is the cluster's; ascending.
  NearFacets facets;             ///< None of a flat cluster.
  std::vector<RayBound> rays;    ///< Of its triangles with an area, or of its points; ascending.
  LengthBounds concavity;
};

/// Bounds concavities of clusters of one surface. Where the doubles are not enough, a bound may be
/// as weak as [0, infinity].
class NearConcavity {
 public:
  /// Keeps a reference. @param is_float  Errors count as zero: estimates instead of bounds.
  NearConcavity(const Surface& surface, ConcavityMeasure measure, bool is_float);

  /// 2^exponent() times a length here is that length in units of the surface.
  [[nodiscard]] long exponent() const { return exponent_; }
  /// The points, in these units: exact, except for parts below 2^-1074 in these units, and unless
  /// the surface's points are fractions.
  [[nodiscard]] std::span<const Point> points() const { return points_; }

  /// A cluster of some triangles.
  [[nodiscard]] NearCluster cluster(std::span<const TriangleId> triangles) const;

  /// The union of two. If it is certain to be more concave than `limit`, its upper bound may be
  /// infinite.
  [[nodiscard]] NearCluster unite(const NearCluster& a, const NearCluster& b, double limit) const;

  /// The exact concavity: the same as ExactConcavity, but without triangles that are certain to
  /// have shorter rays.
  /// @param cluster  The cluster of these triangles, which ascend, as made here. Its bounds become
  ///                 as narrow as doubles allow.
  [[nodiscard]] Concavity exact(NearCluster& cluster, std::span<const TriangleId> triangles,
                                const Watch& watch = {}) const;
  /// Its square alone.
  [[nodiscard]] Rational squared(NearCluster& cluster, std::span<const TriangleId> triangles,
                                 const Watch& watch = {}) const;
  [[nodiscard]] Concavity exact(std::span<const TriangleId> triangles,
                                const Watch& watch = {}) const {
    NearCluster made = cluster(triangles);
    return exact(made, triangles, watch);
  }

 private:
  /// The direction of the rays of an item: of length 1, each component within `error`.
  struct Direction {
    Point unit = Point::Zero();
    double error = 0;
    bool exists = false;  ///< Or it is 0.
  };

  void add_directions(const Surface& surface);
  [[nodiscard]] Direction direction_of(const Point& normal, double error, bool exists) const;
  [[nodiscard]] std::vector<PointId> corners_of(std::uint32_t item) const;
  void find_hull(NearCluster& cluster, const std::vector<PointId>& points) const;
  void bound_rays(NearCluster& cluster, double limit) const;
  void bound_flat_rays(NearCluster& cluster) const;
  [[nodiscard]] std::optional<Concavity> exact(const NearFacets& facets, TriangleId triangle,
                                               std::span<RayBound* const> rays,
                                               const std::optional<Concavity>& longest) const;
  [[nodiscard]] LengthBounds root_bounds(const Rational& squared) const;
  [[nodiscard]] std::optional<std::int32_t> plane_behind(const NearFacets& facets,
                                                         const RationalPoint& x) const;
  [[nodiscard]] Halfspace exact_plane(const NearFacets& facets, std::int32_t plane) const;
  void look_for_plane_of(const NearFacets& facets, RayBound& ray) const;

  const Surface* surface_;
  ConcavityMeasure measure_;
  bool is_float_, is_exact_input_;
  ExactConcavity exact_;
  long exponent_ = 0;
  std::vector<Point> points_;
  std::vector<Direction> directions_;  // by triangle, or by point
};

}  // namespace convexact
