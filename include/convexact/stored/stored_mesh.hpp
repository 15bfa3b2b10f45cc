// SPDX-License-Identifier: MIT
// stored_mesh.hpp - a result as vertices in binary64 or binary32 whose hull still holds the input.
#pragma once
#include <cstdint>
#include <span>

#include "convexact/geometry/point_set.hpp"
#include "convexact/geometry/polytope.hpp"
#include "convexact/io/mesh.hpp"
#include "convexact/number/precision.hpp"
#include "convexact/stored/growth.hpp"

namespace convexact {

/// A mesh that stands for the convex hull of its points, every coordinate a number of the format
/// `precision`, proven on these very numbers to hold every input point.
struct StoredMesh {
  Precision precision = Precision::Binary64;
  /// Extreme points; polygons are the maximal facets of their hull, counter-clockwise from outside.
  Mesh mesh;
  Growth growth;
  /// The vertices were scaled by 1 + factor from an interior point before they were rounded: 0, or
  /// a power of two.
  double factor = 0;
  std::size_t violations = 0;  ///< Input points found outside by the final pass: 0, or it throws.
};

/// Rounds the vertices of a result to nearest, scaled outward by the first rung 1 + f of the ladder
///   f = 0, u, 2u, 4u, ..., 1     (u = 2^-52 for binary64, 2^-23 for binary32)
/// for which their hull holds every witness; docs/stored.md has the argument.
/// @param exact      The result: full-dimensional, bounded, holding every input point.
/// @param input      n >= 4 points that span a volume.
/// @param witnesses  Input points whose hull holds all the others.
/// @throws Error     Unrepresentable if a coordinate overflows, if the ladder ends, or if the
/// stored
///                   solid lies farther from the exact one than that one is long; Internal if an
///                   input point is found outside.
/// @par Cost         For each rung a hull of the vertices and facets * witnesses products in
/// doubles;
///                   facets * points at the end.
[[nodiscard]] StoredMesh store_mesh(const Polytope& exact, const PointSet& input,
                                    std::span<const PointId> witnesses, Precision precision);

/// How many input points lie strictly outside the hull of a mesh's points; all of them if these
/// span no volume. Of what is read back from a file it proves the bytes.
[[nodiscard]] std::size_t count_outside_hull(const PointSet& mesh_points, const PointSet& input);

}  // namespace convexact
