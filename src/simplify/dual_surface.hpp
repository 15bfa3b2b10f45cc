// SPDX-License-Identifier: MIT
// dual_surface.hpp - the dual hull of a solid, which can lose dual points and regain them.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "convexact/cost.hpp"
#include "convexact/dual.hpp"
#include "number/random.hpp"
#include "simplify/ring_triangulation.hpp"

namespace convexact {

/// The change of the surface by one removal.
struct Removal {
  HalfspaceId removed;
  std::vector<HalfspaceId> ring;  ///< One-ring of `removed`, counter-clockwise from outside.
  RingTriangulation roof;         ///< T_i, which closes the ring without `removed`.
  std::optional<Cost> cost;       ///< What the cap adds to the measure; none if it is unbounded.
};

/// A closed convex surface of triangles on dual points, all of them exact. Every change keeps it
/// the hull of the dual points that are on it, so the halfspaces on it bound a solid, and none of
/// them is redundant.
class DualSurface {
 public:
  /// @param halfspaces  All halfspaces that may ever be on the surface; ids are positions.
  /// @param triangles   The dual hull of some of them, none redundant. The others can be inserted.
  /// @param center      Strictly inside all halfspaces.
  /// @param seed        For the choice among triangulations of level dual points.
  /// @param measure     Of the costs of removals.
  /// @throws Error      InvalidArgument if the center is not strictly inside.
  DualSurface(std::span<const Halfspace> halfspaces, std::span<const DualTriangle> triangles,
              const RationalPoint& center, std::uint64_t seed = 1,
              CostMeasure measure = CostMeasure::Volume);

  /// How many halfspaces there are, and how many of them are on the surface.
  std::size_t size() const { return points_.size(); }
  std::size_t left() const { return left_; }
  bool has(HalfspaceId i) const { return is_present_[i.index()]; }
  const AdjacencyMatrix& adjacency() const { return adjacency_; }
  std::vector<DualTriangle> triangles() const { return adjacency_.triangles(); }

  /// The change that removing a halfspace would make. Only the state of the generator changes.
  /// Precondition: has(i).
  /// @param observer  Watches the ring being triangulated; null for none.
  /// @par Cost        Expected O(k) exact operations for a ring of k.
  /// @par Source      [Jacobson2026]; docs/construction.md has the steps.
  [[nodiscard]] Removal removal_of(HalfspaceId i, RingObserver* observer = nullptr);

  /// The amount that a removal adds to any measure. Preconditions: those of apply().
  [[nodiscard]] Cost added_by(const Removal& removal, CostMeasure measure);

  /// Makes a removal. Preconditions: it is bounded, and it was computed when the triangles around
  /// removed halfspace were what they are now.
  void apply(const Removal& removal);
  /// Takes a removal back: exactly the triangles from before apply(). Precondition: the triangles
  /// of its roof are on the surface, as they are right after apply().
  void undo(const Removal& removal);

  /// Puts a halfspace onto the surface, one that was removed or a new one. The solid becomes the
  /// old one cut by it. Halfspaces that become redundant leave the surface, even if they still
  /// touch the solid in a vertex or an edge: there are none if all were facets of one solid.
  /// Unlike undo(), it may choose another triangulation of level dual points.
  /// Precondition: !has(i). @return  False, and nothing changes, if the halfspace is redundant.
  /// @par Cost  One exact sign for each triangle of the surface.
  bool insert(HalfspaceId i);

 private:
  DualPlane plane_of(const DualTriangle& t) const;

  std::vector<DualPoint> points_;
  std::vector<IntegerVector3> directions_;  // of the normals; none while only volumes are needed
  AdjacencyMatrix adjacency_;
  std::vector<bool> is_present_;
  std::size_t left_;
  CostMeasure measure_;
  Random random_;
};

}  // namespace convexact
