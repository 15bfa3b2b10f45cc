// SPDX-License-Identifier: MIT
// cap.hpp - the region that one removal adds, as an explicit polytope.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "convexact/cost.hpp"
#include "convexact/dual.hpp"
#include "convexact/geometry.hpp"
#include "simplify/ring_triangulation.hpp"

namespace convexact {

/// The cap of halfspace i: bounded by plane i (its base) and by the planes of the ring of i. Where
/// planes share a point some vertices coincide and some facets have no area.
struct Cap {
  /// Relative to the center. First the k vertices of the base: base vertex t is where planes i,
  /// ring[t] and ring[t + 1] meet. Then one for each triangle of T_i.
  std::vector<DualPlane> vertices;
  /// Side t lies in the plane of ring[t]: the cycle of its corners, the base vertices t - 1 and t
  /// last.
  std::vector<std::vector<std::uint32_t>> sides;
};

/// @param base  The k old dual planes: base[t] holds i, ring[t] and ring[t + 1].
/// @param roof  T_i of the same ring, bounded.
/// @par Cost    O(k).
[[nodiscard]] Cap make_cap(std::span<const HalfspaceId> ring, std::span<const DualPlane> base,
                           const RingTriangulation& roof);

/// The same from the dual points of all halfspaces, by id.
[[nodiscard]] Cap make_cap(std::span<const DualPoint> points, HalfspaceId i,
                           std::span<const HalfspaceId> ring, const RingTriangulation& roof);

/// One of the tetrahedra that a cap consists of; its fourth corner is base vertex 0.
struct CapTetrahedron {
  std::array<std::uint32_t, 3> corners;  ///< Of the cap's vertices.
  /// Six times its volume is n / (d e^3), e the d of base vertex 0; both are positive.
  Integer n, d;
};

/// Those that are not flat; the others have no volume. No tetrahedron counts negative.
/// @par Cost  O(k) determinants.
[[nodiscard]] std::vector<CapTetrahedron> tetrahedra(const Cap& cap);

/// Exact volume by tetrahedra().
/// @par Cost  O(k) determinants, and a balanced sum of that many rationals.
[[nodiscard]] Rational volume(const Cap& cap);

/// How much a measure of the solid grows if the cap is added: by its volume; by the areas of its
/// sides less that of its base; by the lengths times exterior angles of its edges that are not on
/// the base, less those of the base.
/// @param directions  primitive_directions() of all halfspaces; not needed for volumes.
/// @param ring        Of i, from which the cap was made.
/// @par Source        [Jacobson2026]; docs/design/costs.md
[[nodiscard]] Cost cost_of(const Cap& cap, std::span<const IntegerVector3> directions,
                           HalfspaceId i, std::span<const HalfspaceId> ring, CostMeasure measure);

/// Of each dual point the direction of its halfspace's normal, as coprime integers.
[[nodiscard]] std::vector<IntegerVector3> primitive_directions(std::span<const DualPoint> points);

}  // namespace convexact
