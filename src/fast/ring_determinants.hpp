// SPDX-License-Identifier: MIT
// ring_determinants.hpp - the determinants that the measures of a cap are made of, rounded and as
// intervals, and the bounds of a cost that follow.
//
// Of a dual point i with ring 0 .. k-1, from dual points P (all w = 1): D(abc) = det(P_a, P_b,
// P_c), and H(abc,p) as in DualSigns::height. CapVolume, add_cone() and Roof take any type
// `Determinants` that computes them, all of them >= 0, in a number type that it chooses:
//
//   Number base(m)       D(i, m, m + 1)
//   Number slack(m)      |H(i, 0, 1, m)|
//   Number leg(m, q)     |H(i, m, m + 1, q)|
//   void set_triangle(low, middle, high)      abc, which the next three refer to
//   Number vertex()      D(abc)
//   Number to_center()   |H(abc, i)|
//   Number to(q)         |H(abc, q)|
//
// and whose Sum has add(Number) and scaled_down(Number), the sum divided by its argument.
#pragma once
#include <cstdint>
#include <limits>

#include "fast/ring.hpp"
#include "fast/signs.hpp"

namespace convexact {

/// Whether every vertex of a cap exists.
enum class Boundedness : unsigned char {
  Bounded,    ///< Proven: every triangle of T has D > 0.
  Unbounded,  ///< Proven: some triangle of T has D < 0.
  Doubtful,   ///< Some D is too small for its sign to be certain in this arithmetic.
};

/// The bounds that one arithmetic proves of a cap, as long as T is right.
template <class Scalar>
struct CostBounds {
  Boundedness kind;
  Scalar lower;  ///< At most a multiple of the cost, >= 0; also where the kind is Doubtful.
  Scalar upper;  ///< At least that, if the cap is bounded.

  static CostBounds doubtful() {
    return {Boundedness::Doubtful, Scalar(0.0), Scalar(std::numeric_limits<double>::infinity())};
  }
};

/// Whether the ends differ by at most a thousandth.
inline bool are_close(const DoubleDouble& lower, const DoubleDouble& upper) {
  constexpr double kClose = 1 + 0x1p-10;
  return upper.hi() <= kClose * lower.hi();
}

/// The same with the volume as it is computed.
template <class Scalar>
struct CostEstimate : CostBounds<Scalar> {
  /// Six times the volume. *Not* the middle of the bounds: where H is near zero, its bound is often
  /// 10^6 times its error, and the upper bound of a cap may be of any size.
  Scalar value;
};

/// Determinants of a ring as they come out.
template <class Scalar>
class RoundedDeterminants {
 public:
  using Number = Scalar;
  struct Sum {
    Number total{0.0};
    void add(const Number& x) { total += x; }
    Number scaled_down(const Number& x) const { return total / x; }
  };

  explicit RoundedDeterminants(const RingGeometry<Scalar>& ring) : ring_(ring) {}

  Number base(std::uint32_t m) const { return dot(ring_.side[m], ring_.center); }
  Number slack(std::uint32_t m) const { return lift(-dot(ring_.side[0], ring_.arm[m])); }
  Number leg(std::uint32_t m, std::uint32_t q) const {
    return lift(-dot(ring_.side[m], ring_.arm[q]));
  }
  void set_triangle(std::uint32_t low, std::uint32_t middle, std::uint32_t high) {
    low_ = low;
    normal_ = cross(ring_.point[middle] - ring_.point[low], ring_.point[high] - ring_.point[low]);
  }
  Number vertex() const { return dot(normal_, ring_.point[low_]); }
  Number to_center() const { return lift(-dot(normal_, ring_.arm[low_])); }
  Number to(std::uint32_t q) const {
    return lift(-dot(normal_, ring_.point[q] - ring_.point[low_]));
  }

 private:
  // A height is negative only by rounding.
  static Number lift(const Scalar& value) { return is_positive(value) ? value : Scalar(0.0); }

  const RingGeometry<Scalar>& ring_;
  Triple<Scalar> normal_{};
  std::uint32_t low_ = 0;
};

/// What determinants of a ring with their errors have in common: intervals that hold the true ones,
/// and the bounds of a cost that follow.
///
/// Rounding: below any term of the sum lie 5 factors, each of whose ends is rounded once, 3
/// products and 4 quotients; then up to 2 k additions. So 13 + 2 k units bound the relative error
/// of an end, and twice (16 + 2 k) leaves room for higher orders.
template <class Scalar>
class CapRanges {
 public:
  using Number = Interval<Scalar>;
  struct Sum {
    Number total{Scalar(0.0), Scalar(0.0)};
    void add(const Number& x) {
      total.lower += x.lower;
      total.upper += x.upper;
    }
    Number scaled_down(const Number& x) const { return total / x; }
  };

