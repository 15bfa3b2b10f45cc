// SPDX-License-Identifier: MIT
// filtered_inner.hpp - the greedy removal of vertices at float speed, with the exact engine's
// answer.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "convexact/run.hpp"
#include "fast/keyed_queue.hpp"
#include "fast/mesh.hpp"
#include "fast/near_vertices.hpp"
#include "fast/ring.hpp"

namespace convexact {

/// How often each arithmetic was needed.
struct InnerCounts {
  std::uint64_t signs = 0;        ///< Decided by doubles.
  std::uint64_t exact_signs = 0;  ///< Decided by exact numbers.
  std::uint64_t evaluations = 0;  ///< Costs enclosed by doubles.
  std::uint64_t exact_costs = 0;  ///< Costs computed in integers.
};

/// The same removals, costs and ties as simplify_inner_exact(), by other means:
/// docs/design/inner.md. Costs are left to with_costs().
/// @throws Error  As simplify_inner_exact().
/// @par Cost      About k^2 flops per evaluated ring of k <= 16, O(k) above.
/// @par Source    [Jacobson2026], [Minoux1978]
[[nodiscard]] InnerRun simplify_inner_filtered(const VertexHull& hull,
                                               const InnerOptions& options = {},
                                               InnerCounts* counts = nullptr);

/// The loss of the hull with a vertex: the ring, the triangles that close it, and bounds of the sum
/// of the tetrahedra between these and the vertex.
class FilteredLoss {
 public:
  /// @param near, mesh  Must outlive the object.
  FilteredLoss(const NearVertices& near, const HalfEdgeMesh& mesh, std::uint64_t seed,
               InnerCounts& counts)
      : near_(near), mesh_(mesh), seed_(seed), counts_(counts) {}

  /// One tetrahedron. It is also lost if another vertex was removed before, unless that vertex is
  /// named here.
  struct Term {
    VertexId a, b, c;
    double lower;  ///< Of six times its volume.
  };

  /// Reads the ring of v and triangulates it. T is right: every sign is exact.
  void prepare(VertexId v);
  const OneRing& ring() const { return ring_; }
  const std::vector<RingTriangle>& triangles() const { return triangles_; }
  /// Bounds for the prepared vertex, from doubles: six times the volume, in units of NearVertices.
  /// @param terms  Receives the lower ends of the terms.
  Interval<double> bounds(std::vector<Term>& terms);
  /// The same, exactly, in units of NearVertices::exact().
  Integer exactly() const;

  /// A lower bound of a sum of terms.
  static double lower_bound(const std::vector<Term>& terms);

 private:
  struct Beyond;

  const NearVertices& near_;
  const HalfEdgeMesh& mesh_;
  std::uint64_t seed_;
  InnerCounts& counts_;
  VertexId vertex_;
  OneRing ring_;
  std::vector<RingTriangle> triangles_;
  RingTriangulator triangulator_;
  std::vector<Triple<double>> point_, arm_;  // of the ring; from the vertex to these
  Extent extent_;                            // of the arms
};

/// The queue holds for each vertex a lower bound of its cost. When its ring changes, the entry is
/// *stale*, and evaluated again only when it comes near the top. Costs may fall, so the old bound
/// is of no use; but the terms that do not name the removed vertex are lost in any case, and their
/// sum is the key of a stale entry.
class InnerLoop {
 public:
  InnerLoop(const VertexHull& hull, const InnerOptions& options, InnerCounts& counts);
  InnerRun run();

 private:
  void evaluate(VertexId v);
  const Integer& exact_cost(VertexId v);
  const std::vector<VertexId>& choose();
  bool is_top_tight();
  bool are_candidates_fresh();
  void keep_cheapest();
  Step record(const std::vector<VertexId>& tie);
  void remove(VertexId v);

  const VertexHull& hull_;
  const InnerOptions& options_;
  InnerCounts& counts_;
  NearVertices near_;
  HalfEdgeMesh mesh_;
  FilteredLoss loss_;
  KeyedQueue<double> queue_;
  std::vector<double> upper_;
  std::vector<bool> stale_;
  std::vector<std::vector<FilteredLoss::Term>> terms_;
  std::vector<std::optional<Integer>> exact_;  // as long as the entry is fresh
  std::vector<VertexId> candidates_;
  std::size_t left_;
};

}  // namespace convexact
