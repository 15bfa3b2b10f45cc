// SPDX-License-Identifier: MIT
// cap_range.hpp - two numbers that enclose the volume of a cap, from rounded dual points.
#pragma once
#include <limits>

#include "fast/cap_volume.hpp"
#include "fast/exponent_range.hpp"
#include "fast/ring_geometry.hpp"

namespace convexact {

/// lower <= x <= upper for some x >= 0. Operations on the ends are rounded to nearest: after n of
/// them in a row, the caller widens the result by n roundings.
template <class Scalar>
struct Range {
  Scalar lower, upper;

  friend Range operator*(const Range& a, const Range& b) {
    return {a.lower * b.lower, a.upper * b.upper};
  }
  friend Range operator/(const Range& a, const Range& b) {
    return {a.lower / b.upper, a.upper / b.lower};
  }
};

/// What one stage of arithmetic says about a cap.
template <class Scalar>
struct CapRange {
  enum class Kind : unsigned char {
    Bounded,    ///< 0 <= lower <= six times its volume <= upper.
    Unbounded,  ///< Proven: some triangle of T has D < 0.
    Doubtful,   ///< Some D is too small for this arithmetic to tell; `lower` is true all the same.
  };
  Kind kind;
  Scalar lower, upper;

  static CapRange doubtful() {
    return {Kind::Doubtful, Scalar(0.0), Scalar(std::numeric_limits<double>::infinity())};
  }
};

/// Determinants of a RingGeometry as ranges, for CapVolume.
///
/// Rounding: below any term of the sum lie 5 factors, each of whose ends is rounded once, 3
/// products and 4 quotients; then up to 2 k additions. So 13 + 2 k units bound the relative error
/// of an end, and twice (16 + 2 k) leaves room for higher orders.
template <class Scalar>
class RangeSource {
 public:
  using Number = Range<Scalar>;
  struct Sum {
    Number total{Scalar(0.0), Scalar(0.0)};
    void add(const Number& x) {
      total.lower += x.lower;
      total.upper += x.upper;
    }
    Number scaled_down(const Number& x) const { return total / x; }
  };

  RangeSource(const RingGeometry<Scalar>& ring, double unit)
      : ring_(ring),
        unit_(unit),
        arm_error_(ring.arm_filter(unit).height),
        error_(ring.filter(unit).height) {}

  // D by the bounds of their triangles alone: in a long ring a small one would drown in that of
  // all.
  Number base(std::uint32_t m) {
    const std::size_t next = m + 1 == ring_.arm.size() ? 0 : m + 1;
    return positive(dot(ring_.side[m], ring_.center), ring_.arm[m], ring_.arm[next]);
  }
  Number slack(std::uint32_t m) const {
    return lift(-dot(ring_.side[0], ring_.arm[m]), arm_error_);
  }
  Number leg(std::uint32_t m, std::uint32_t q) const {
    return lift(-dot(ring_.side[m], ring_.arm[q]), arm_error_);
  }
  void set_triangle(std::uint32_t low, std::uint32_t middle, std::uint32_t high) {
    low_ = low;
    first_ = ring_.point[middle] - ring_.point[low];
    second_ = ring_.point[high] - ring_.point[low];
    normal_ = cross(first_, second_);
  }
  Number vertex() { return positive(dot(normal_, ring_.point[low_]), first_, second_); }
  Number to_center() const { return lift(-dot(normal_, ring_.arm[low_]), error_); }
  Number to(std::uint32_t q) const {
    return lift(-dot(normal_, ring_.point[q] - ring_.point[low_]), error_);
  }

  /// What six_times() returned, with everything that was rounded away.
  CapRange<Scalar> widened(const Number& six_times) const {
    using Kind = typename CapRange<Scalar>::Kind;
    if (negative_) return {Kind::Unbounded, Scalar(0.0), Scalar(0.0)};
    const double n = 16 + 2 * static_cast<double>(ring_.arm.size());
    const Scalar slop = Scalar(2 * n * unit_);
    const Scalar tiny = Scalar(ExponentRange<Scalar>::kVolumeUnderflow);
    const Scalar lower = six_times.lower * (Scalar(1.0) - slop) - tiny;
    return {doubtful_ ? Kind::Doubtful : Kind::Bounded, is_positive(lower) ? lower : Scalar(0.0),
            doubtful_ ? CapRange<Scalar>::doubtful().upper
                      : six_times.upper * (Scalar(1.0) + slop) + tiny};
  }
  /// Whether every D asked for so far is proven positive.
  bool is_certain() const { return !doubtful_; }

 private:
  Number lift(const Scalar& value, double error) const {
    const Scalar lower = value - Scalar(error);
    return {is_positive(lower) ? lower : Scalar(0.0), value + Scalar(error)};
  }
  // Of D as computed from a point and the differences f and g of the two others to it.
  Number positive(const Scalar& value, const Triple<Scalar>& f, const Triple<Scalar>& g) {
    Extent sides;
    sides.include(f);
    sides.include(g);
    const Scalar error = Scalar(filter_for<Scalar>(sides.size, unit_).determinant);
    Number range{value - error, value + error};
    negative_ |= range.upper < Scalar(0.0);
    const Scalar smallest = Scalar(ExponentRange<Scalar>::kSmallestDeterminant);
    if (range.lower > smallest) return range;
    // The upper end of the sum is void now. Its lower end has no use for this one, and is true for
    // any larger D.
    doubtful_ = true;
    if (range.upper < smallest) range.upper = smallest;
    return range;
  }

  const RingGeometry<Scalar>& ring_;
  double unit_;
  double arm_error_, error_;  // of heights: of arms alone, and of any points
  Triple<Scalar> first_{}, second_{}, normal_{};
  std::uint32_t low_ = 0;
  bool negative_ = false, doubtful_ = false;
};

}  // namespace convexact
