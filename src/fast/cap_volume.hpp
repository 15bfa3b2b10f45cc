// SPDX-License-Identifier: MIT
// cap_volume.hpp - the volume of a cap in any arithmetic: a formula that is always accurate, and a
// quicker one that is mostly accurate, with a bound for its roundings.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "fast/mesh.hpp"
#include "fast/ring.hpp"
#include "fast/ring_determinants.hpp"
#include "fast/signs.hpp"

namespace convexact {

/// Six times the volume of the cap of a dual point i with ring 0 .. k-1 and triangulation T, from
/// determinants of dual points P (all w = 1). Write D(abc) = det(P_a, P_b, P_c) and H(abc,p) as in
/// DualSigns::height; the plane of p cuts the vertex of abc at slack |H(abc,p)| / D(abc).
///
/// The cap is cut into tetrahedra: from the base vertex v_0 = (i, 0, 1) over each facet in a ring
/// plane r, that facet in a fan from its base vertex v_r = (i, r, r + 1). A triangle of the fan
/// stands on the segment that plane q, a neighbour of r in T or in the ring, cuts out of the facet,
/// between the vertices of (r, a, q) and (r, q, b). The segment is H(raq,b) / (D(raq) D(rqb)) times
/// P_r x P_q long, and with det(u, v, p x q) = (u.p)(v.q) - (u.q)(v.p) six times the volume of the
/// tetrahedron comes out as
///
///   slack(r, v_0) slack(q, v_r) |H(raq,b)| / (D(raq) D(rqb)).
///
/// No factor is ever negative, and the D are those of true vertices, all positive: nothing
/// cancels, and there is no singular case. (In the sum over T of H^3 / (D D D D) [Lawrence1991] the
/// D of an inner diagonal may vanish, and does on every prism.)
///
/// @tparam Determinants  Of ring_determinants.hpp, or exact ones with the same members.
template <class Determinants>
class CapVolume {
 public:
  using Number = typename Determinants::Number;

  Number six_times(std::uint32_t k, std::span<const RingTriangle> triangles, Determinants& of);

 private:
  std::vector<Number> base_, slack_, vertex_;
};

template <class Determinants>
typename Determinants::Number CapVolume<Determinants>::six_times(
    std::uint32_t k, std::span<const RingTriangle> triangles, Determinants& of) {
  base_.clear();
  slack_.clear();
  vertex_.clear();
  for (std::uint32_t m = 0; m < k; ++m) base_.push_back(of.base(m));
  for (std::uint32_t m = 0; m < k; ++m) slack_.push_back(of.slack(m));
  // slack(m, v_0) slack(q, v_m), less the common 1 / D(i, 0, 1). Zero for m = 0, 1: v_0 lies there.
  const auto legs = [&](std::uint32_t m, std::uint32_t q) {
    return slack_[m] * of.leg(m, q) / base_[m];
  };
  typename Determinants::Sum sum;
  for (const auto& [low, middle, high, parent] : triangles) {
    of.set_triangle(low, middle, high);
    vertex_.push_back(of.vertex());
    // A segment along an edge of the ring ends in the base: there b is i itself.
    const bool first = middle == low + 1 && middle >= 2, second = high == middle + 1;
    if (first || second) {
      const Number to_base = of.to_center() / vertex_.back();
      if (first) sum.add(legs(middle, low) * to_base / base_[low]);
      if (second) sum.add(legs(high, middle) * to_base / base_[middle]);
    }
    if (parent == kNone) continue;
    const RingTriangle& above = triangles[parent];
    const Number segment =
        of.to(above.low == low ? above.high : above.low) / (vertex_.back() * vertex_[parent]);
    if (low >= 2) sum.add(legs(low, high) * segment);
    sum.add(legs(high, low) * segment);
  }
  return sum.scaled_down(base_[0]);
}

/// Adds six times the volume of the cone from the center over facet i, whose ring has k members, to
/// `sum`. The facet is cut in a fan from its vertex v = (i, 0, 1); a triangle of it stands on the
/// edge that ring plane q cuts out, between q - 1 and q + 1. As in CapVolume, with the center
/// (where every slack is 1) as the apex, six times the tetrahedron is
///   slack(q, v) |H(i q-1 q, q+1)| / (D(i, q-1, q) D(i, q, q+1)).
/// The cones over all facets make up the solid.
/// @param of  As for CapVolume.
template <class Determinants>
void add_cone(std::uint32_t k, Determinants& of, typename Determinants::Sum& sum) {
  using Number = typename Determinants::Number;
  const Number first = of.base(0);
  for (std::uint32_t q = 2; q < k; ++q) {
    const Number opening = of.slack(q) / first;
    const Number edge = of.leg(q - 1, q + 1 == k ? 0 : q + 1) / of.base(q - 1);
    sum.add(opening * edge / of.base(q));
  }
}

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
///   by a relative (6 + 1 + 1 + 1) d / M from the D, each times less than 1.1 for what the others
///   do to it; rounding adds less than 16 u, and adding up k terms k u.
/// - Twice that allows for the computation of the error itself.
/// Underflow is as in IntervalDeterminants.
template <class Scalar>
class LawrenceSum {
 public:
  static constexpr double kMargin = 1024, kVertexError = 6, kRelativeErrors = kVertexError + 3;
  static_assert(3 + 2 + 1 <= kVertexError);  // D of a triangle: three D, an H <= 2 d, rounding
  static_assert(kRelativeErrors / kMargin < 0.05);
  static_assert(3 * 4 * 4 < PlaneFilter::kDeterminantFactor);
  /// If the relative error of a sum is more than this many units, or than this share, the slower
  /// way is worth its time.
  static constexpr double kAcceptable = 0x1p37, kAcceptableShare = 0x1p-8;

