// SPDX-License-Identifier: MIT
// stored.hpp - solids rounded outward to doubles, with the proof that no input point is lost.
//
// A result in rationals must be stored in binary64 or binary32. store_planes() and store_mesh()
// round it so that the stored numbers themselves, taken exactly, hold every input point, and say
// how far and by how much the solid grew. find_outside() is the test that both end with.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "convexact/error.hpp"
#include "convexact/geometry.hpp"
#include "convexact/io.hpp"
#include "convexact/number.hpp"

namespace convexact {

/// How rounding changed a solid.
struct Growth {
  /// Upper bound of the Hausdorff distance between the exact and the stored solid, divided by the
  /// diameter of the input (the diagonal of its axis-aligned box). 0 iff they are the same set;
  /// infinity if it is beyond the largest double.
  double push = 0;
  /// Upper bound of the stored solid's volume over the exact one's, from 128 bits; may be below 1,
  /// because both hold the input but not each other. Infinity beyond the largest double.
  double volume_ratio = 1;
};

/// The points that lie strictly outside at least one of the halfspaces, ascending. By the
/// definition of containment alone, without a hull, a dual or a certificate.
/// @param jobs  Threads, 1 to 256, on which the answer does not depend.
/// @throws Error Stopped when the watch ends it.
/// @par Cost  One product n.x in doubles for each halfspace and block of 128 points, if its proven
/// error bound decides the block's box (of many halfspaces one for each 32 with neighbouring
/// normals, if that does); otherwise one for each pair; exact arithmetic only where that leaves the
/// sign open.
[[nodiscard]] std::vector<PointId> find_outside(std::span<const Halfspace> halfspaces,
                                                const PointSet& points, const Watch& watch = {},
                                                std::size_t jobs = 1);

/// The number of these points.
[[nodiscard]] std::size_t count_outside(std::span<const Halfspace> halfspaces,
                                        const PointSet& points, std::size_t jobs = 1);

/// Halfspaces n.x + d <= 0 whose numbers are all of the format `precision`, proven on these very
/// numbers to be bounded and to hold every input point.
struct StoredPlanes {
  Precision precision = Precision::Binary64;
  /// n1, n2, n3, d in the order of the exact halfspaces; the largest |n_k| is in [1/2, 1].
  std::vector<std::array<double, 4>> planes;
  /// The same as exact integers. Two near-equal ones may have become equal.
  std::vector<Halfspace> halfspaces;
  Growth growth;
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

/// A mesh that stands for the convex hull of its points, every coordinate a number of the format
/// `precision`, proven on these very numbers to hold every input point.
struct StoredMesh {
  Precision precision = Precision::Binary64;
  /// Extreme points; polygons are the maximal facets of their hull, counter-clockwise from outside.
  Mesh mesh;
  Growth growth;
  std::size_t violations = 0;  ///< Input points found outside by the final pass: 0, or it throws.
};

/// Rounds the vertices of a result to nearest, scaled outward by the first rung 1 + f of the ladder
///   f = 0, u, 2u, 4u, ..., 1     (u = 2^-52 for binary64, 2^-23 for binary32)
/// for which their hull holds every witness; docs/stored.md has the argument.
/// @param exact      The result: full-dimensional, bounded, holding every input point.
/// @param input      n >= 4 points that span a volume.
/// @param witnesses  Input points whose hull holds all the others.
/// @throws Error     Unrepresentable if a coordinate overflows, if the ladder ends, or if the
///                   stored solid lies farther from the exact one than that one is long; Internal
///                   if an input point is found outside.
/// @par Cost         For each rung a hull of the vertices and facets * witnesses products in
///                   doubles; facets * points at the end.
[[nodiscard]] StoredMesh store_mesh(const Polytope& exact, const PointSet& input,
                                    std::span<const PointId> witnesses, Precision precision);

/// How many input points lie strictly outside the hull of a mesh's points; all of them if these
/// span no volume. Applied to a mesh that is read back from a file, it proves the bytes.
[[nodiscard]] std::size_t count_outside_hull(const PointSet& mesh_points, const PointSet& input);

}  // namespace convexact