  /// The result of CapVolume from these determinants, widened by all rounding errors.
  CostBounds<Scalar> widened(const Number& six_times) const {
    if (negative_) return {Boundedness::Unbounded, Scalar(0.0), Scalar(0.0)};
    const double n = 16 + 2 * static_cast<double>(length_);
    const Scalar slop = Scalar(2 * n * unit_);
    const Scalar tiny = Scalar(ExponentRange<Scalar>::kVolumeUnderflow);
    const Scalar lower = six_times.lower * (Scalar(1.0) - slop) - tiny;
    return {doubtful_ ? Boundedness::Doubtful : Boundedness::Bounded,
            is_positive(lower) ? lower : Scalar(0.0),
            doubtful_ ? CostBounds<Scalar>::doubtful().upper
                      : six_times.upper * (Scalar(1.0) + slop) + tiny};
  }
  /// Whether every D asked for so far is proven positive.
  bool is_certain() const { return !doubtful_; }
  /// Whether some D asked for so far is proven negative: then the cap is unbounded.
  bool is_negative() const { return negative_; }

 protected:
  /// @param length  Of the ring. @param unit  As of Roundoff.
  CapRanges(std::size_t length, double unit) : length_(length), unit_(unit) {}

  static Number lift(const Scalar& value, double error) {
    const Scalar lower = value - Scalar(error);
    return {is_positive(lower) ? lower : Scalar(0.0), value + Scalar(error)};
  }
  // Of a D as computed.
  Number positive(const Scalar& value, double error) {
    Number range{value - Scalar(error), value + Scalar(error)};
    negative_ |= range.upper < Scalar(0.0);
    const Scalar smallest = Scalar(ExponentRange<Scalar>::kSmallestDeterminant);
    if (range.lower > smallest) return range;
    // Now the sum has no upper end. Its lower end divides by range.upper only, and stays true for
    // any larger D.
    doubtful_ = true;
    if (range.upper < smallest) range.upper = smallest;
    return range;
  }

 private:
  std::size_t length_;
  double unit_;
  bool negative_ = false, doubtful_ = false;
};

/// Determinants of a ring as intervals that hold the true ones, by the bounds of PlaneFilter.
template <class Scalar>
class IntervalDeterminants : public CapRanges<Scalar> {
 public:
  using Number = Interval<Scalar>;

  /// @param unit  As of Roundoff.
  IntervalDeterminants(const RingGeometry<Scalar>& ring, double unit)
      : CapRanges<Scalar>(ring.size, unit),
        ring_(ring),
        unit_(unit),
        arm_error_(ring.arm_filter(unit).height),
        error_(ring.filter(unit).height) {}

  // D by the bounds of their triangles alone: in a long ring, the bound for all of it would exceed
  // a small D.
  Number base(std::uint32_t m) {
    const std::size_t next = m + 1 == ring_.size ? 0 : m + 1;
    return positive(dot(ring_.side[m], ring_.center), ring_.arm[m], ring_.arm[next]);
  }
  Number slack(std::uint32_t m) const {
    return this->lift(-dot(ring_.side[0], ring_.arm[m]), arm_error_);
  }
  Number leg(std::uint32_t m, std::uint32_t q) const {
    return this->lift(-dot(ring_.side[m], ring_.arm[q]), arm_error_);
  }
  void set_triangle(std::uint32_t low, std::uint32_t middle, std::uint32_t high) {
    low_ = low;
    first_ = ring_.point[middle] - ring_.point[low];
    second_ = ring_.point[high] - ring_.point[low];
    normal_ = cross(first_, second_);
  }
  Number vertex() { return positive(dot(normal_, ring_.point[low_]), first_, second_); }
  Number to_center() const { return this->lift(-dot(normal_, ring_.arm[low_]), error_); }
  Number to(std::uint32_t q) const {
    return this->lift(-dot(normal_, ring_.point[q] - ring_.point[low_]), error_);
  }

 private:
  // Of D as computed from a point and the differences f and g of the two others to it.
  Number positive(const Scalar& value, const Triple<Scalar>& f, const Triple<Scalar>& g) {
    Extent sides;
    sides.include(f);
    sides.include(g);
    return CapRanges<Scalar>::positive(value, filter_for<Scalar>(sides.size, unit_).determinant);
  }

  const RingGeometry<Scalar>& ring_;
  double unit_;
  double arm_error_, error_;  // of heights: of arms alone, and of any points
  Triple<Scalar> first_{}, second_{}, normal_{};
  std::uint32_t low_ = 0;
};

}  // namespace convexact
