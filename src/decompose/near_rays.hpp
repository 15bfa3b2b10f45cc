// SPDX-License-Identifier: MIT
// near_rays.hpp - bounds, in doubles, of the length that a ray from a triangle has inside a hull.
//
// Along the direction m of a ray, the plane n.x = d lets a point x of the hull run at most
// f(x) = (d - n.x) / (n.m), if n.m > 0. The ray's length is the least f over all planes: a concave
// function on the triangle. Any weighted mean of some f is affine, so its largest value at a corner
// is an upper bound on the whole triangle.
#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "decompose/near_facets.hpp"

namespace convexact {

inline constexpr double kNoBound = std::numeric_limits<double>::infinity();

/// A length between two doubles. Lengths of the clustering in doubles are multiples of a power of
/// two near the largest coordinate.
struct LengthBounds {
  double low = 0;
  double high = kNoBound;
};

/// What bounds the rays of a triangle, or of a point, from above: up to three planes.
struct RayBound {
  std::uint32_t item = 0;                          ///< The triangle, or the point.
  std::array<std::int32_t, 3> planes{-1, -1, -1};  ///< Into NearFacets::planes.
  double high = kNoBound;
  /// Whether the item lies in a plane of the hull, up to the plane's error: then no search makes
  /// the lower bound positive.
  bool is_rounding = false;
};

/// The bound of the same ray in a larger hull: it still holds if its planes are planes of that one.
/// @param same  By plane of the hull: the same one of the larger hull, or -1.
[[nodiscard]] RayBound moved(RayBound ray, const std::vector<std::int32_t>& same);

/// The rays of a triangle, or of a point, inside a hull.
class NearRays {
 public:
  /// Keeps a reference.
  explicit NearRays(const NearFacets& facets) : facets_(facets) {}

  /// Goes on with other rays; keeps the memory of the old ones.
  /// @param corners  One or three of the points from which the hull was computed, or others in it.
  /// @param unit, error  The direction: of length 1, each component within `error`.
  void assign(std::span<const Point> corners, const Point& unit, double error);

  /// An upper bound by one plane: the one where the ray from the middle leaves.
  void bound_quickly(RayBound& ray);
  /// The least of the upper bounds by each of these planes, if one bounds the rays at all.
  void bound_by(std::span<const std::int32_t> planes, RayBound& ray);
  /// Makes the upper bound as tight as three planes allow, unless it is found to be below `enough`;
  /// returns a lower bound of the longest ray.
  double bound_tightly(RayBound& ray, double enough);

 private:
  struct Cut {
    std::int32_t plane;
    std::array<double, 3> high;  // f at the corners, or more
    bool is_rounding;            // as of RayBound
  };
  using Weights = std::array<double, 3>;  // of the corners; they add up to 1

  [[nodiscard]] Point at(const Weights& weights) const;
  [[nodiscard]] std::int32_t plane_ahead(const Weights& weights) const;
  [[nodiscard]] double low_at(const Weights& weights) const;
  [[nodiscard]] bool add_cut(std::int32_t plane);
  void tighten(RayBound& ray) const;
  [[nodiscard]] Weights highest_point() const;

  const NearFacets& facets_;
  std::array<Point, 3> corners_;
  std::size_t count_ = 0;
  Point unit_ = Point::Zero();
  double error_ = 0;
  std::vector<Cut> cuts_;
};

}  // namespace convexact
