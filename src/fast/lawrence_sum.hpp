// SPDX-License-Identifier: MIT
// lawrence_sum.hpp - the volume of a cap by signed simplices: the quick way, where it is accurate.
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "fast/cap_range.hpp"

namespace convexact {

/// Six times the volume of a cap as the sum, over the triangles abc of T, of
///   H^3 / (D(abc) D(iab) D(ibc) D(ica)),   H = |H(abc,i)|,
/// each term the signed simplex of four planes. Only about half as many operations as CapVolume;
/// but D of an inner diagonal has any sign, and close to zero the terms cancel.
/// @par Source  [Lawrence1991]
///
/// With e the arms and S(ab) = e_a x e_b: D(iab) = P_i.S(ab), H = -S(ab).e_c, and by expanding
/// det(P_i + e_a, P_i + e_b, P_i + e_c), D(abc) = D(iab) + D(ibc) + D(ica) - H.
///
/// Error, with h and d the bounds of PlaneFilter for heights and determinants of arms (h <= 2 d):
/// - H is off by h, D(iab) by d, D(abc) by 3 d + h from its parts and by 3 u (4 * 4 B) < d from
///   rounding, the parts being at most 4 B in size: by 6 d.
/// - If all |D| are at least M >= kMargin d, a term is off by 3 h (H + h)^2 / |D D D D| from H and
/// by
///   a relative (6 + 1 + 1 + 1) d / M from the D, each times less than 1.1 for what the
///   others do to it; rounding adds less than 16 u, and adding up k terms k u.
/// - Twice that allows for the computation of the error itself.
/// Underflow is as in RangeSource.
template <class Scalar>
class LawrenceSum {
 public:
  static constexpr double kMargin = 1024, kVertexError = 6, kRelativeErrors = kVertexError + 3;
  static_assert(3 + 2 + 1 <= kVertexError);  // D of a triangle: three D, an H <= 2 d, rounding
  static_assert(kRelativeErrors / kMargin < 0.05);
  static_assert(3 * 4 * 4 < PlaneFilter::kDeterminantFactor);
  /// A sum whose relative error is more than this many units, or than this share, is worth the
  /// slower way.
  static constexpr double kAcceptable = 0x1p37, kAcceptableShare = 0x1p-8;

  /// Doubtful where another way must decide.
  CapRange<Scalar> run(const RingGeometry<Scalar>& ring, std::span<const RingTriangle> triangles,
                       double unit);

  /// The sum as run() computed it, for callers that need no bound. *Stable*: what D being rounded
  /// may do to it is within kAcceptableShare, so no two terms cancel. How far H is off is not
  /// asked.
  const Scalar& value() const { return value_; }
  bool is_stable() const { return stable_; }

 private:
  void start(const RingGeometry<Scalar>& ring);
  Scalar height_and_edges(const RingGeometry<Scalar>& ring, const RingTriangle& triangle,
                          std::size_t t);
  void note(const Scalar& determinant) {
    smallest_ = std::min(smallest_, std::abs(leading(determinant)));
  }

  std::vector<Scalar> base_;            // D(i, m, m + 1)
  std::vector<Scalar> first_, second_;  // of each triangle D(i, low, middle), D(i, middle, high)
  double smallest_ = 0;                 // of all |D|
  Scalar value_{0.0};
  bool stable_ = false;
};

template <class Scalar>
void LawrenceSum<Scalar>::start(const RingGeometry<Scalar>& ring) {
  const std::size_t k = ring.arm.size();
  base_.resize(k);
  first_.resize(k);
  second_.resize(k);
  smallest_ = std::numeric_limits<double>::infinity();
  for (std::size_t m = 0; m < k; ++m) {
    base_[m] = dot(ring.side[m], ring.center);
    note(base_[m]);
  }
}

// H of a triangle; D of its two lower edges, which are edges of the ring or inner diagonals.
template <class Scalar>
inline Scalar LawrenceSum<Scalar>::height_and_edges(const RingGeometry<Scalar>& ring,
                                                    const RingTriangle& triangle, std::size_t t) {
  const auto& [low, middle, high, parent] = triangle;
  Scalar height;
  if (middle == low + 1) {
    first_[t] = base_[low];
    height = -dot(ring.side[low], ring.arm[high]);
  } else {
    const Triple<Scalar> side = cross(ring.arm[low], ring.arm[middle]);
    first_[t] = dot(side, ring.center);
    note(first_[t]);
    height = -dot(side, ring.arm[high]);
  }
  if (high == middle + 1) {
    second_[t] = base_[middle];
  } else {
    second_[t] = dot(cross(ring.arm[middle], ring.arm[high]), ring.center);
    note(second_[t]);
  }
  return is_positive(height) ? height : Scalar(0.0);
}

template <class Scalar>
CapRange<Scalar> LawrenceSum<Scalar>::run(const RingGeometry<Scalar>& ring,
                                          std::span<const RingTriangle> triangles, double unit) {
  using Kind = typename CapRange<Scalar>::Kind;
  const PlaneFilter filter = ring.arm_filter(unit);
  start(ring);
  stable_ = false;
  Scalar sum(0.0);
  double from_heights = 0, total = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const Scalar height = height_and_edges(ring, triangles[t], t);
    const auto [low, middle, high, parent] = triangles[t];
    const Scalar above = parent == kNone                ? base_.back()
                         : triangles[parent].low == low ? -first_[parent]
                                                        : -second_[parent];
    const Scalar vertex = first_[t] + second_[t] + above - height;
    if (vertex < Scalar(-kVertexError * filter.determinant)) {
      return {Kind::Unbounded, Scalar(0.0), Scalar(0.0)};
    }
    if (!is_positive(vertex)) return CapRange<Scalar>::doubtful();
    note(vertex);
    const Scalar weight = Scalar(1.0) / ((vertex * first_[t]) * (second_[t] * above));
    const Scalar term = height * height * height * weight;
    sum += term;
    const double raised = leading(height) + filter.height;
    from_heights += raised * raised * std::abs(leading(weight));
    total += std::abs(leading(term));
  }
  using Exponents = ExponentRange<Scalar>;
  if (!(smallest_ > std::max(kMargin * filter.determinant, Exponents::kSmallestDeterminant))) {
    return CapRange<Scalar>::doubtful();
  }
  const double relative = kRelativeErrors * filter.determinant / smallest_ +
                          (16 + static_cast<double>(triangles.size())) * unit;
  value_ = sum;
  stable_ = 2 * total * relative <= kAcceptableShare * leading(sum);
  const double error =
      2 * (3 * filter.height * from_heights + total * relative) + Exponents::kVolumeUnderflow;
  const double acceptable = std::min(kAcceptable * unit, kAcceptableShare);
  if (!(error <= acceptable * leading(sum))) return CapRange<Scalar>::doubtful();
  return {Kind::Bounded, sum - Scalar(error), sum + Scalar(error)};
}

}  // namespace convexact
