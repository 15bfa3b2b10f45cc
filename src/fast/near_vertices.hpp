// SPDX-License-Identifier: MIT
// near_vertices.hpp - the vertices of a hull as doubles, with a bound for determinants of their
// differences; exact numbers where that leaves a sign or a cost open.
#pragma once
#include <vector>

#include "convexact/run.hpp"
#include "fast/dual.hpp"
#include "fast/signs.hpp"
#include "measure/vertex_determinants.hpp"
#include "number/roundoff.hpp"

namespace convexact {

/// How far ((b - a) x (c - a)).(p - a) can be from the true determinant if every component of the
/// differences, as computed, is at most E = (extent.x, extent.y, extent.z), and every coordinate is
/// at most 1 in size and off by at most `error`.
///
/// Let u be the unit roundoff, P = E.x E.y E.z and A = E.y E.z + E.z E.x + E.x E.y, where E <= 2.
/// First order in u and error:
/// - A difference is off by u E from rounding and by 2 error from its ends.
/// - The determinant is the sum of six products of three components, one of each axis. Off from its
///   factors such a product is by 3u P + 2 error A; so all six by 18u P + 12 error A.
/// - Each product takes part in five roundings: its own two, a difference and two sums: 30u P.
/// Together 48u P + 12 error A; higher orders are below 2^-40 of these. Underflow is as for
/// PlaneFilter.
struct VolumeFilter {
  static constexpr double kOfProduct = 6 * 3 + 6 * 5, kProductFactor = 64;
  static constexpr double kOfError = 6 * 2, kErrorFactor = 16;
  static_assert(kOfProduct < kProductFactor - 1 && kOfError < kErrorFactor - 1);

  static double within(const Triple<double>& extent, double error) {
    const double product = extent.x * extent.y * extent.z;
    const double area = extent.y * extent.z + extent.x * (extent.y + extent.z);
    return kProductFactor * kUnitRoundoff * product + kErrorFactor * error * area +
           ExponentRange<double>::kUnderflow;
  }
};

/// The points of a VertexHull, each axis scaled by a power of two so that the largest coordinate is
/// in [1/2, 1]. That multiplies all volumes by one constant. Points that are doubles stay exact, up
/// to underflow; rationals are rounded.
class NearVertices {
 public:
  /// @param points  Must outlive the object.
  explicit NearVertices(const PointSet& points);

  std::size_t size() const { return near_.size(); }
  const Triple<double>& operator[](VertexId v) const { return near_[v.index()]; }
  /// At least the error of determinants of differences within that extent.
  double bound(const Triple<double>& extent) const { return VolumeFilter::within(extent, error_); }
  const VertexDeterminants& exact() const { return exact_; }
  /// Six times a volume in the units of these coordinates, of one in the unit of the integers.
  Interval<double> scaled(const Integer& six_volumes) const;

 private:
  VertexDeterminants exact_;
  std::vector<Triple<double>> near_;
  double error_;   // of a coordinate
  Rational unit_;  // of exact_, in the units of these coordinates
};

}  // namespace convexact
