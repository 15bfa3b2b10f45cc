// SPDX-License-Identifier: MIT
// stored_planes.hpp - a result as halfspaces in binary64 or binary32 that still hold the input.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "convexact/geometry/point_set.hpp"
#include "convexact/geometry/polytope.hpp"
#include "convexact/number/precision.hpp"
#include "convexact/stored/growth.hpp"

namespace convexact {

/// Halfspaces n.x + d <= 0 whose numbers are all of the format `precision`, proven on these very
/// numbers to be bounded and to hold every input point.
struct StoredPlanes {
  Precision precision = Precision::Binary64;
  /// n1, n2, n3, d in the order of the exact halfspaces; the largest |n_k| is in [1/2, 1].
  std::vector<std::array<double, 4>> planes;
  /// The same as exact integers. Two near-equal ones may have become equal.
  std::vector<Halfspace> halfspaces;
  Growth growth;
  /// Normals that were not rounded to nearest, because the solid would have become unbounded.
  std::size_t turned = 0;
  std::size_t violations = 0;  ///< Input points found outside by the final pass: 0, or it throws.
};

/// Rounds the halfspaces of a result outward; docs/stored.md has the argument.
/// (1) Each normal is scaled by a power of two and rounded to nearest. (2) While some ray escapes,
/// the normals that stopped it before rounding and no longer do are rounded towards it instead,
/// each at most once. (3) Each offset is the largest of the format that keeps the witnesses inside.
/// @param exact      The result: full-dimensional, bounded, holding every input point.
/// @param input      n >= 4 points that span a volume.
/// @param witnesses  Input points whose hull holds all the others; they fix the offsets.
/// @throws Error     Unrepresentable if an offset overflows, if no rounding tried is bounded, or if
///                   the stored solid lies farther from the exact one than that one is long;
///                   Internal if an input point is found outside.
/// @par Cost         halfspaces * (witnesses + points) products in doubles, one dual hull.
[[nodiscard]] StoredPlanes store_planes(const Polytope& exact, const PointSet& input,
                                        std::span<const PointId> witnesses, Precision precision);

}  // namespace convexact
