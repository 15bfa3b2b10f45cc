// SPDX-License-Identifier: MIT
// near_concavity.hpp - bounds of the concavity of a cluster, in doubles with proven errors.
//
// docs/design/clustering.md derives the bounds.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "convexact/cluster.hpp"
#include "decompose/near_rays.hpp"

namespace convexact {

/// A cluster as far as its concavity is concerned.
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
  /// The points, in these units: exact but for parts below 2^-1074 in these units, if the surface's
  /// points are doubles.
  [[nodiscard]] std::span<const Point> points() const { return points_; }
  /// How far each coordinate of points() is from the true one, beyond such parts: 0 for doubles.
  [[nodiscard]] double off() const { return off_; }

  /// Bounds, in these units, of the root of a square in units of the surface.
  [[nodiscard]] LengthBounds root_bounds(const Rational& squared) const;

  /// A cluster of some triangles.
  [[nodiscard]] NearCluster cluster(std::span<const TriangleId> triangles) const;

  /// Whether a cluster of these triangles is certain to be no more concave than this length.
  /// @par Cost  Some rays first, which most concave clusters fail at.
  [[nodiscard]] bool is_within(std::span<const TriangleId> triangles,
                               const LengthBounds& limit) const;

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
  /// Of an item: a triangle's three points, or the point alone.
  struct Corners {
    std::array<PointId, 3> points;
    std::size_t count;

    auto begin() const { return points.begin(); }
    auto end() const { return points.begin() + static_cast<std::ptrdiff_t>(count); }
  };
  [[nodiscard]] Corners corners_of(std::uint32_t item) const;
  [[nodiscard]] NearCluster without_bounds(std::span<const TriangleId> triangles) const;
  [[nodiscard]] bool is_as_good_as_errors(const RayBound& ray) const;
  void bound_rays(NearCluster& cluster, const FacetsAtPoints& at_points, double limit) const;
  void bound_flat_rays(NearCluster& cluster) const;
  [[nodiscard]] std::optional<Concavity> exact(const NearFacets& facets, TriangleId triangle,
                                               std::span<RayBound* const> rays,
                                               const std::optional<Concavity>& longest) const;
  [[nodiscard]] std::optional<std::int32_t> plane_behind(const NearFacets& facets,
                                                         const RationalPoint& x) const;
  [[nodiscard]] Halfspace exact_plane(const NearFacets& facets, std::int32_t plane) const;
  void look_for_plane_of(const NearFacets& facets, const FacetsAtPoints& at_points,
                         RayBound& ray) const;

  const Surface* surface_;
  ConcavityMeasure measure_;
  bool is_float_;
  ExactConcavity exact_;
  long exponent_ = 0;
  double off_ = 0;
  std::vector<Point> points_;
  std::vector<Direction> directions_;  // by triangle, or by point
};

}  // namespace convexact
