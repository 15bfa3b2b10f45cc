// SPDX-License-Identifier: MIT
// support_program.hpp - how far a polytope reaches in a direction, by linear programming: the
// second of the two ways to containment, for a candidate made of halfspaces.
#pragma once
#include <vector>

#include "convexact/polytope.hpp"

namespace convexact {

/// Maximises linear functionals over a polytope, given by its facets, by the simplex method: from
/// vertex to better neighbour, in doubles while these are certain, then exactly. The vertex where
/// it ends is proven optimal by duality: the functional is a nonnegative combination of the normals
/// of three facets there.
/// @par Source  [Schrijver1986, ch. 11 and cor. 7.1g]
class SupportProgram {
 public:
  /// Keeps a reference. @par Cost  O(E log E).
  explicit SupportProgram(const Polytope& polytope);

  /// max n.x over the polytope; n nonzero.
  /// @par Cost  A product in doubles for each neighbour on the way from the optimum of the last
  /// call,
  ///            then as many 3x3 determinants as facets meet in the vertex.
  [[nodiscard]] Rational maximum(const IntegerVector3& n);

 private:
  std::uint32_t climb_in_doubles(const Vector3<double>& direction) const;
  std::uint32_t better_neighbor(std::uint32_t vertex, const RationalVector3& n) const;
  bool is_optimal(std::size_t vertex, const IntegerVector3& n) const;

  const Polytope& polytope_;
  std::vector<Vector3<double>> near_;                  // the vertices, rounded
  std::vector<std::vector<std::uint32_t>> around_;     // facets at each vertex, counter-clockwise
  std::vector<std::vector<std::uint32_t>> neighbors_;  // vertices an edge away
  std::uint32_t last_ = 0;                             // the optimum that was found last
};

}  // namespace convexact