  /// Doubtful if another way must decide.
  CostBounds<Scalar> run(const RingGeometry<Scalar>& ring, std::span<const RingTriangle> triangles,
                         double unit);

  /// The sum as run() computed it, without a bound. *Stable*: the rounding of D changes it by at
  /// most kAcceptableShare, so no two terms cancel; the error of H does not count here.
  const Scalar& value() const { return value_; }
  bool is_stable() const { return stable_; }

 private:
  void start(const RingGeometry<Scalar>& ring);
  Scalar height_and_edges(const RingGeometry<Scalar>& ring, const RingTriangle& triangle,
                          std::size_t t);
  void note(const Scalar& determinant) {
    smallest_ = std::min(smallest_, std::abs(leading(determinant)));
  }

  // As long as for the longest ring so far.
  std::vector<Scalar> base_;            // D(i, m, m + 1)
  std::vector<Scalar> first_, second_;  // of each triangle D(i, low, middle), D(i, middle, high)
  double smallest_ = 0;                 // of all |D|
  Scalar value_{0.0};
  bool stable_ = false;
};

template <class Scalar>
void LawrenceSum<Scalar>::start(const RingGeometry<Scalar>& ring) {
  const std::size_t k = ring.size;
  if (k > base_.size()) {
    base_.resize(k);
    first_.resize(k);
    second_.resize(k);
  }
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
CostBounds<Scalar> LawrenceSum<Scalar>::run(const RingGeometry<Scalar>& ring,
                                            std::span<const RingTriangle> triangles, double unit) {
  const PlaneFilter filter = ring.arm_filter(unit);
  start(ring);
  stable_ = false;
  Scalar sum(0.0);
  double from_heights = 0, total = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const Scalar height = height_and_edges(ring, triangles[t], t);
    const auto [low, middle, high, parent] = triangles[t];
    const Scalar above = parent == kNone                ? base_[ring.size - 1]
                         : triangles[parent].low == low ? -first_[parent]
                                                        : -second_[parent];
    const Scalar vertex = first_[t] + second_[t] + above - height;
    if (vertex < Scalar(-kVertexError * filter.determinant)) {
      return {Boundedness::Unbounded, Scalar(0.0), Scalar(0.0)};
    }
    if (!is_positive(vertex)) return CostBounds<Scalar>::doubtful();
    note(vertex);
    const Scalar weight = Scalar(1.0) / ((vertex * first_[t]) * (second_[t] * above));
    const Scalar term = height * height * height * weight;
    sum += term;
    const double highest = leading(height) + filter.height;
    from_heights += highest * highest * std::abs(leading(weight));
    total += std::abs(leading(term));
  }
  using Exponents = ExponentRange<Scalar>;
  if (!(smallest_ > std::max(kMargin * filter.determinant, Exponents::kSmallestDeterminant))) {
    return CostBounds<Scalar>::doubtful();
  }
  const double relative = kRelativeErrors * filter.determinant / smallest_ +
                          (16 + static_cast<double>(triangles.size())) * unit;
  value_ = sum;
  stable_ = 2 * total * relative <= kAcceptableShare * leading(sum);
  const double error =
      2 * (3 * filter.height * from_heights + total * relative) + Exponents::kVolumeUnderflow;
  const double acceptable = std::min(kAcceptable * unit, kAcceptableShare);
  if (!(error <= acceptable * leading(sum))) return CostBounds<Scalar>::doubtful();
  return {Boundedness::Bounded, sum - Scalar(error), sum + Scalar(error)};
}

/// The cost of removals in one arithmetic: the quick sum of LawrenceSum, which needs no H but those
/// of the removed plane, as long as no D is near zero; otherwise CapVolume.
template <class Scalar>
class CapCost {
 public:
  /// T is taken as it is.
  /// @param unit  As of Roundoff.
  CostBounds<Scalar> bounds(const RingGeometry<Scalar>& ring,
                            std::span<const RingTriangle> triangles, double unit) {
    CostBounds<Scalar> quick = quick_.run(ring, triangles, unit);
    if (quick.kind != Boundedness::Doubtful) return quick;
    IntervalDeterminants<Scalar> determinants(ring, unit);
    const auto k = static_cast<std::uint32_t>(ring.size);
    return determinants.widened(sure_.six_times(k, triangles, determinants));
  }
  /// With the volume as computed, by the formula that suits it. A bounded quick sum is stable.
  CostEstimate<Scalar> estimate(const RingGeometry<Scalar>& ring,
                                std::span<const RingTriangle> triangles, double unit) {
    const CostBounds<Scalar> proven = bounds(ring, triangles, unit);
    if (proven.kind != Boundedness::Bounded || quick_.is_stable()) {
      return {proven, quick_.value()};
    }
    RoundedDeterminants<Scalar> determinants(ring);
    const auto k = static_cast<std::uint32_t>(ring.size);
    return {proven, rounded_.six_times(k, triangles, determinants)};
  }

 private:
  LawrenceSum<Scalar> quick_;
  CapVolume<IntervalDeterminants<Scalar>> sure_;
  CapVolume<RoundedDeterminants<Scalar>> rounded_;
};

}  // namespace convexact
