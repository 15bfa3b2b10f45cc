// SPDX-License-Identifier: MIT
// cap.hpp - what one removal costs in the filtered engine: the cap of a dual point, its
// triangulation and its volume in three arithmetics.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "convexact/number.hpp"
#include "fast/cap_volume.hpp"
#include "fast/dual.hpp"
#include "fast/mesh.hpp"
#include "fast/ring.hpp"
#include "fast/signs.hpp"

namespace convexact {

/// The planes that determine a cap: the plane of its facet and those of all facets that share an
/// edge with it, counter-clockwise from outside. Planes that only pass through a vertex of the
/// facet bound nothing beyond it: without dual point i, the dual face they share with i keeps its
/// other points.
struct FacetOutline {
  HalfspaceId facet;
  std::vector<HalfspaceId> neighbours;
};

/// Receives every decision without exact numbers: a test decides it again, a proof records it.
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
  FilteredCap(const FastDual& dual, const HalfEdgeMesh& mesh, std::uint64_t seed,
              CostObserver* observer = nullptr)
      : dual_(dual), mesh_(mesh), observer_(observer), signs_(dual), seed_(seed) {}

  /// Reads the ring of i and triangulates it, unless it is the one read last.
  void prepare(HalfspaceId i);
  /// Forgets the ring read last: the mesh has changed.
  void invalidate() { prepared_.reset(); }
  const OneRing& ring() const { return ring_; }
  const std::vector<RingTriangle>& triangles() const { return triangles_; }

  /// Quick: bounds from doubles. Never Doubtful if the cap is unbounded, though the upper bound of
  /// a doubtful one is infinite. This and the next two are of the prepared cap.
  CostBounds<double> in_doubles();
  /// Sure: bounds with 85 bits. Precondition: the cap is bounded; so for exactly().
  CostBounds<DoubleDouble> in_double_doubles();
  /// The volume itself (not six times), in the caller's cubed units.
  Rational exactly() const;
  FacetOutline outline() const;

  const SignCounts& sign_counts() const { return signs_.counts(); }

 private:
  struct Beyond;
  struct ObservedBeyond;
  bool is_bounded() const;

  const FastDual& dual_;
  const HalfEdgeMesh& mesh_;
  CostObserver* observer_;
  DualSigns signs_;
  std::optional<HalfspaceId> prepared_;
  OneRing ring_;
  std::vector<RingTriangle> triangles_;
  RingTriangulator triangulator_;
  std::uint64_t seed_;
  RingGeometry<double> geometry_;
  RingGeometry<DoubleDouble> long_geometry_;
  CapCost<double> cost_;
  CapCost<DoubleDouble> long_cost_;
};

/// Six times the volume of the initial solid, in units of 2^dual.volume_exponent().
[[nodiscard]] CostBounds<double> six_times_volume(const FastDual& dual);
/// Volume of the solid whose dual hull the triangles are, exactly, in the caller's cubed units.
[[nodiscard]] Rational exact_volume(const FastDual& dual, std::span<const DualTriangle> triangles);

}  // namespace convexact
