// SPDX-License-Identifier: MIT
// cluster_engines.hpp - the clusters that a clustering starts with, and the merges from there in
// several ways.
#pragma once
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

#include "convexact/cluster.hpp"

namespace convexact {

/// Two neighbouring clusters, by their lowest triangles: first < second.
using ClusterPair = std::pair<std::uint32_t, std::uint32_t>;

struct ClusterStart {
  std::vector<std::uint32_t> lowest;                      ///< By triangle: of its cluster.
  std::vector<std::pair<TriangleId, TriangleId>> united;  ///< As Clustering::united.
  std::vector<ClusterPair> pairs;                         ///< Ascending, each once.
  Rational squared_diameter, squared_limit;
  /// The square of the weight of the shape in a cost: the limit, or 2^-10 of the diameter if that
  /// is more, so that shape decides even where no concavity is allowed.
  Rational squared_weight;
};

/// A cluster for each triangle; those without area join the one over their longest edge, of equal
/// ones the lowest, until none of them can.
/// @throws Error as cluster().
[[nodiscard]] ClusterStart start_clusters(const Surface& surface, const ClusterOptions& options);

/// Each as its triangles, both ascending.
[[nodiscard]] std::vector<std::vector<TriangleId>> clusters_of(
    const std::vector<std::uint32_t>& lowest);

/// Cuts off and returns the merges from this one on.
[[nodiscard]] inline std::vector<Merge> tail_after(std::size_t count, std::vector<Merge>& merges) {
  std::vector<Merge> tail(std::make_move_iterator(merges.begin() + std::ptrdiff_t(count)),
                          std::make_move_iterator(merges.end()));
  merges.resize(count);
  return tail;
}

/// By the definitions, in exact numbers.
[[nodiscard]] Clustering cluster_exact(const Surface& surface, const ClusterOptions& options,
                                       const ClusterStart& start);

/// The same merges; exact numbers only where doubles cannot decide. Or, if the options say
/// Engine::Float, by doubles alone; then ties are not counted.
[[nodiscard]] Clustering cluster_filtered(const Surface& surface, const ClusterOptions& options,
                                          const ClusterStart& start);

}  // namespace convexact
