// SPDX-License-Identifier: MIT
// support_program.hpp - how far a polytope reaches in a direction, by linear programming: the
// second of the two ways to containment, for a candidate made of halfspaces.
#pragma once
#include <vector>

#include "convexact/geometry/edges.hpp"
#include "convexact/geometry/polytope.hpp"

namespace convexact {

/// Maximises linear functionals over a polytope, given by its facets. A vertex that doubles point
/// at is proven optimal by duality: the functional is a nonnegative combination of the normals of
/// three facets there. Where doubles point at the wrong vertex, Seidel's program decides.
/// @par Source  [Schrijver1986, cor. 7.1g]
class SupportProgram {
 public:
  /// Keeps a reference. @par Cost  O(E log E).
  explicit SupportProgram(const Polytope& polytope);

  /// max n.x over the polytope; n nonzero.
  /// @par Cost  V products in doubles, then as many 3x3 determinants as facets meet in a vertex.
  [[nodiscard]] Rational maximum(const IntegerVector3& n) const;

 private:
  std::vector<std::size_t> promising_vertices(const IntegerVector3& n) const;
  bool is_optimal(std::size_t vertex, const IntegerVector3& n) const;

  const Polytope& polytope_;
  std::vector<Vector3<double>> near_;               // the vertices, rounded
  std::vector<std::vector<std::uint32_t>> around_;  // facets at each vertex, counter-clockwise
};

}  // namespace convexact
