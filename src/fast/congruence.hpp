// SPDX-License-Identifier: MIT
// congruence.hpp - caps that a symmetry of the axes carries to each other.
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "convexact/geometry.hpp"
#include "fast/dual.hpp"

namespace convexact {

/// The planes that determine a cap: the plane of its facet and those of all facets that share an
/// edge with it, counter-clockwise from outside. Planes that only pass through a vertex of the
/// facet bound nothing beyond it: without dual point i, the dual face they share with i keeps its
/// other points.
struct FacetOutline {
  HalfspaceId facet;
  std::vector<HalfspaceId> neighbours;
};

/// Whether some isometry x -> S x + t, S one of the 48 signed permutations of the axes, carries the
/// planes of `a` to those of `b`. True proves that both caps have the same volume, as mirror images
/// in modelled shapes have; false proves nothing.
///
/// Doubles refuse most pairs. Facets of a hull of doubles are compared by corners, as differences
/// of doubles are exact in two doubles; only if these do not correspond, as corners of a plane may
/// differ, its exact planes are formed.
/// @par Cost  Some hundred operations per plane by corners. By planes comparisons of integers,
///            mostly of the first few; k - 2 determinants if t != 0.
[[nodiscard]] bool are_congruent(const FastDual& dual, const FacetOutline& a,
                                 const FacetOutline& b);

/// Whether these planes are two planes and their images by one reflection, in a plane or a point,
/// as far as corners tell. Then H, the determinant of the rows (n, d), is zero. Translations do not
/// change it, so let t be zero. Then images have equal d; the difference of a row and its image is
/// a multiple of one vector for a reflection in a plane, and so is their sum for one in a point. So
/// the rows are dependent.
[[nodiscard]] bool are_mirror_pairs(const FastDual& dual, const std::array<HalfspaceId, 4>& planes);

/// Whether i stands before j in canonical order, if the corners of their facets correspond by an
/// isometry as above: then the normals have the same entries but for places and signs, and doubles
/// show which of two different entries is less. None if this does not decide.
[[nodiscard]] std::optional<bool> precedes_image(const FastDual& dual, HalfspaceId i,
                                                 HalfspaceId j);

}  // namespace convexact
