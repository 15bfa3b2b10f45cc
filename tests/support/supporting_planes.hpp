// SPDX-License-Identifier: MIT
// supporting_planes.hpp - the facets and vertices of a convex hull by definition, for a few dozen
// points: every plane through three of them that has all of them on one side.
#pragma once
#include <algorithm>
#include <span>
#include <vector>

#include "affine_dimension.hpp"
#include "convexact/geometry.hpp"

/// The halfspaces of the facets, in canonical order, each once. Precondition: the points span a
/// volume. O(n^3) planes, each tested against up to n points.
inline std::vector<convexact::Halfspace> supporting_planes(
    std::span<const convexact::RationalPoint> points) {
  using namespace convexact;
  std::vector<Halfspace> found;
  const auto try_plane = [&](const RationalPoint& a, const RationalPoint& b,
                             const RationalPoint& c) {
    const RationalVector3 u = b - a, v = c - a;
    const RationalVector3 normal = u.cross(v);
    if (normal == RationalVector3::Zero()) return;
    bool above = false, below = false;
    for (const RationalPoint& p : points) {
      const RationalVector3 w = p - a;
      const Rational height = normal.dot(w);
      above = above || height > 0;
      below = below || height < 0;
      if (above && below) return;
    }
    found.push_back(above ? Halfspace::through(a, c, b) : Halfspace::through(a, b, c));
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      for (std::size_t k = j + 1; k < points.size(); ++k) {
        try_plane(points[i], points[j], points[k]);
      }
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

/// The points that three planes with independent normals pass through, each once, ascending index.
inline std::vector<std::size_t> extreme_points(std::span<const convexact::RationalPoint> points,
                                               std::span<const convexact::Halfspace> planes) {
  using namespace convexact;
  std::vector<std::size_t> extreme;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::find(points.begin(), points.begin() + i, points[i]) != points.begin() + i) continue;
    std::vector<RationalPoint> normals{RationalPoint::Zero()};
    for (const Halfspace& plane : planes) {
      if (plane(points[i]) == 0) normals.push_back(plane.normal().cast<Rational>());
    }
    if (affine_dimension(normals) == 3) extreme.push_back(i);
  }
  return extreme;
}
