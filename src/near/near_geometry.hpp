// SPDX-License-Identifier: MIT
// near_geometry.hpp - doubles near the exact points, and the signs that they decide with certainty.
#pragma once
#include <algorithm>
#include <cmath>
#include <optional>

#include "convexact/number.hpp"
#include "number/roundoff.hpp"

namespace convexact {

/// How far a coordinate of a NearPoint may be from the true one.
inline constexpr double kNearError = 8 * kUnitRoundoff;

/// A point in coordinates that put the center of a hull at the origin and, by one power of two for
/// each axis, every point into the cube [-1, 1]^3. Both keep every orientation. Each coordinate is
/// within kNearError of the true one; the bounds below include that error, so the representation of
/// the exact point does not matter.
struct NearPoint {
  double x, y, z;
};

inline constexpr NearPoint cross(const NearPoint& a, const NearPoint& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline constexpr double dot(const NearPoint& a, const NearPoint& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// A sign where it is certain.
inline constexpr std::optional<Sign> certain_sign(double value, double bound) {
  if (value > bound) return Sign::Positive;
  if (value < -bound) return Sign::Negative;
  return std::nullopt;
}

/// The plane through three points: n.x = offset, positive beyond a, b, c seen counter-clockwise.
struct NearPlane {
  NearPoint normal;
  double offset;
  double bound;  ///< At least the error of height() for every point in the cube.

  // Let u = kUnitRoundoff, E and F the largest components of the computed edges e = b-a, f = c-a;
  // with E, F <= 2 we have EF <= (E+F)^2/4 <= E+F. Edges: off by g = 2*8u + 2u = 18u. Normal: a
  // component is the difference of two products, off by 2g(E+F) + 2g^2 from the edges and by 4u EF
  // from rounding, so by r = 40u(E+F) + 648u^2. Height: n.p - n.a against N.(P-A), |P-A| <= 2 in
  // each component: 3*2*r from the normal, 2*8u|n|_1 from the points, 8u|n|_1 from rounding (3 for
  // each product, 2 for the difference), with |n|_1 <= 6EF <= 6(E+F). Together 384u(E+F) + 3888u^2;
  // terms of higher order, underflows and coordinates of 1 + 8u fit into the rest up to 512 and
  // 8192.
  static constexpr double kSlope = 512 * kUnitRoundoff;
  static constexpr double kIntercept = 8192 * kUnitRoundoff * kUnitRoundoff;
  static_assert(kSlope >= (6 * (2 * 18 + 4) + 6 * 2 * 8 + 6 * 8 + 64) * kUnitRoundoff);
  static_assert(kIntercept >= 2 * (6 * 2 * 18 * 18) * kUnitRoundoff * kUnitRoundoff);

  static NearPlane through(const NearPoint& a, const NearPoint& b, const NearPoint& c) {
    const NearPoint e{b.x - a.x, b.y - a.y, b.z - a.z}, f{c.x - a.x, c.y - a.y, c.z - a.z};
    const double size_e = std::max({std::abs(e.x), std::abs(e.y), std::abs(e.z)});
    const double size_f = std::max({std::abs(f.x), std::abs(f.y), std::abs(f.z)});
    const NearPoint n = cross(e, f);
    return {n, dot(n, a), kSlope * (size_e + size_f) + kIntercept};
  }
  /// |normal| times the signed distance from the plane, give or take `bound`.
  double height(const NearPoint& p) const { return dot(normal, p) - offset; }
};
static_assert(sizeof(NearPlane) == 40);

/// At least the error of dot(cross(a, b), p) for points in the cube. A component of the cross
/// product is off by 4*8u from the points and 4u from rounding; the dot product by 3 times
/// that, by 6*8u from p and by 3*6u from rounding: 174u, and higher orders.
inline constexpr double kCenterBound = 256 * kUnitRoundoff;
static_assert(kCenterBound >= (3 * (4 * 8 + 4) + 6 * 8 + 3 * 6 + 64) * kUnitRoundoff);

}  // namespace convexact
