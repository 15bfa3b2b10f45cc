// SPDX-License-Identifier: MIT
// start.hpp - the clusters that a clustering starts with, for every engine.
#pragma once
#include <cstdint>
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

}  // namespace convexact
