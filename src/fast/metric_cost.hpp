// SPDX-License-Identifier: MIT
// metric_cost.hpp - what a removal adds to the area or the mean width, in doubles with proven
// bounds.
#pragma once
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

#include "convexact/cost.hpp"
#include "fast/angular_excess.hpp"
#include "fast/cap_volume.hpp"
#include "fast/dual.hpp"
#include "fast/mesh.hpp"
#include "fast/ring.hpp"
#include "fast/roof.hpp"

namespace convexact {

/// A part of a cost that remains, and does not shrink, as long as neither plane is removed.
struct LastingTerm {
  HalfspaceId x, y;  ///< Equal for a term of one plane.
  double lower;      ///< At most that part; >= 0.
};

/// Leaves out the terms that name the removed plane. @return  MetricCost::lower_bound() of the
/// rest.
double forget_terms_of(HalfspaceId removed, std::vector<LastingTerm>& terms);

/// Lengths and directions of dual points in the caller's frame, up to one common power of two.
/// Neither is invariant under scaling single axes, as determinants are.
class DualNormals {
 public:
  /// Of a dual point p: |p| and p / |p|, off by kLengthError and kDirectionError units of roundoff.
  /// Both are NaN where the point is so small that underflow would spoil them.
  struct Normal {
    Triple<double> direction;
    double length;
  };
  /// (E1) With u the roundoff, the coordinates are off by 2u each, so |p| by a relative 2u. Squares
  /// and their sums add 3u, which the root halves, and it adds u: 4.5u. A component of the quotient
  /// has its own 2u, these 4.5u and its rounding, so the vector is off by 7.5u.
  static constexpr double kOfLength = 2 + 1.5 + 1, kLengthError = 5;
  static constexpr double kOfDirection = 2 + kOfLength + 1, kDirectionError = 8;
  static_assert(kOfLength < kLengthError && kOfDirection < kDirectionError);

  /// Where the largest coordinate is at least 2^this, squares stay in range, and what a coordinate
  /// loses to underflow is less than 2^-100 of |p|.
  static constexpr int kLeastExponent = -900;

  explicit DualNormals(const FastDual& dual);
  const Normal& operator[](HalfspaceId i) const { return normals_[i.index()]; }

 private:
  std::vector<Normal> normals_;
};

// The bounds of areas and mean widths in an arithmetic of any unit u (Roundoff); metric_cost.cpp
// has (E2), angular_excess.cpp (E6).

/// (E3) The versine 1 - cos theta = chord^2 / 2: off by chord * 24u + (24u)^2 / 2, and rounded by
/// 4u relative, at most 2 chord u.
inline double versine_error(double chord, double unit) {
  return unit * ((kChordError + 4) * chord + 0x1p-40);
}
/// (E7) What is rounded away in a sum of n numbers: n u, and twice that leaves room for higher
/// orders.
inline double sum_slop(std::size_t n, double unit) { return 2 * static_cast<double>(n) * unit; }
/// Below any term lie 5 determinants, each of whose ends is rounded once, 2 lengths (5u each), a
/// weight (2u), 7 products and quotients, and the additions to its side; from longer arithmetic,
/// one rounding to doubles.
inline constexpr std::size_t kOfTerm = 5 + 2 * 5 + 2 + 7 + 1;
static_assert(DualNormals::kLengthError <= 5);

/// Area and mean width of a cap beyond those of its base, as sums without subtraction.
///
/// Let theta_xy be the angle between the outward normals of planes x and y. A side of the cap, in
/// ring plane q, has the area S_q, and the base is as large as the sum of all S_q cos theta_iq:
///
///   area:         sum over q of S_q (1 - cos theta_iq),
///                 2 S_q = |P_q| * sum over the roof edges (q, r) of lambda slack(r, v_q);
///   mean width:   1 / (4 pi) * sum over roof edges (x, y) of lambda |P_x x P_y| f,
///                 f = theta_xy - theta_ix cos A_x - theta_iy cos A_y
///
/// with A_x and A_y the angles of the spherical triangle of the three normals. Roof, Slack and
/// lambda are those of Roof. f >= 0; docs/design/costs.md derives it.
///
/// If another plane than i is removed, the cap grows: sides and roof edges of planes that stay do
/// not shrink, and their weights depend on normals only. That makes terms lasting.
class MetricCost {
 public:
  /// Of Area or MeanWidth. @param dual  Must outlive the object.
  MetricCost(const FastDual& dual, CostMeasure measure) : normals_(dual), measure_(measure) {}

