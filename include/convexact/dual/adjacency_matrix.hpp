// SPDX-License-Identifier: MIT
// adjacency_matrix.hpp - the triangulated dual hull as a sparse matrix of directed edges.
#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "convexact/geometry/ids.hpp"

namespace convexact {

/// Entry (i, j) = k says that the triangle (i, j, k) lies to the left of the directed edge i -> j,
/// seen from outside. A row holds the one-ring of its dual point, so memory is linear in the edges.
/// The paper's own data structure for the topology of the dual.
class AdjacencyMatrix {
 public:
  explicit AdjacencyMatrix(std::size_t size) : rows_(size) {}

  std::size_t size() const { return rows_.size(); }
  /// Sets the three entries of a triangle. Precondition: none of them is set.
  void add(const DualTriangle& triangle);
  /// Clears the three entries of a triangle that is present.
  void remove(const DualTriangle& triangle);
  /// Entry (i, j).
  std::optional<HalfspaceId> at(HalfspaceId i, HalfspaceId j) const;
  /// Neighbours of i, counter-clockwise from outside, starting at the lowest id; empty if i has
  /// none.
  std::vector<HalfspaceId> one_ring(HalfspaceId i) const;
  /// Every triangle once, lowest id first, ascending.
  std::vector<DualTriangle> triangles() const;
  /// (i, j) is set iff (j, i) is; (i, j) = k implies (j, k) = i and (k, i) = j; one ring per row.
  bool is_closed_manifold() const;
  /// The matrix as a table of text: a row per line, '.' where unset. For teaching.
  std::string dense() const;

 private:
  using Entry = std::pair<HalfspaceId, HalfspaceId>;  // column j, value k
  std::vector<std::vector<Entry>> rows_;
};

}  // namespace convexact
