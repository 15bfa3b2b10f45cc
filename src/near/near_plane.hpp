// SPDX-License-Identifier: MIT
// near_plane.hpp - planes of integers in doubles: their normals as directions, and n.x + d with a
// proven error bound, also for points as three arrays.
#pragma once
#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "convexact/geometry.hpp"
#include "number/arithmetic.hpp"
#include "number/roundoff.hpp"

namespace convexact {

/// The vector over its largest component, each component rounded to nearest; 0 for 0.
[[nodiscard]] inline Point near_direction(const IntegerVector3& v) {
  Integer largest = 0;
  for (const Integer& x : v) largest = std::max<Integer>(largest, abs(x));
  Point near = Point::Zero();
  if (largest == 0) return near;
  for (int k = 0; k < 3; ++k) near[k] = to_double(Rational(v[k], largest), Rounding::Nearest);
  return near;
}

/// A vector of length 1, up to some units of roundoff; 0 for 0.
[[nodiscard]] inline Point unit_vector(const IntegerVector3& v) {
  const Point near = near_direction(v);
  return near.isZero(0) ? near : near / near.norm();
}

/// x 2^-bits, rounded to nearest.
[[nodiscard]] inline double scaled_down(const Integer& x, std::size_t bits) {
  return to_double(scale_by_power_of_two(Rational(x), -static_cast<long>(bits)), Rounding::Nearest);
}

/// The vector scaled by a power of two so that its largest component is in [1/2, 1], each component
/// rounded to nearest. Quicker than near_direction().
[[nodiscard]] inline Point scaled_direction(const IntegerVector3& v) {
  const std::size_t bits = bit_length(v);
  return {scaled_down(v[0], bits), scaled_down(v[1], bits), scaled_down(v[2], bits)};
}

/// Bound of |fl(n.x + d) - (n.x + d)| where fl() works on n, x and d each rounded to nearest once:
///   kRelativePlaneError * (|n1 x1| + |n2 x2| + |n3 x3| + |d|) + absolute_plane_error().
/// With u = kUnitRoundoff a term n_k x_k suffers two input roundings, its product and three sums,
/// so a factor within (1 + u)^6; d suffers fewer. 8u covers 6u, the terms of second order and the
/// rounding of the bound itself. Underflow adds: an input rounded in the subnormal range is off by
/// at most 2^-1075, times the other factor; a product likewise by 2^-1075. Overflow makes the value
/// infinite or NaN, and the bound with it; a comparison with NaN is false, so such pairs are left
/// to the exact numbers.
inline constexpr double kRelativePlaneError = 8 * kUnitRoundoff;
/// `largest` bounds every |n_k| and |x_k|. At most 2^-1075 * (3 largest_n + 3 largest_x + 3 + 1)
/// and second order terms, rounded: 2^-1070 * (1 + largest) covers it.
inline double absolute_plane_error(double largest) { return 0x1p-1070 + 0x1p-1070 * largest; }

/// The coordinates of points, for vector code.
struct CoordinateArrays {
  std::vector<double> x, y, z;
  double largest = 0;  ///< Of the absolute values of all coordinates.

  explicit CoordinateArrays(std::span<const Point> points) {
    reserve(points.size());
    for (const Point& p : points) push_back(p);
  }
  CoordinateArrays(const PointSet& points, std::span<const PointId> ids) {
    reserve(ids.size());
    for (const PointId id : ids) push_back(points.doubles()[id.index()]);
  }
  std::size_t size() const { return x.size(); }
  /// Largest absolute value of the coordinates of the points [first, last).
  double largest_of(std::size_t first, std::size_t last) const {
    double most = 0;
    for (std::size_t j = first; j < last; ++j) {
      most = std::max({most, std::abs(x[j]), std::abs(y[j]), std::abs(z[j])});
    }
    return most;
  }

 private:
  void reserve(std::size_t count) {
    x.reserve(count);
    y.reserve(count);
    z.reserve(count);
  }
  void push_back(const Point& p) {
    x.push_back(p.x());
    y.push_back(p.y());
    z.push_back(p.z());
    for (int k = 0; k < 3; ++k) largest = std::max(largest, std::abs(p[k]));
  }
};

/// A value in doubles that is off by at most `error`; NaN where something overflowed.
struct NearValue {
  double value, error;

  bool surely_negative() const { return value + error < 0; }
  bool surely_positive() const { return value > error; }
  bool surely_not_zero() const { return std::abs(value) > error; }
};

/// A halfspace scaled by a power of two so that its largest normal component is in [1/2, 1].
struct DoubleHalfspace {
  double n[3];
  double d;

  explicit DoubleHalfspace(const Halfspace& h)
      : d(scaled_down(h.offset(), bit_length(h.normal()))) {
    const Point direction = scaled_direction(h.normal());
    for (int k = 0; k < 3; ++k) n[k] = direction[k];
  }

  /// n.x + d.
  double operator()(const Point& x) const { return n[0] * x[0] + n[1] * x[1] + n[2] * x[2] + d; }
  /// The same and its error; `absolute` is absolute_plane_error() of all points.
  NearValue at(double x, double y, double z, double absolute) const {
    const double px = n[0] * x, py = n[1] * y, pz = n[2] * z;
    const double size = std::abs(px) + std::abs(py) + std::abs(pz) + std::abs(d);
    return {px + py + pz + d, kRelativePlaneError * size + absolute};
  }
  NearValue at(const CoordinateArrays& points, std::size_t j, double absolute) const {
    return at(points.x[j], points.y[j], points.z[j], absolute);
  }
};

}  // namespace convexact