  /// Bounds of twice the area, or of 4 pi times the mean width, that the cap of i adds.
  /// @param ring  Ids of the ring of `geometry`. T is taken as it is.
  /// @param unit  As of Roundoff, of the arithmetic of `geometry`.
  template <class Scalar>
  CostBounds<double> bounds(const RingGeometry<Scalar>& geometry, HalfspaceId i,
                            std::span<const HalfspaceId> ring,
                            std::span<const RingTriangle> triangles, double unit);
  /// The terms of the lower bound found last, one for each plane or pair of planes.
  const std::vector<LastingTerm>& terms() const { return terms_; }
  /// The same as it is computed: the middle of the bounds, unless these are far apart.
  template <class Scalar>
  CostEstimate<double> estimate(const RingGeometry<Scalar>& geometry, HalfspaceId i,
                                std::span<const HalfspaceId> ring,
                                std::span<const RingTriangle> triangles, double unit);

  /// A lower bound of a cost by some of its terms.
  static double lower_bound(std::span<const LastingTerm> terms);

 private:
  struct Direction {
    Triple<double> from_i;  // to this normal
    double versine;         // 1 - cos theta_ix
    double chord;           // |from_i|
    double length;          // |P_x|
  };
  void load(HalfspaceId i, std::span<const HalfspaceId> ring);
  Triple<double> across(std::uint32_t x, std::uint32_t y) const {
    return normals_[ids_[y]].direction - normals_[ids_[x]].direction;
  }
  template <class Determinants>
  Interval<double> area(Roof<Determinants>& roof, std::span<const RingTriangle> triangles,
                        Determinants& determinants);
  template <class Determinants>
  Interval<double> mean_width(Roof<Determinants>& roof, std::span<const RingTriangle> triangles,
                              Determinants& determinants);
  template <class Determinants>
  Interval<double> sum(Roof<Determinants>& roof, std::span<const RingTriangle> triangles,
                       Determinants& determinants) {
    return measure_ == CostMeasure::Area ? area(roof, triangles, determinants)
                                         : mean_width(roof, triangles, determinants);
  }
  template <class Scalar>
  double value(const RingGeometry<Scalar>& geometry, std::span<const RingTriangle> triangles);
  Interval<double> weight(const Direction& q) const;
  CostBounds<double> widened(const Interval<double>& sum, bool is_certain);

