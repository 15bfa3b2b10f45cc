// SPDX-License-Identifier: MIT
// integer_hull.hpp - a hull of points with the coordinates of its vertices as integers: volumes,
// areas and angles then need no fraction until the end.
#pragma once
#include <cstdint>
#include <vector>

#include "convexact/hull.hpp"
#include "number/arithmetic.hpp"

namespace convexact {

class IntegerHull {
 public:
  /// Doubles become integers by one power of two, where their spread lets it stay within doubles;
  /// other points by their common denominator. @param hull  Must outlive the object.
  IntegerHull(const Hull& hull, const PointSet& points);

  const FacetList& facets() const { return hull_.facets; }
  /// Caller's lengths times this are lengths between these integers.
  const Rational& scale() const { return scale_; }
  const IntegerVector3& vertex(PointId id) const { return vertices_[place_[id.index()]]; }
  /// The outward normal of a facet that is as long as twice its area.
  IntegerVector3 twice_area(std::size_t facet) const;

 private:
  bool scale_doubles(const PointSet& points);
  void scale_rationals(const PointSet& points);

  const Hull& hull_;
  std::vector<IntegerVector3> vertices_;  // those of hull.vertices
  Rational scale_;
  std::vector<std::uint32_t> place_;  // of a PointId, in hull.vertices
};

/// sum += a x b, without temporaries.
inline void add_cross_product(IntegerVector3& sum, const IntegerVector3& a,
                              const IntegerVector3& b) {
  for (int k = 0; k < 3; ++k) {
    const int k1 = (k + 1) % 3, k2 = (k + 2) % 3;
    add_product(sum[k], a[k1], b[k2]);
    subtract_product(sum[k], a[k2], b[k1]);
  }
}

}  // namespace convexact
