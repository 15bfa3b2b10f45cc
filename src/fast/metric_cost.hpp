// SPDX-License-Identifier: MIT
// metric_cost.hpp - what a removal adds to the area or the mean width, in doubles with proven
// bounds.
#pragma once
#include <span>
#include <vector>

#include "convexact/cost.hpp"
#include "fast/cap_volume.hpp"
#include "fast/dual.hpp"
#include "fast/mesh.hpp"
#include "fast/ring.hpp"
#include "fast/roof.hpp"

namespace convexact {

/// A part of a cost that stays, and does not shrink, for as long as both planes are there.
struct LastingTerm {
  HalfspaceId x, y;  ///< Equal for a term of one plane.
  double lower;      ///< At most that part; >= 0.
};

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

  explicit DualNormals(const FastDual& dual);
  const Normal& operator[](HalfspaceId i) const { return normals_[i.index()]; }

 private:
  std::vector<Normal> normals_;
};

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
  CostBounds<double> bounds(const RingGeometry<double>& geometry, HalfspaceId i,
                            std::span<const HalfspaceId> ring,
                            std::span<const RingTriangle> triangles);
  /// The terms of the lower bound found last, one for each plane or pair of planes.
  const std::vector<LastingTerm>& terms() const { return terms_; }

  /// A lower bound of a cost by some of its terms.
  static double lower_bound(std::span<const LastingTerm> terms);

 private:
  using Determinants = IntervalDeterminants<double>;
  struct Direction {
    Triple<double> from_i;  // to this normal
    double versine;         // 1 - cos theta_ix
    double chord;           // |from_i|
    double length;          // |P_x|
  };
  void load(HalfspaceId i, std::span<const HalfspaceId> ring);
  Interval<double> area(std::uint32_t k, std::span<const RingTriangle> triangles,
                        Determinants& determinants);
  Interval<double> mean_width(std::uint32_t k, std::span<const RingTriangle> triangles,
                              Determinants& determinants);

  DualNormals normals_;
  CostMeasure measure_;
  Roof<Determinants> roof_;
  std::vector<Direction> ring_;
  std::span<const HalfspaceId> ids_;
  std::vector<Interval<double>> sides_;
  std::vector<LastingTerm> terms_;
};

/// sin theta times f of MetricCost, for normals i, x, y: of the differences between them. Where the
/// angles are too large for a bound, the interval is [0, infinity].
/// @param to_x, to_y  The differences from normal i; `across` that from x to y. All as computed
///                    from directions of DualNormals.
[[nodiscard]] Interval<double> angular_excess(const Triple<double>& to_x,
                                              const Triple<double>& to_y,
                                              const Triple<double>& across);

}  // namespace convexact