  DualNormals normals_;
  CostMeasure measure_;
  Roof<IntervalDeterminants<double>> roof_;
  std::vector<Direction> ring_;
  std::span<const HalfspaceId> ids_;
  std::vector<Interval<double>> sides_;
  std::vector<LastingTerm> terms_;
};

// Visits the sides of a cap: visit(m, part) for parts of the sum over the roof edges of ring plane
// m, lambda slack(r, v_m).
template <class Determinants, class Visit>
void for_each_side_part(Roof<Determinants>& roof, std::uint32_t k,
                        std::span<const RingTriangle> triangles, Determinants& determinants,
                        Visit&& visit) {
  using Number = typename Determinants::Number;
  roof.for_each_edge(k, triangles, determinants,
                     [&](std::uint32_t x, std::uint32_t y, const Number& lambda) {
                       // The base vertex of x lies on the next plane of the ring: no slack.
                       if (y != (x + 1 == k ? 0 : x + 1)) {
                         visit(x, lambda * roof.slack(x, y, determinants));
                       }
                       visit(y, lambda * roof.slack(y, x, determinants));
                     });
}

inline Interval<double> in_doubles(const Interval<double>& x) { return x; }
template <class Scalar>
Interval<double> in_doubles(const Interval<Scalar>& x) {
  return {leading(x.lower), leading(x.upper)};
}

template <class Determinants>
Interval<double> MetricCost::area(Roof<Determinants>& roof, std::span<const RingTriangle> triangles,
                                  Determinants& determinants) {
  const auto k = static_cast<std::uint32_t>(ring_.size());
  sides_.assign(k, {0, 0});
  for_each_side_part(roof, k, triangles, determinants,
                     [&](std::uint32_t side, const typename Determinants::Number& part) {
                       const Interval<double> x = in_doubles(part);
                       sides_[side].lower += x.lower;
                       sides_[side].upper += x.upper;
                     });
  Interval<double> sum{0, 0};
  for (std::uint32_t m = 0; m < k; ++m) {
    const Interval<double> term = sides_[m] * weight(ring_[m]);
    terms_.push_back({ids_[m], ids_[m], term.lower});
    sum.lower += term.lower;
    sum.upper += term.upper;
  }
  return sum;
}

template <class Determinants>
Interval<double> MetricCost::mean_width(Roof<Determinants>& roof,
                                        std::span<const RingTriangle> triangles,
                                        Determinants& determinants) {
  Interval<double> sum{0, 0};
  using Number = typename Determinants::Number;
  roof.for_each_edge(static_cast<std::uint32_t>(ring_.size()), triangles, determinants,
                     [&](std::uint32_t x, std::uint32_t y, const Number& lambda) {
                       const Direction &p = ring_[x], &q = ring_[y];
                       const double lengths = p.length * q.length;
                       const auto excess = angular_excess(p.from_i, q.from_i, across(x, y));
                       const Interval<double> term =
                           in_doubles(lambda) *
                           Interval<double>{lengths * excess.lower, lengths * excess.upper};
                       terms_.push_back({ids_[x], ids_[y], term.lower});
                       sum.lower += term.lower;
                       sum.upper += term.upper;
                     });
  return sum;
}

template <class Scalar>
double MetricCost::value(const RingGeometry<Scalar>& geometry,
                         std::span<const RingTriangle> triangles) {
  const auto k = static_cast<std::uint32_t>(ring_.size());
  RoundedDeterminants<Scalar> determinants(geometry);
  Roof<RoundedDeterminants<Scalar>> roof;
  double sum = 0;
  if (measure_ == CostMeasure::Area) {
    for_each_side_part(roof, k, triangles, determinants, [&](std::uint32_t m, const Scalar& part) {
      sum += leading(part) * ring_[m].length * ring_[m].versine;
    });
    return sum;
  }
  roof.for_each_edge(k, triangles, determinants,
                     [&](std::uint32_t x, std::uint32_t y, const Scalar& lambda) {
                       const Direction &p = ring_[x], &q = ring_[y];
                       sum += leading(lambda) * p.length * q.length *
                              rounded_angular_excess(p.from_i, q.from_i, across(x, y));
                     });
  return sum;
}

template <class Scalar>
CostBounds<double> MetricCost::bounds(const RingGeometry<Scalar>& geometry, HalfspaceId i,
                                      std::span<const HalfspaceId> ring,
                                      std::span<const RingTriangle> triangles, double unit) {
  // Underflow is as for volumes: no factor is larger than there.
  static_assert(ExponentRange<Scalar>::kVolumeUnderflow == ExponentRange<double>::kVolumeUnderflow);
  load(i, ring);
  IntervalDeterminants<Scalar> determinants(geometry, unit);
  Interval<double> total{};
  if constexpr (std::is_same_v<Scalar, double>) {
    total = sum(roof_, triangles, determinants);  // without allocations
  } else {
    Roof<IntervalDeterminants<Scalar>> roof;
    total = sum(roof, triangles, determinants);
  }
  if (determinants.is_negative()) return {Boundedness::Unbounded, 0, 0};
  return widened(total, determinants.is_certain());
}

template <class Scalar>
CostEstimate<double> MetricCost::estimate(const RingGeometry<Scalar>& geometry, HalfspaceId i,
                                          std::span<const HalfspaceId> ring,
                                          std::span<const RingTriangle> triangles, double unit) {
  constexpr double kClose = 1 + 0x1p-20;
  const CostBounds<double> proven = bounds(geometry, i, ring, triangles, unit);
  if (proven.kind == Boundedness::Bounded && proven.upper <= kClose * proven.lower) {
    return {proven, proven.lower + (proven.upper - proven.lower) / 2};
  }
  if (proven.kind == Boundedness::Unbounded) return {proven, proven.lower};
  const double computed = value(geometry, triangles);
  return {proven, computed >= 0 ? computed : std::numeric_limits<double>::infinity()};
}

}  // namespace convexact
