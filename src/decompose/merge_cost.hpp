// SPDX-License-Identifier: MIT
// merge_cost.hpp - the exact cost of merging two clusters, and the order of such costs.
#pragma once
#include <span>
#include <utility>

#include "convexact/cluster.hpp"
#include "convexact/cost.hpp"

namespace convexact {

/// The data of the union S of two clusters on which its cost depends.
struct MergeCost {
  Rational squared_concavity;
  RootSum perimeter;     ///< Of the edges that an odd number of its triangles have.
  RootSum doubled_area;  ///< Twice the sum of its triangles' areas.
};

/// A term of a sum of roots: the root of a square.
[[nodiscard]] RootTerm root_of(const Rational& square);

/// By the definition. @param triangles  Of the union, ascending.
[[nodiscard]] MergeCost merge_cost(const Surface& surface, std::span<const TriangleId> triangles,
                                   const ExactConcavity& concavity, const Watch& watch = {});

/// The cost of a merge, a length:
///   E D = C + (weight / 10) perimeter^2 / (4 pi area),
/// C the concavity, and 0 instead of the quotient if there is no area. The quotient measures the
/// shape: it is 1 for a disk, and more for less round shapes.
/// @par Source  [MamouGhorbel2009]; docs/design/clustering.md
class CostOrder {
 public:
  /// The finest enclosures that are compared before two costs count as equal without a proof.
  static constexpr long kMostBits = 4096;

  explicit CostOrder(Rational squared_weight) : squared_weight_(std::move(squared_weight)) {}

  [[nodiscard]] Enclosure enclose(const MergeCost& cost, long precision,
                                  const Watch& watch = {}) const;

  /// Whether concavities and all terms are the same, and so the costs.
  [[nodiscard]] static bool have_same_terms(const MergeCost& a, const MergeCost& b);

  /// Equal if all terms are the same; else by enclosures of 128 bits; if these overlap, by the
  /// proof that concavities are equal, and so are perimeters and areas or, for small clusters, the
  /// quotients; otherwise by finer enclosures, which may leave it Undecided.
  /// @throws Error Stopped when the watch ends the call.
  [[nodiscard]] Ordering compare(const MergeCost& a, const MergeCost& b,
                                 const Watch& watch = {}) const;

 private:
  Rational squared_weight_;
};

}  // namespace convexact
