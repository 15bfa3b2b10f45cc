// SPDX-License-Identifier: MIT
// cap.hpp - what one removal costs in the filtered engine: the cap of a dual point, its
// triangulation, and its volume, area or mean width in several arithmetics.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "convexact/cost.hpp"
#include "convexact/number.hpp"
#include "fast/cap_volume.hpp"
#include "fast/close_determinants.hpp"
#include "fast/congruence.hpp"
#include "fast/dual.hpp"
#include "fast/long_metric.hpp"
#include "fast/mesh.hpp"
#include "fast/metric_cost.hpp"
#include "fast/ring.hpp"
#include "fast/signs.hpp"

namespace convexact {

/// Receives every decision made without exact numbers: tests decide it again, proofs record it.
class CostObserver {
 public:
  virtual ~CostObserver() = default;
  /// H(a, b, c, p) by doubles, Unknown if they do not decide.
  virtual void height(HalfspaceId /*a*/, HalfspaceId /*b*/, HalfspaceId /*c*/, HalfspaceId /*p*/,
                      FilterSign) {}
  /// The bounds of the cap of i.
  virtual void in_doubles(HalfspaceId /*i*/, const OneRing&, const std::vector<RingTriangle>&,
                          const CostBounds<double>&) {}
  virtual void in_double_doubles(HalfspaceId /*i*/, const OneRing&,
                                 const std::vector<RingTriangle>&,
                                 const CostBounds<DoubleDouble>&) {}
};

/// The cap of one dual point of a shrinking dual hull. T is right: every sign is exact.
class FilteredCap {
 public:
  /// @param dual, mesh  Must outlive the object, as the observer.
  FilteredCap(const FastDual& dual, const HalfEdgeMesh& mesh, CostMeasure measure,
              std::uint64_t seed, CostObserver* observer = nullptr);

  /// Reads the ring of i and triangulates it, unless it is the one read last.
  void prepare(HalfspaceId i);
  /// The same for a dual point that is not on the mesh, with the ring that it would have.
  void prepare(HalfspaceId i, const OneRing& ring);
  /// Forgets the ring read last: the mesh has changed.
  void invalidate() { prepared_.reset(); }
  const OneRing& ring() const { return ring_; }
  const std::vector<RingTriangle>& triangles() const { return triangles_; }

  // Bounds are of multiples of the cost: 6 volumes, 2 areas, 4 pi mean widths, in units of
  // 2^dual.cost_exponent().

  /// Quick: bounds from doubles. Never Doubtful if the cap is unbounded, though the upper bound of
  /// a doubtful one is infinite. This function and the next two are about the prepared cap.
  CostBounds<double> in_doubles();
  /// Sure: bounds with 85 bits; of mean widths only where the normals around differ by less than 28
  /// degrees, elsewhere those of in_doubles(). Precondition, as for exactly(): the cap is bounded.
  CostBounds<DoubleDouble> in_double_doubles();
  /// The cost itself, in the caller's units.
  Cost exactly() const;
  /// Of any dual point on the mesh, which need not be prepared, and is not prepared then.
  FacetOutline outline(HalfspaceId i);
  /// Of area and mean width: the terms of the bounds found last. None for volumes, whose costs
  /// never fall.
  std::span<const LastingTerm> lasting_terms() const {
    return metric_ ? std::span<const LastingTerm>(metric_->terms())
                   : std::span<const LastingTerm>();
  }
  CostMeasure measure() const { return measure_; }

  const SignCounts& sign_counts() const { return signs_.counts(); }

 private:
  struct Beyond;
  struct ObservedBeyond;
  void triangulate(HalfspaceId i);
  bool is_bounded() const;
  CostBounds<DoubleDouble> bounds_of_doubles();

  const FastDual& dual_;
  const HalfEdgeMesh& mesh_;
  CostMeasure measure_;
  CostObserver* observer_;
  DualSigns signs_;
  std::optional<HalfspaceId> prepared_;
  OneRing ring_, outline_ring_;
  std::vector<RingTriangle> triangles_;
  RingTriangulator triangulator_;
  std::uint64_t seed_;
  RingGeometry<double> geometry_;
  RingGeometry<DoubleDouble> long_geometry_;
  CapCost<double> cost_;
  CapCost<DoubleDouble> long_cost_;
  CapVolume<CloseDeterminants> close_volume_;
  std::optional<MetricCost> metric_;  // this and the next unless the measure is the volume
  std::optional<LongMetric> long_metric_;
};

/// The factor between the bounds of FilteredCap and costs: 6, 2 or 4 pi.
[[nodiscard]] Interval<double> cost_multiple(CostMeasure measure);
/// A cost in units of 2^exponent, as two doubles around it.
[[nodiscard]] Interval<double> scaled_enclosure(const Cost& cost, long exponent);

/// Six times the volume of the solid whose dual hull the mesh is, in units of
/// 2^dual.volume_exponent(), to a share of 2^-20; without a mesh, of the initial solid.
/// @par Cost  Linear, in rationals only where doubles are too short.
[[nodiscard]] Interval<double> six_times_volume(const FastDual& dual, const HalfEdgeMesh& mesh);
[[nodiscard]] Interval<double> six_times_volume(const FastDual& dual);
/// Volume, area or mean width of the solid whose dual hull the triangles are, exactly, in the
/// caller's units.
[[nodiscard]] Cost exact_measure(const FastDual& dual, std::span<const DualTriangle> triangles,
                                 CostMeasure measure);

}  // namespace convexact
