// SPDX-License-Identifier: MIT
// cap_estimate.hpp - the volume of a cap as plain arithmetic finds it, and how low it may be.
#pragma once
#include "fast/cap_range.hpp"
#include "fast/lawrence_sum.hpp"

namespace convexact {

/// Six times the volume of a cap.
template <class Scalar>
struct CapEstimate {
  typename CapRange<Scalar>::Kind kind;
  Scalar lower;  ///< Proven, if T is right; also where it is not found bounded.
  Scalar value;  ///< As computed. *Not* the middle of a range: where H is near zero, its bound is
                 ///< often 10^6 times its error, and a range may reach up to any size.
  Scalar upper;  ///< Proven, if T is right.
};

/// Determinants of a RingGeometry as they come out, for CapVolume.
template <class Scalar>
class PlainSource {
 public:
  using Number = Scalar;
  struct Sum {
    Number total{0.0};
    void add(const Number& x) { total += x; }
    Number scaled_down(const Number& x) const { return total / x; }
  };

  explicit PlainSource(const RingGeometry<Scalar>& ring) : ring_(ring) {}

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
  // What is negative only by rounding.
  static Number lift(const Scalar& value) { return is_positive(value) ? value : Scalar(0.0); }

  const RingGeometry<Scalar>& ring_;
  Triple<Scalar> normal_{};
  std::uint32_t low_ = 0;
};

/// Estimates caps, each by the formula that suits it: the sum of [Lawrence1991], which needs no H
/// but those of the removed plane, as long as no D is near zero; else CapVolume.
template <class Scalar>
class CapEstimator {
 public:
  /// T is taken as it is.
  /// @param unit  As of Roundoff.
  CapEstimate<Scalar> run(const RingGeometry<Scalar>& ring, std::span<const RingTriangle> triangles,
                          double unit) {
    using Kind = typename CapRange<Scalar>::Kind;
    const CapRange<Scalar> quick = lawrence_.run(ring, triangles, unit);
    if (quick.kind != Kind::Doubtful) {
      return {quick.kind, quick.lower, lawrence_.value(), quick.upper};
    }
    RangeSource<Scalar> ends(ring, unit);
    const auto k = static_cast<std::uint32_t>(ring.arm.size());
    const CapRange<Scalar> range = ends.widened(ranges_.six_times(k, triangles, ends));
    if (range.kind != Kind::Bounded || lawrence_.is_stable()) {
      return {range.kind, range.lower, lawrence_.value(), range.upper};
    }
    PlainSource<Scalar> source(ring);
    return {Kind::Bounded, range.lower, plain_.six_times(k, triangles, source), range.upper};
  }

 private:
  LawrenceSum<Scalar> lawrence_;
  CapVolume<RangeSource<Scalar>> ranges_;
  CapVolume<PlainSource<Scalar>> plain_;
};

}  // namespace convexact
